// SPDX-License-Identifier: Apache-2.0
// Places spread over the surface of a field on a grid, several in each cell that it passes through.
#pragma once

#include <cstdint>
#include <deque>

#include "display/surface_numbers.hpp"
#include "grid/leaf_finder.hpp"

namespace crossgrain {

/// The middle of a piece of a triangle. Small, as there are several for each cell with surface.
struct SurfaceSpot {
  std::uint32_t triangle;
  float u, v;      ///< barycentric coordinates of the triangle's second and third corner
  float area;      ///< of the piece, and of tiny ones before it; model units
  CellIndex leaf;  ///< that which holds the surface there; kNoCell if there is none

  SurfacePoint on(const SolvedSurface& surface) const {
    const auto& [a, b, c] = surface.triangles[triangle];
    const Vector3& first = surface.vertices[a];
    const Vector3 place = first + static_cast<double>(u) * (surface.vertices[b] - first) +
                          static_cast<double>(v) * (surface.vertices[c] - first);
    return {place, triangle, u, v};
  }
};

/// Finds the leaf that holds the surface at a point. Refers to the field.
class SurfaceLeaves {
 public:
  explicit SurfaceLeaves(const FieldData& field);

  const LeafFinder& finder() const { return finder_; }

  /// Size of the largest cell with surface, model units.
  double largest_cell() const { return largest_; }

  /// A place slightly inside of a point of the surface: far enough for single precision, not far enough to
  /// leave the cell. A surface between two layers of cells is in only one of them, so it may be slightly
  /// outside. The leaf is kNoCell if there is none on either side.
  struct Beside {
    Vector3 place;
    CellIndex leaf;
  };

  /// Faster if the leaf is `likely`.
  Beside beside(const Vector3& point, const Vector3& normal, CellIndex likely = kNoCell) const;

 private:
  const FieldData& field_;
  LeafFinder finder_;
  double inwards_, largest_;  ///< model units
};

/// Cuts the triangles of a surface into pieces with no side longer than `longest` cells, and returns the
/// middle of each, in the order of triangles; of tiny neighbouring ones the middle of one, with the area of
/// all.
std::deque<SurfaceSpot> surface_spots(const SolvedSurface& surface, const FieldData& field,
                                      const SurfaceLeaves& leaves, double longest);

}  // namespace crossgrain
