// SPDX-License-Identifier: Apache-2.0
// Writes hexahedra in the format that the name of the file says.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "crossgrain/error.hpp"
#include "crossgrain/writing.hpp"
#include "measure/hex_validity.hpp"
#include "mesh_files/hex/hex_writers.hpp"
#include "mesh_files/mesh_formats.hpp"

namespace crossgrain {
namespace {

template <class Elements, class CornersOf>
void check_corners(const HexMesh& mesh, const Elements& elements, const char* what,
                   const CornersOf& corners_of) {
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const auto& corners = corners_of(elements[k]);
    if (*std::max_element(corners.begin(), corners.end()) >= mesh.vertices.size())
      throw Error(ErrorKind::kUsage, {"", what + (" " + std::to_string(k)) + " (counted from 0)",
                                      "has a corner that is no vertex of the mesh"});
  }
}

const HexMesh& checked(const HexMesh& mesh) {
  check_corners(
      mesh, mesh.hexahedra, "hexahedron", [](const auto& hexahedron) -> const auto& { return hexahedron; });
  check_corners(
      mesh, mesh.boundary, "boundary face", [](const auto& face) -> const auto& { return face.vertices; });
  if (!mesh.regions.empty() && mesh.regions.size() != mesh.hexahedra.size())
    throw Error(ErrorKind::kUsage, "a mesh of hexahedra must have a region for each of them, or none");
  return mesh;
}

constexpr std::array kHexFormats{MeshFormat<HexOutput>{".vtu", write_vtu_hexahedra},
                                 MeshFormat<HexOutput>{".mesh", write_medit_hexahedra},
                                 MeshFormat<HexOutput>{".msh", write_gmsh_hexahedra},
                                 MeshFormat<HexOutput>{".inp", write_abaqus_hexahedra}};

const MeshFormat<HexOutput>& hex_format_of(const std::filesystem::path& path) {
  return format_of<HexOutput>(path, kHexFormats, "a hexahedral mesh");
}

/// Whether files of a format are looked at, and not computed with.
bool is_for_display(const MeshFormat<HexOutput>& format) {
  return format.extension == ".vtu";
}

std::optional<std::size_t> first_inverted(const HexMesh& mesh) {
  const std::vector<std::uint8_t> is_inverted = inverted_hexahedra(mesh);
  const auto first = std::ranges::find(is_inverted, 1);
  if (first == is_inverted.end()) return std::nullopt;
  return static_cast<std::size_t>(first - is_inverted.begin());
}

}  // namespace

HexOutput::HexOutput(const HexMesh& shown)
    : mesh(checked(shown)),
      has_inverted(first_inverted(shown).has_value()),
      sides(sides_of_boundary(shown)),
      groups(groups_of(shown)) {}

HexFilesOf hex_files_of(const HexMesh& mesh, InvertedHexahedra inverted) {
  return {mesh.is_partial, inverted == InvertedHexahedra::kRefused && first_inverted(mesh),
          mesh.hexahedra.empty()};
}

std::vector<std::string> hexahedra_file_names(HexFilesOf which) {
  std::vector<std::string> names;
  if (which.is_empty) return names;
  for (const MeshFormat<HexOutput>& format : kHexFormats)
    if (!which.for_display_only || is_for_display(format))
      names.push_back((which.is_partial ? "hexahedra.partial" : "hexahedra") + std::string(format.extension));
  return names;
}

std::vector<std::string> all_hexahedra_file_names() {
  std::vector<std::string> names = hexahedra_file_names({});
  for (std::string& name : hexahedra_file_names({.is_partial = true})) names.push_back(std::move(name));
  return names;
}

void write_hexahedra_file(OutputFile& file, const HexOutput& output, const Monitor& monitor) {
  hex_format_of(file.name()).write(file, output, monitor);
}

void write_hexahedra(const HexMesh& mesh, const std::filesystem::path& path, const Monitor& monitor,
                     InvertedHexahedra inverted) {
  const MeshFormat<HexOutput>& format = hex_format_of(path);
  const HexOutput output(mesh);
  if (inverted == InvertedHexahedra::kRefused && !is_for_display(format)) {
    if (const auto first = first_inverted(mesh))
      throw Error(ErrorKind::kUsage,
                  {path.string(), fmt::format("hexahedron {}", *first + 1),
                   "is inverted, and a solver would not say so; write .vtu, which is for display, or "
                   "allow inverted hexahedra"});
  }
  write_mesh(format, output, path, monitor);
}

void check_hexahedra_path(const std::filesystem::path& path) {
  hex_format_of(path);
  OutputFile{path};
}

}  // namespace crossgrain
