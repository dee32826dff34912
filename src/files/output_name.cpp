// SPDX-License-Identifier: Apache-2.0
#include "files/output_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "base/ignoring_case.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain {

bool has_extension(const std::filesystem::path& path, std::string_view extension) {
  return equals_ignoring_case(path.extension().string(), extension);
}

void refuse_name(const std::filesystem::path& path, std::string_view what,
                 std::span<const std::string_view> extensions) {
  std::string list;
  for (std::size_t i = 0; i < extensions.size(); ++i)
    list += fmt::format("{}{}", i == 0 ? "" : i + 1 < extensions.size() ? ", " : " or ", extensions[i]);
  throw Error(
      ErrorKind::kUsage,
      {path.string(), "", fmt::format("is no name of {} that can be written; let it end in {}", what, list)});
}

void check_extension(const std::filesystem::path& path, std::string_view what,
                     std::span<const std::string_view> extensions) {
  const auto is_named = [&path](std::string_view extension) { return has_extension(path, extension); };
  if (path.has_extension() && std::ranges::none_of(extensions, is_named)) refuse_name(path, what, extensions);
}

}  // namespace crossgrain
