// SPDX-License-Identifier: Apache-2.0
// What the programs that the library runs do first. Compiled into them only.
#pragma once

#include <sys/types.h>

#include <cstddef>

namespace crossgrain {

/// Exit status of a program that nobody asked for anything.
inline constexpr int kNotAsked = 2;

/// Limits the memory of this process, and makes it end when the asking process ends; at once if it has.
void serve_only(pid_t asking_process, std::size_t max_memory_bytes);

}  // namespace crossgrain
