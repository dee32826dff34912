// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace crossgrain {

/// Bytes of physical memory of the machine; 0 where the system does not tell.
std::size_t physical_memory_bytes();

/// Bytes that the process may come to hold: physical memory, or what its control group (a container's, say)
/// is limited to where that is less; 0 where the system does not tell.
std::size_t memory_limit_bytes();

/// Bytes that the process may come to hold where an option says `max_memory_bytes`: as many, or where that is
/// 0 nine tenths of memory_limit_bytes(); SIZE_MAX where the system does not tell.
std::size_t allowed_memory_bytes(std::size_t max_memory_bytes);

/// The least limit of a control group and those above it. `membership` is the text of /proc/self/cgroup,
/// `root` the folder where control groups are mounted, of version 1 or 2. 0 where there is none.
std::size_t control_group_limit_bytes(const std::string& membership, const std::filesystem::path& root);

/// Memory that the process holds now, in bytes; 0 where the system does not tell.
std::size_t current_memory_bytes();

/// The most memory that the process has held so far, in bytes; 0 where the system does not tell.
std::size_t peak_memory_bytes();

}  // namespace crossgrain
