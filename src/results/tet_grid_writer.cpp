// SPDX-License-Identifier: Apache-2.0
// Writes onto.vtu, the tets, and onto_features.vtu, the tagged edges and triangles.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "results/axes_behind_faces.hpp"
#include "results/tet_writers.hpp"
#include "vtu/array_names.hpp"
#include "vtu/vtu_arrays.hpp"
#include "vtu/vtu_writer.hpp"

namespace crossgrain {
namespace {

/// All vertices of the mesh in its order, used or not, so that they keep the numbers of its file.
void add_points(const TetMesh& mesh, std::vector<VtuArray>& arrays) {
  arrays.push_back(points_array(mesh.vertices.size(), [&mesh](std::size_t i) { return mesh.vertices[i]; }));
}

template <class Index>
void add_tets(const TetMesh& mesh, std::vector<VtuArray>& arrays) {
  arrays.push_back(value_array<Index>(VtuSection::kCells, "connectivity", 4 * mesh.tets.size(),
                                      [&mesh](std::size_t i) { return mesh.tets[i / 4][i % 4]; }));
  add_uniform_cells<Index>(mesh.tets.size(), 4, kVtkTet, arrays);
}

/// Adds what a repaired field is read from: exact frames, and its matchings.
void add_repair(const TetOutput& output, std::vector<VtuArray>& arrays) {
  const std::vector<Quaternion>& frames = output.field.tet_frames;
  const auto parts = [&frames](std::size_t t) {
    return std::array{frames[t].w, frames[t].x, frames[t].y, frames[t].z};
  };
  arrays.push_back(row_array<double>(VtuSection::kCellData, field_arrays::kTetFrame, 4, frames.size(), parts,
                                     VtuPacking::kAlways));
  arrays.push_back(row_array<std::int8_t>(
      VtuSection::kCellData, field_arrays::kMatching, 12, frames.size(),
      [axes = axes_behind_faces(output.solid, output.field.matchings)](std::size_t t) { return axes[t]; }));
}

/// The tagged edges and then the tagged triangles of a mesh, as cells with tags.
struct Features {
  explicit Features(const TetMesh& mesh) {
    for (const auto& [vertices, tag, stated] : mesh.feature_edges)
      add(vertices.data(), vertices.size(), kVtkLine, tag, stated);
    for (const auto& [vertices, tag] : mesh.feature_faces)
      add(vertices.data(), vertices.size(), kVtkTriangle, tag, true);
  }

  void add(const std::uint32_t* vertices, std::size_t count, std::uint8_t type, std::int32_t tag,
           bool stated) {
    corners.insert(corners.end(), vertices, vertices + count);
    ends.push_back(static_cast<std::int64_t>(corners.size()));
    types.push_back(type);
    tags.push_back(tag);
    is_stated.push_back(stated);
  }

  std::vector<std::int64_t> corners, ends;
  std::vector<std::uint8_t> types, is_stated;
  std::vector<std::int32_t> tags;
};

}  // namespace

void write_tet_grid(OutputFile& file, const TetOutput& output, const Monitor& monitor) {
  const TetMesh& mesh = output.solid.mesh;
  const TetField& field = output.field;
  std::vector<VtuArray> arrays;
  add_axes(
      VtuSection::kPointData, field.vertex_frames.size(),
      [&field](std::size_t i) { return field.vertex_frames[i]; }, arrays);
  add_axes(
      VtuSection::kCellData, field.tet_frames.size(), [&field](std::size_t i) { return field.tet_frames[i]; },
      arrays);
  if (field.is_repaired()) add_repair(output, arrays);
  if (!mesh.regions.empty())
    arrays.push_back(stored_array(VtuSection::kCellData, field_arrays::kRegion, mesh.regions));
  add_points(mesh, arrays);
  if (fits_32_bits(mesh.vertices.size(), 4 * mesh.tets.size()))
    add_tets<std::int32_t>(mesh, arrays);
  else
    add_tets<std::int64_t>(mesh, arrays);
  watch(arrays, monitor);
  write_vtu(file, mesh.vertices.size(), mesh.tets.size(), arrays);
  file.finish();
}

void write_feature_grid(OutputFile& file, const TetOutput& output, const Monitor& monitor) {
  const TetMesh& mesh = output.solid.mesh;
  const Features features(mesh);
  std::vector<VtuArray> arrays;
  arrays.push_back(stored_array(VtuSection::kCellData, "tag", features.tags));
  arrays.push_back(stored_array(VtuSection::kCellData, "is_stated", features.is_stated));
  add_points(mesh, arrays);
  arrays.push_back(stored_array(VtuSection::kCells, "connectivity", features.corners));
  arrays.push_back(stored_array(VtuSection::kCells, "offsets", features.ends));
  arrays.push_back(stored_array(VtuSection::kCells, "types", features.types));
  watch(arrays, monitor);
  write_vtu(file, mesh.vertices.size(), features.types.size(), arrays);
  file.finish();
}

}  // namespace crossgrain
