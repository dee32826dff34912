// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace crossgrain {

/// Physical memory of the machine in bytes; 0 if the system does not tell.
std::size_t physical_memory_bytes();

/// The limit of the address space of this process and those it starts (`ulimit -v`), in bytes; 0 without one.
std::size_t address_space_limit_bytes();

/// Memory that the process may use, in bytes: the least of physical memory, the limit of its control group
/// (for instance of a container) and that of its address space; 0 if the system does not tell.
std::size_t memory_limit_bytes();

/// Memory that the process may use under the option `max_memory_bytes`: its value, or nine tenths of
/// memory_limit_bytes() if it is 0. SIZE_MAX if the system does not tell.
std::size_t allowed_memory_bytes(std::size_t max_memory_bytes);

/// Least limit of a control group and its ancestors, in bytes; 0 if there is none. `membership` is the text
/// of /proc/self/cgroup, `root` the folder where control groups (version 1 or 2) are mounted.
std::size_t control_group_limit_bytes(const std::string& membership, const std::filesystem::path& root);

/// Memory that the process uses now, in bytes; 0 if the system does not tell.
std::size_t current_memory_bytes();

/// Peak memory of the process so far, in bytes; 0 if the system does not tell.
std::size_t peak_memory_bytes();

}  // namespace crossgrain
