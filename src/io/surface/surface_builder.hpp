// SPDX-License-Identifier: Apache-2.0
// What all surface readers share: checks of coordinates and indices, and polygons cut into triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/types.hpp"
#include "files/input_file.hpp"
#include "io/surface/polygon.hpp"

namespace crossgrain {

class SurfaceBuilder {
 public:
  /// `first_index`: the number that the format gives to the first vertex, for error messages.
  explicit SurfaceBuilder(const InputFile& file, int first_index = 0)
      : file_(&file), first_index_(first_index) {}

  /// Makes room; the caller has checked that the file is long enough to hold as many.
  void reserve(std::size_t vertices, std::size_t triangles);

  /// Throws Error(kInput) naming `place` where a coordinate is NaN or infinite.
  void add_vertex(const Vector3& position, const Place& place);

  /// Corners are numbered from 0, whatever the format does. Corners repeated one after the other count once
  /// where there are more than three; faces of fewer than three corners have no area and are passed over.
  /// Throws Error(kInput) naming `place` where a corner is out of range.
  void add_polygon(std::span<const std::int64_t> corners, const Place& place);

  std::size_t vertex_count() const { return mesh_.vertices.size(); }

  /// The surface, its vertices not yet welded. Throws Error(kInput) if it has no triangle.
  TriangleMesh finish();

 private:
  [[noreturn]] void fail_out_of_range(std::int64_t corner, const Place& place) const;

  const InputFile* file_;
  int first_index_;
  TriangleMesh mesh_;
  PolygonTriangulator triangulator_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace crossgrain
