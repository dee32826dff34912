// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <span>
#include <string>

namespace crossgrain {

/// One of `seeds` with one to four damages done to it: bytes changed, removed, repeated or put in, its end
/// cut off or taken from another seed, numbers of text or bytes replaced by those that readers trip over. The
/// same on every machine for the same state of `random`.
std::string mutated(std::span<const std::string> seeds, std::mt19937& random);

}  // namespace crossgrain
