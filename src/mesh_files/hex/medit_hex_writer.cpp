// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/hex/hex_writers.hpp"
#include "mesh_files/medit_sections.hpp"

namespace crossgrain {

void write_medit_hexahedra(OutputFile& file, const HexOutput& output, const Monitor& monitor) {
  const HexMesh& mesh = output.mesh;
  begin_medit(file, output.content(), mesh.vertices, monitor);
  if (!mesh.boundary.empty())
    write_medit_elements(
        file, "Quadrilaterals", mesh.boundary.size(),
        [&](std::size_t k) { return mesh.boundary[k].vertices; },
        [&](std::size_t k) { return mesh.boundary[k].tag; }, monitor);
  write_medit_elements(
      file, "Hexahedra", mesh.hexahedra.size(), [&](std::size_t k) { return mesh.hexahedra[k]; },
      [&](std::size_t k) { return mesh.regions.empty() ? 0 : mesh.regions[k]; }, monitor);
  file.write(kMeditEnd);
}

}  // namespace crossgrain
