// SPDX-License-Identifier: Apache-2.0
// The mark that files of this library carry near their beginning, so that a later run knows them as its own
// and refuses to replace others (OutputOptions::foreign_files).
#pragma once

#include <filesystem>
#include <string_view>

namespace crossgrain {

// The mark in the form that a kind of file has for comments. A file with any of them counts as marked,
// whatever its name. The formats of other programs, such as .fra, have no comments; the report lists those
// files with their checksums (SolveReport::unmarked_files).
inline constexpr std::string_view kXmlMark = "<!-- written by Crossgrain -->";
inline constexpr std::string_view kHtmlMark = R"(<meta name="generator" content="Crossgrain">)";
inline constexpr std::string_view kJsonMark = R"("program": "Crossgrain")";
inline constexpr std::string_view kTextMark = "# written by Crossgrain: ";

/// Keyword and text of a tEXt chunk, as a PNG file has them.
inline constexpr std::string_view kPngMark{"Software\0Crossgrain", 19};

/// A mark ends within this many bytes of the beginning.
inline constexpr std::size_t kMarkedBytes = 1024;

/// Returns whether a file has a mark; false for anything but a readable regular file. Follows links.
bool has_mark(const std::filesystem::path& path);

}  // namespace crossgrain
