// SPDX-License-Identifier: Apache-2.0
// Common parts of all surface readers: checks of coordinates and indices, and triangulation of polygons.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "crossgrain/types.hpp"
#include "files/input_file.hpp"
#include "mesh_files/surface/polygon.hpp"

namespace crossgrain {

class SurfaceBuilder {
 public:
  /// `first_index` is the format's number of the first vertex, for error messages.
  explicit SurfaceBuilder(const InputFile& file, int first_index = 0)
      : file_(&file), first_index_(first_index) {}

  /// Reserves memory; the caller must have checked that the file is long enough.
  void reserve(std::size_t vertices, std::size_t triangles);

  /// Throws Error(kInput) naming `place` if a coordinate is NaN or infinite.
  void add_vertex(const Vector3& position, const Place& place);

  /// Adds a polygon of 0-based corners. With more than three corners, consecutive repeated ones count once;
  /// faces of fewer than three corners have no area and are skipped. Throws Error(kInput) naming `place` if a
  /// corner is out of range.
  void add_polygon(std::span<const std::int64_t> corners, const Place& place);

  std::size_t vertex_count() const { return mesh_.vertices.size(); }

  /// Returns the surface with unwelded vertices. Throws Error(kInput) if it has no triangle.
  TriangleMesh finish();

 private:
  [[noreturn]] void fail_out_of_range(std::int64_t corner, const Place& place) const;

  const InputFile* file_;
  int first_index_;
  Checkpoint checkpoint_;
  TriangleMesh mesh_;
  PolygonTriangulator triangulator_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace crossgrain
