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
  arrays.push_back(vtu_array<Index>(VtuSection::kCells, "connectivity", 1, 8 * mesh.hexahedra.size(),
                                    [&mesh](std::size_t begin, std::size_t end, Index* out) {
                                      for (std::size_t i = begin; i < end; ++i)
                                        *out++ = static_cast<Index>(mesh.hexahedra[i / 8][i % 8]);
                                    }));
  arrays.push_back(vtu_array<Index>(VtuSection::kFieldData, hex_arrays::kBoundary, 4, mesh.boundary.size(),
                                    [&mesh](std::size_t begin, std::size_t end, Index* out) {
                                      for (std::size_t i = begin; i < end; ++i)
                                        for (const std::uint32_t vertex : mesh.boundary[i].vertices)
                                          *out++ = static_cast<Index>(vertex);
                                    }));
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
  arrays.push_back(vtu_array<std::int32_t>(VtuSection::kFieldData, hex_arrays::kBoundaryTag, 1,
                                           mesh.boundary.size(),
                                           [&mesh](std::size_t begin, std::size_t end, std::int32_t* out) {
                                             for (std::size_t i = begin; i < end; ++i)
                                               *out++ = mesh.boundary[i].tag;
                                           }));
  arrays.push_back(points_array(mesh.vertices.size(), [&mesh](std::size_t i) { return mesh.vertices[i]; }));
  if (fits_32_bits(mesh.vertices.size(), 8 * mesh.hexahedra.size()))
    add_hexahedra<std::int32_t>(mesh, arrays);
  else
    add_hexahedra<std::int64_t>(mesh, arrays);
  watch(arrays, monitor);
  write_vtu(file, mesh.vertices.size(), mesh.hexahedra.size(), arrays);
}

}  // namespace crossgrain
