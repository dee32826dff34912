// SPDX-License-Identifier: Apache-2.0
// The mark that files of this library carry near their beginning, so that a later run tells them from
// files of others. Whether they were changed since is told by checksums (SolveReport::files, file_seal.hpp).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace crossgrain {

// The mark in the form that a kind of file has for comments. A file with any of them counts as marked,
// whatever its name. The formats of other programs, such as .fra, have no comments.
inline constexpr std::string_view kXmlMark = "<!-- written by Crossgrain -->";
inline constexpr std::string_view kHtmlMark = R"(<meta name="generator" content="Crossgrain">)";
inline constexpr std::string_view kJsonMark = R"("program": "Crossgrain")";
inline constexpr std::string_view kTextMark = "# written by Crossgrain: ";

/// Keyword and text of a tEXt chunk, as a PNG file has them.
inline constexpr std::string_view kPngMark{"Software\0Crossgrain", 19};

/// The solve of a file follows its mark in the same manner: these words and the 16 characters of
/// SolveReport::solve.
inline constexpr std::string_view kXmlSolve = "<!-- solve ";
inline constexpr std::string_view kHtmlSolve = R"(<meta name="crossgrain-solve" content=")";
inline constexpr std::string_view kJsonSolve = R"("solve": ")";
inline constexpr std::string_view kTextSolve = "# solve ";
inline constexpr std::size_t kSolveBytes = 16;

/// Lines of a file of text with the mark, what the file has, and its solve unless that is empty; each begins
/// with what makes it a comment where that is more than #.
std::string text_mark(std::string_view content, const std::string& solve, std::string_view prefix = {});

/// Mark and solve end this many bytes of the beginning.
inline constexpr std::size_t kMarkedBytes = 1024;

/// Returns whether a file has a mark; false for anything but a readable regular file. Follows links.
bool has_mark(const std::filesystem::path& path);

/// Returns the solve that a file with a mark belongs to, empty if it names none. Nothing for other files.
std::optional<std::string> marked_solve(const std::filesystem::path& path);

}  // namespace crossgrain
