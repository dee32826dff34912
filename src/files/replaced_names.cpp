// SPDX-License-Identifier: Apache-2.0
#include "files/replaced_names.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include "files/folder_calls.hpp"
#include "files/output_file.hpp"

namespace crossgrain {
namespace {

/// Ends a name, as no name contains it.
constexpr char kEnd = '\0';

}  // namespace

void write_replaced_names(int folder, const std::vector<std::string>& names, const std::string& shown) {
  remove_replaced_names(folder);
  OutputFile list(folder, kReplacedNames, shown);
  for (const std::string& name : names) list.write(name + kEnd);
  list.finish();
}

std::vector<std::string> read_replaced_names(int folder, const std::string& shown) {
  const Descriptor list(::openat(folder, kReplacedNames, O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
  if (!list.is_open() && errno == ENOENT) return {};
  if (!list.is_open()) fail_output(shown, "put in place", errno);
  std::string bytes;
  std::array<char, 4096> block;
  for (ssize_t got; (got = ::read(list.number(), block.data(), block.size())) != 0;) {
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_output(shown, "put in place", errno);
    bytes.append(block.data(), static_cast<std::size_t>(got));
  }
  std::vector<std::string> names;
  for (std::size_t begin = 0, end; (end = bytes.find(kEnd, begin)) != std::string::npos; begin = end + 1) {
    std::string name = bytes.substr(begin, end - begin);
    // The folder may come from a stranger.
    if (name.find('/') == std::string::npos) names.push_back(std::move(name));
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool has_replaced_names(int folder, const std::string& shown) {
  const mode_t mode = status_in(folder, kReplacedNames).st_mode;
  if (mode == 0 && errno != ENOENT) fail_output(shown, "read", errno);
  return S_ISREG(mode);
}

void remove_replaced_names(int folder) noexcept {
  ::unlinkat(folder, kReplacedNames, 0);
}

}  // namespace crossgrain
