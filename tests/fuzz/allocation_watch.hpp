// SPDX-License-Identifier: Apache-2.0
// The largest allocation that a test makes. The program that links allocation_watch.cpp has an operator new
// that remembers.
#pragma once

#include <cstddef>

namespace crossgrain {

void forget_allocations();

/// Bytes, of all threads, since the last call of `forget_allocations`.
std::size_t largest_allocation();

}  // namespace crossgrain
