// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "crossgrain/message.hpp"

namespace crossgrain {

/// Throws Error(kLimit) if `more_bytes`, with what the process uses already, exceed the limit of memory of
/// this thread's loops (WatchedLoops), by default nine tenths of the machine. `what` takes them, in the
/// singular, such as "reading it" or "a map of 3000 tets"; `file` is what it is about, or empty. Small
/// amounts are not checked, because that takes a query of the system.
void require_memory(double more_bytes, const std::string& what, Remedy remedy, const std::string& file = "");

/// Whether require_memory would find as much.
bool has_memory_for(double more_bytes);

/// Of the programs of helpers with their libraries, which no limit of their data counts: resident memory less
/// data is 49 MB for gmsh 4.8, 31 MB for the reader of CAD files; and a little to begin with.
inline constexpr std::size_t kHelperProgramBytes = 60'000'000;

/// Returns the memory that the data of a helper process may take under the option `max_memory_bytes`: what is
/// allowed, less what this process uses and what the helper's program takes itself. Throws Error(kLimit) if
/// nothing is left to do `what`, such as "to read it".
std::size_t memory_for_helper(std::size_t max_memory_bytes, const std::string& what,
                              const std::string& file = "");

}  // namespace crossgrain
