// SPDX-License-Identifier: Apache-2.0
// The faces of the model that meet at a vertex or an edge of its surface: what a designer can change.
#pragma once

#include <cstdint>
#include <vector>

#include "singularity/solid_creases.hpp"

namespace crossgrain {

/// What meets at a vertex.
struct CornerFaces {
  std::vector<std::int32_t> faces;  ///< in cyclic order, from the narrowest part on; empty without numbers
  double narrowest_deg = 360;       ///< angle of the narrowest part of the surface between two sharp edges
};

/// Finds faces at vertices. The surface must outlive it.
class SurfaceFans {
 public:
  explicit SurfaceFans(const SolidSurface& surface);

  /// Returns what meets at a vertex; nothing if its triangles are not one closed fan.
  CornerFaces at(std::uint32_t vertex) const;

  /// Returns the numbers of the faces on both sides of an edge: one if they are the same.
  std::vector<std::int32_t> beside(const SolidCrease::Edge& edge) const;

 private:
  std::vector<std::uint32_t> fan_of(std::uint32_t vertex) const;
  double angle_at(std::uint32_t triangle, std::uint32_t vertex) const;
  bool is_sharp(std::uint32_t triangle, std::uint32_t next) const;

  SolidSurface surface_;
  std::vector<std::size_t> begins_;  ///< of the triangles of each vertex, and the end
  std::vector<std::uint32_t> triangles_;
};

}  // namespace crossgrain
