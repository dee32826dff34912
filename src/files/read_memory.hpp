// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace crossgrain {

/// Throws Error(kLimit) where reading a file takes more memory than is allowed (allowed_memory_bytes),
/// what the process holds already counted in: `times` the size of the file.
void check_read_memory(const std::string& name, std::size_t file_bytes, double times,
                       std::size_t max_memory_bytes);

}  // namespace crossgrain
