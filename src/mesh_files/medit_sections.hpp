// SPDX-License-Identifier: Apache-2.0
// Sections of Medit meshes in text that other programs and this library read.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string_view>
#include <vector>

#include "crossgrain/monitor.hpp"
#include "crossgrain/types.hpp"
#include "files/file_mark.hpp"
#include "files/output_file.hpp"
#include "text/text_lines.hpp"

namespace crossgrain {

/// Writes the header, with the mark and a comment on the content, and the vertices.
inline void begin_medit(OutputFile& file, std::string_view content, const std::vector<Vector3>& vertices,
                        const Monitor& monitor) {
  file.write(fmt::format("MeshVersionFormatted 2\n{}\nDimension 3\n\nVertices\n{}\n",
                         text_mark(content, file.solve()), vertices.size()));
  const auto put = [&](std::size_t v, char* out) {
    for (const double coordinate : vertices[v]) out = put_shortest(out, coordinate, ' ');
    return put_integer(out, 0, '\n');
  };
  write_text_lines(file, vertices.size(), 3 * kNumberBytes + kIntegerBytes, put, monitor);
}

/// Writes a section of elements: corners_of(k), an array of indices, and tag_of(k) for each k below `count`.
template <class CornersOf, class TagOf>
void write_medit_elements(OutputFile& file, std::string_view keyword, std::size_t count,
                          const CornersOf& corners_of, const TagOf& tag_of, const Monitor& monitor) {
  file.write(fmt::format("\n{}\n{}\n", keyword, count));
  constexpr std::size_t kMostCorners = 8;
  const auto put = [&](std::size_t k, char* out) {
    for (const std::uint32_t corner : corners_of(k)) out = put_integer(out, std::int64_t{corner} + 1, ' ');
    return put_integer(out, tag_of(k), '\n');
  };
  write_text_lines(file, count, (kMostCorners + 1) * kIntegerBytes, put, monitor);
}

inline constexpr std::string_view kMeditEnd = "\nEnd\n";

}  // namespace crossgrain
