// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace crossgrain {

/// Throws Error(kLimit) if reading a file takes more memory than allowed_memory_bytes, including what the
/// process uses already. Reading is assumed to take `times` the size of the file.
void check_read_memory(const std::string& name, std::size_t file_bytes, double times,
                       std::size_t max_memory_bytes);

}  // namespace crossgrain
