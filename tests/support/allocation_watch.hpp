// SPDX-License-Identifier: Apache-2.0
// The allocations of a test: the program that compiles allocation_watch.cpp has an operator new that
// remembers them, and lets one fail.
#pragma once

#include <cstddef>

namespace crossgrain {

/// Counts from here on, and fails the allocation of this number with std::bad_alloc; none if it is negative.
void watch_allocations(long failing = -1);

/// Number of allocations, and bytes of the largest, of all threads since then.
long allocation_count();
std::size_t largest_allocation();

}  // namespace crossgrain
