// SPDX-License-Identifier: Apache-2.0
// Files are written in the format that their name says, and in no other.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace crossgrain {

/// Returns whether a name ends with an extension such as ".png", in either case.
bool has_extension(const std::filesystem::path& path, std::string_view extension);

/// Throws Error(kUsage): "lines.csv: is no name of streamlines that can be written; let it end in .vtu or
/// .obj".
[[noreturn]] void refuse_name(const std::filesystem::path& path, std::string_view what,
                              std::span<const std::string_view> extensions);

/// Throws so for a name with another extension. One without any is fine: it says nothing of a format.
void check_extension(const std::filesystem::path& path, std::string_view what,
                     std::span<const std::string_view> extensions);

}  // namespace crossgrain
