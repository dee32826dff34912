// SPDX-License-Identifier: Apache-2.0
// Parts of the scene of a page (viewer/README.md) that a field on a grid and one on tets have alike.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/quaternion.hpp"
#include "base/vector3.hpp"
#include "display/shown_field.hpp"
#include "field/solved_surface.hpp"
#include "page/drawn_surface.hpp"
#include "page/scene_writer.hpp"

namespace crossgrain {

/// Polylines as two arrays: points, and the start of each line.
class Polylines {
 public:
  explicit Polylines(const Vector3& origin) : origin_(origin) {}

  void add_point(const Vector3& point);
  void end_line() { starts_.push_back(static_cast<std::uint32_t>(points_.size() / 3)); }
  void add(const std::vector<Vector3>& line);
  void write(SceneWriter& scene, const std::string& points, const std::string& starts) const;

 private:
  Vector3 origin_;
  std::vector<float> points_;
  std::vector<std::uint32_t> starts_{0};
};

template <class T, class Items, class ValueOf>
std::vector<T> column(const Items& items, const ValueOf& value_of) {
  std::vector<T> values;
  values.reserve(items.size());
  for (const auto& item : items) values.push_back(static_cast<T>(value_of(item)));
  return values;
}

/// Appends a unit quaternion as four integers of sixteen bits.
void add_quaternion(const Quaternion& q, std::vector<std::int16_t>& frames);

/// Adds the arrays surface_*, those of faces between solids (interface_*) and, in the header, how many of the
/// triangles are there, each with the prefix. The triangles are those of `outside`, which is the surface
/// itself or has fewer.
DrawnSurface add_surface(const SolvedSurface& surface, const SolvedSurface& outside, const Vector3& origin,
                         const std::string& prefix, std::size_t most_triangles, SceneWriter& scene);

/// Adds the arrays arc_*, node_* and mark_*, each with the prefix.
void add_singularities(const ShownField& field, const Vector3& origin, const std::string& prefix,
                       SceneWriter& scene);

/// Cells of a scene, without overlap.
struct SceneCells {
  Vector3 low{};    ///< of the lattice
  double unit = 1;  ///< side of a lattice cube
  std::vector<std::uint16_t> corners;
  std::vector<std::uint16_t> sizes;
  std::vector<std::int16_t> frames;
  std::vector<std::uint16_t> energy_density, alignment_deg;  ///< as by to_bfloat16
  std::vector<std::uint8_t> classes;
  std::vector<std::int32_t> regions;  ///< empty if there is only one

  std::size_t size() const { return sizes.size(); }

  /// Adds the arrays cell_* and the part "cells" of the header.
  void write(std::size_t total, const Vector3& origin, SceneWriter& scene) const;
};

/// Adds the region of each item as its place among the regions of `all`, and these numbers to the header
/// under `numbers`; nothing for fewer than two of them.
void add_regions(const std::vector<std::int32_t>& regions, const std::vector<std::int32_t>& all,
                 const char* array, const char* numbers, SceneWriter& scene);

}  // namespace crossgrain
