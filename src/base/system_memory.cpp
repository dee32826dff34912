// SPDX-License-Identifier: Apache-2.0
#include "base/system_memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>

namespace crossgrain {
namespace {

/// Returns a number of KiB from /proc/self/status in bytes; 0 if the key is missing.
std::size_t status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    std::size_t kib = 0;
    if (line.starts_with(key) && std::sscanf(line.c_str() + key.size(), ": %zu kB", &kib) == 1)
      return 1024 * kib;
  }
  return 0;
}

/// Returns the number in a file; 0 if it holds none, such as "max".
std::size_t number_in(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::size_t number = 0;
  return file >> number ? number : 0;
}

std::size_t smaller_of_known(std::size_t a, std::size_t b) {
  return a == 0 || b == 0 ? std::max(a, b) : std::min(a, b);
}

/// Returns the least limit of a group and its ancestors. In a container, which sees its own group as the
/// root, the path may not exist; then only the root's limit counts.
std::size_t least_limit(const std::filesystem::path& root, std::filesystem::path group, const char* name) {
  group = group.relative_path();
  std::size_t limit = number_in(root / name);
  for (; !group.empty(); group = group.parent_path())
    limit = smaller_of_known(limit, number_in(root / group / name));
  return limit;
}

/// Returns whether a comma-separated list contains `name`.
bool is_listed(const std::string& names, const std::string& name) {
  return ("," + names + ",").find("," + name + ",") != std::string::npos;
}

}  // namespace

std::size_t physical_memory_bytes() {
  const long pages = sysconf(_SC_PHYS_PAGES), page_size = sysconf(_SC_PAGE_SIZE);
  return pages > 0 && page_size > 0 ? static_cast<std::size_t>(pages) * static_cast<std::size_t>(page_size)
                                    : 0;
}

std::size_t control_group_limit_bytes(const std::string& membership, const std::filesystem::path& root) {
  std::size_t limit = 0;
  std::istringstream lines(membership);
  // HIERARCHY:CONTROLLERS:PATH; version 2 lists no controllers.
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1),
                      group = line.substr(second + 1);
    if (controllers.empty())
      limit = smaller_of_known(limit, least_limit(root, group, "memory.max"));
    else if (is_listed(controllers, "memory"))
      limit = smaller_of_known(limit, least_limit(root / "memory", group, "memory.limit_in_bytes"));
  }
  return limit;
}

std::size_t address_space_limit_bytes() {
  rlimit limit{};
  return ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY ? limit.rlim_cur : 0;
}

std::size_t memory_limit_bytes() {
  std::ifstream file("/proc/self/cgroup");
  const std::string membership{std::istreambuf_iterator<char>(file), {}};
  const std::size_t there =
      smaller_of_known(physical_memory_bytes(), control_group_limit_bytes(membership, "/sys/fs/cgroup"));
  return smaller_of_known(there, address_space_limit_bytes());
}

std::size_t allowed_memory_bytes(std::size_t max_memory_bytes) {
  // The rest is left for other processes.
  constexpr double kShare = 0.9;
  if (max_memory_bytes > 0) return max_memory_bytes;
  const std::size_t there = memory_limit_bytes();
  return there > 0 ? static_cast<std::size_t>(kShare * static_cast<double>(there)) : SIZE_MAX;
}

std::size_t current_memory_bytes() {
  return status_bytes("VmRSS");
}

std::size_t peak_memory_bytes() {
  // getrusage is not used: its peak includes that of the parent process.
  return status_bytes("VmHWM");
}

}  // namespace crossgrain
