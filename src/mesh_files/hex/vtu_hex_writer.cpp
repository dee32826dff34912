// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <vector>

#include "measure/hex_quality.hpp"
#include "mesh_files/hex/hex_arrays.hpp"
#include "mesh_files/hex/hex_writers.hpp"
#include "vtu/array_names.hpp"
#include "vtu/vtu_arrays.hpp"
#include "vtu/vtu_writer.hpp"

namespace crossgrain {
namespace {

template <class Index>
void add_hexahedra(const HexMesh& mesh, std::vector<VtuArray>& arrays) {
  arrays.push_back(value_array<Index>(VtuSection::kCells, "connectivity", 8 * mesh.hexahedra.size(),
                                      [&mesh](std::size_t i) { return mesh.hexahedra[i / 8][i % 8]; }));
  arrays.push_back(row_array<Index>(VtuSection::kFieldData, hex_arrays::kBoundary, 4, mesh.boundary.size(),
                                    [&mesh](std::size_t i) { return mesh.boundary[i].vertices; }));
  add_uniform_cells<Index>(mesh.hexahedra.size(), 8, kVtkHexahedron, arrays);
}

}  // namespace

void write_vtu_hexahedra(OutputFile& file, const HexOutput& output, const Monitor& monitor) {
  const HexMesh& mesh = output.mesh;
  const std::vector<double> shapes = scaled_jacobians(mesh);
  std::vector<VtuArray> arrays;
  arrays.push_back(stored_array(VtuSection::kCellData, "scaled_jacobian", shapes));
  if (!mesh.regions.empty())
    arrays.push_back(stored_array(VtuSection::kCellData, field_arrays::kRegion, mesh.regions));
  arrays.push_back(value_array<std::int32_t>(VtuSection::kFieldData, hex_arrays::kBoundaryTag,
                                             mesh.boundary.size(),
                                             [&mesh](std::size_t i) { return mesh.boundary[i].tag; }));
  if (mesh.is_partial)
    arrays.push_back(value_array<std::uint8_t>(VtuSection::kFieldData, hex_arrays::kPartial, 1,
                                               [](std::size_t) { return std::uint8_t{1}; }));
  arrays.push_back(points_array(mesh.vertices.size(), [&mesh](std::size_t i) { return mesh.vertices[i]; }));
  if (fits_32_bits(mesh.vertices.size(), 8 * mesh.hexahedra.size()))
    add_hexahedra<std::int32_t>(mesh, arrays);
  else
    add_hexahedra<std::int64_t>(mesh, arrays);
  watch(arrays, monitor);
  write_vtu(file, mesh.vertices.size(), mesh.hexahedra.size(), arrays);
}

}  // namespace crossgrain
