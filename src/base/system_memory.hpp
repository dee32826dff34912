// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace crossgrain {

/// Bytes of physical memory of the machine; 0 where the system does not tell.
std::size_t physical_memory_bytes();

/// The most memory that the process has held so far, in bytes; 0 where the system does not tell.
std::size_t peak_memory_bytes();

}  // namespace crossgrain
