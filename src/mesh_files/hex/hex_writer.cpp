// SPDX-License-Identifier: Apache-2.0
// Writes hexahedra in the format that the name of the file says.
#include <algorithm>
#include <array>
#include <string>

#include "crossgrain/error.hpp"
#include "crossgrain/writing.hpp"
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

}  // namespace

HexOutput::HexOutput(const HexMesh& shown)
    : mesh(checked(shown)), sides(sides_of_boundary(shown)), groups(groups_of(shown)) {}

std::vector<std::string> hexahedra_file_names() {
  std::vector<std::string> names;
  for (const MeshFormat<HexOutput>& format : kHexFormats)
    names.push_back("hexahedra" + std::string(format.extension));
  return names;
}

void write_hexahedra_file(OutputFile& file, const HexOutput& output, const Monitor& monitor) {
  hex_format_of(file.name()).write(file, output, monitor);
}

void write_hexahedra(const HexMesh& mesh, const std::filesystem::path& path, const Monitor& monitor) {
  const MeshFormat<HexOutput>& format = hex_format_of(path);
  write_mesh(format, HexOutput(mesh), path, monitor);
}

void check_hexahedra_path(const std::filesystem::path& path) {
  hex_format_of(path);
  OutputFile{path};
}

}  // namespace crossgrain
