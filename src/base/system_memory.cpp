// SPDX-License-Identifier: Apache-2.0
#include "base/system_memory.hpp"

#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>

namespace crossgrain {

std::size_t physical_memory_bytes() {
  const long pages = sysconf(_SC_PHYS_PAGES), page_size = sysconf(_SC_PAGE_SIZE);
  return pages > 0 && page_size > 0 ? static_cast<std::size_t>(pages) * static_cast<std::size_t>(page_size)
                                    : 0;
}

std::size_t peak_memory_bytes() {
  // Not getrusage: its peak is no less than that of the program which started this one.
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    std::size_t kib = 0;
    if (std::sscanf(line.c_str(), "VmHWM: %zu kB", &kib) == 1) return 1024 * kib;
  }
  return 0;
}

}  // namespace crossgrain
