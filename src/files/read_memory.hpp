// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace crossgrain {

/// What a process may come to hold where `max_memory_bytes` says 0: nine tenths of what the machine or the
/// container has; SIZE_MAX where the system does not tell.
std::size_t allowed_memory_bytes(std::size_t max_memory_bytes);

/// Throws Error(kLimit) where reading a file takes more memory than is allowed, what the process holds
/// already counted in: `times` the size of the file.
void check_read_memory(const std::string& name, std::size_t file_bytes, double times,
                       std::size_t max_memory_bytes);

}  // namespace crossgrain
