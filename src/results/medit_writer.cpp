// SPDX-License-Identifier: Apache-2.0
// Medit meshes in text, with nothing but what programs need that read frames beside them:
//
//   MeshVersionFormatted 2
//   Dimension 3
//   Vertices
//   count
//   x y z 0
//   Tetrahedra
//   count
//   a b c d region      vertices count from 1; positive volume
//   End
#include <fmt/format.h>

#include "results/tet_writers.hpp"
#include "text/text_lines.hpp"

namespace crossgrain {

void write_medit(OutputFile& file, const TetOutput& output, const Monitor& monitor) {
  const TetMesh& mesh = output.solid.mesh;
  file.write(fmt::format("MeshVersionFormatted 2\nDimension 3\nVertices\n{}\n", mesh.vertices.size()));
  const auto put_vertex = [&](std::size_t v, char* out) {
    for (const double coordinate : mesh.vertices[v]) out = put_number(out, coordinate, ' ');
    return put_integer(out, 0, '\n');
  };
  write_text_lines(file, mesh.vertices.size(), 3 * kNumberBytes + kIntegerBytes, put_vertex, monitor);
  file.write(fmt::format("Tetrahedra\n{}\n", mesh.tets.size()));
  const auto put_tet = [&](std::size_t t, char* out) {
    for (const std::uint32_t vertex : mesh.tets[t]) out = put_integer(out, std::int64_t{vertex} + 1, ' ');
    return put_integer(out, mesh.regions.empty() ? 0 : mesh.regions[t], '\n');
  };
  write_text_lines(file, mesh.tets.size(), 5 * kIntegerBytes, put_tet, monitor);
  file.write("End\n");
  file.finish();
}

}  // namespace crossgrain
