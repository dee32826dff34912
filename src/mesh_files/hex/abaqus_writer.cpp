// SPDX-License-Identifier: Apache-2.0
// Input files of Abaqus and CalculiX, to be included by one with materials, sections and loads. Lines have at
// most 80 columns for up to 99,999,999 nodes.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "files/file_mark.hpp"
#include "mesh_files/hex/hex_writers.hpp"
#include "text/text_lines.hpp"

namespace crossgrain {
namespace {

/// Columns of a number that both programs read; they drop what follows, exponents as well.
constexpr std::size_t kNumberColumns = 20;

constexpr std::size_t kNumbersInLine = 8;

/// Writes a number with the fewest digits that restore the same bits if they fit, else with as many as do.
char* put_in_columns(char* out, double number, char behind) {
  char* end = fmt::format_to(out, "{}", number);
  for (int digits = 16; end > out + kNumberColumns; --digits)
    end = fmt::format_to(out, "{:.{}g}", number, digits);
  *end++ = behind;
  return end;
}

/// Names are words of letters, digits and underscores.
std::string name_of(const char* kind, std::int32_t tag) {
  if (tag < 0) return fmt::format("{}_MINUS_{}", kind, -std::int64_t{tag});
  return fmt::format("{}_{}", kind, tag);
}

/// Neither program knows units; who reads the file may. A unit is any text that a caller has set.
std::string unit_comment(const std::string& unit) {
  constexpr std::size_t kMostBytes = 20;
  const bool is_word =
      !unit.empty() && unit.size() <= kMostBytes &&
      std::all_of(unit.begin(), unit.end(), [](unsigned char c) { return c > ' ' && c < 0x7f; });
  return is_word ? fmt::format("** lengths in {}\n", unit) : "";
}

/// Writes indices as numbers from 1, in lines of several.
void write_set(OutputFile& file, const std::string& keyword, const std::vector<std::uint32_t>& indices,
               const Monitor& monitor) {
  file.write(keyword + "\n");
  const auto put = [&](std::size_t line, char* out) {
    const std::size_t begin = kNumbersInLine * line;
    const std::size_t end = std::min(begin + kNumbersInLine, indices.size());
    for (std::size_t k = begin; k < end; ++k)
      out = put_integer(out, std::int64_t{indices[k]} + 1, k + 1 < end ? ',' : '\n');
    return out;
  };
  const std::size_t lines = (indices.size() + kNumbersInLine - 1) / kNumbersInLine;
  write_text_lines(file, lines, kNumbersInLine * kIntegerBytes, put, monitor);
}

/// The nodes of a group of faces, and the faces: S1 to S6 of an element are the kHexFaces, in that order.
void write_faces(OutputFile& file, const std::string& name, const HexGroup& group, const HexOutput& output,
                 const Monitor& monitor) {
  write_set(file, "*NSET, NSET=" + name, vertices_of_faces(output.mesh, group), monitor);
  file.write("*SURFACE, NAME=" + name + ", TYPE=ELEMENT\n");
  const auto put = [&](std::size_t k, char* out) {
    const BoundarySide& side = output.sides[group.members[k]];
    out = put_integer(out, std::int64_t{side.hexahedron} + 1, ',');
    *out++ = 'S';
    return put_integer(out, side.face + 1, '\n');
  };
  write_text_lines(file, group.members.size(), 2 * kIntegerBytes, put, monitor);
}

}  // namespace

void write_abaqus_hexahedra(OutputFile& file, const HexOutput& output, const Monitor& monitor) {
  const HexMesh& mesh = output.mesh;
  file.write(text_mark(output.content(), file.solve(), "** ") + unit_comment(mesh.unit) +
             "*NODE, NSET=ALL\n");
  const auto put_node = [&](std::size_t v, char* out) {
    const auto& [x, y, z] = mesh.vertices[v];
    out = put_integer(out, static_cast<std::int64_t>(v + 1), ',');
    return put_in_columns(put_in_columns(put_in_columns(out, x, ','), y, ','), z, '\n');
  };
  write_text_lines(file, mesh.vertices.size(), 3 * kNumberBytes + kIntegerBytes, put_node, monitor);
  file.write("*ELEMENT, TYPE=C3D8I, ELSET=ALL\n");
  const auto put_element = [&](std::size_t h, char* out) {
    out = put_integer(out, static_cast<std::int64_t>(h + 1), ',');
    for (std::size_t k = 0; k < 8; ++k)
      out = put_integer(out, std::int64_t{mesh.hexahedra[h][k]} + 1, k < 7 ? ',' : '\n');
    return out;
  };
  write_text_lines(file, mesh.hexahedra.size(), 9 * kIntegerBytes, put_element, monitor);
  if (!mesh.regions.empty())
    for (const HexGroup& region : output.groups.regions)
      write_set(file, "*ELSET, ELSET=" + name_of("REGION", region.tag), region.members, monitor);
  for (const HexGroup& faces : output.groups.faces) {
    if (output.groups.are_faces_untagged())
      write_faces(file, "BOUNDARY", faces, output, monitor);
    else if (faces.tag != 0)
      write_faces(file, name_of("FACE", faces.tag), faces, output, monitor);
  }
}

}  // namespace crossgrain
