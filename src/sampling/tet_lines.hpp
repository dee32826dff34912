// SPDX-License-Identifier: Apache-2.0
// The field on tets, for tracing lines.
#pragma once

#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "sampling/cell_names.hpp"
#include "sampling/line_space.hpp"
#include "sampling/tet_walk.hpp"
#include "singularity/matching.hpp"
#include "tets/stiffness.hpp"

namespace crossgrain {

struct FramesOnTets {
  const TetSolid& solid;
  std::span<const StiffnessEdge> edges;  ///< of the solid
  std::span<const Quaternion> vertex_frames;
  std::span<const Quaternion> tet_frames;  ///< for the singular edges
  std::vector<CubeRotation> matchings;     ///< of TetSolid::inner_faces, for the same
};

/// Cells are tets, of the size of their mean edge. The frame at a point is the one nearest to the sum of the
/// coefficients of degree 4 of the corners, weighted linearly: continuous across faces. Refers to the arrays
/// given, and to itself.
class TetLines : public LineSpace {
 public:
  TetLines(const FramesOnTets& field, double arc_distance_cells);
  TetLines(const TetLines&) = delete;
  TetLines& operator=(const TetLines&) = delete;

  Box bounds() const override { return walk_.finder().box(); }
  double volume() const override;
  LineSurface surface() const override { return {field_.solid.mesh.vertices, field_.solid.boundary}; }
  LineCell cell_at(const Vector3& point) const override { return walk_.tet_at(point); }
  double cell_size(LineCell cell) const override { return sizes_[cell]; }
  bool is_at_arc(const LinePlace& place) const override;
  Quaternion frame_at(const LinePlace& from, const Vector3& to, LineCell& end) const override;
  LineStop first_stop(const LinePlace& from, const Vector3& to) const override;
  AxisNames names_at(const LinePlace& place, const Quaternion& frame) const override;

 private:
  /// The points nearer to a singular edge than `radius`.
  struct Tube {
    Vector3 from, to;
    double radius;
  };
  struct TubeAtTet {
    std::uint32_t tet, tube;
    auto operator<=>(const TubeAtTet&) const = default;
  };

  void add_tubes(double arc_distance_cells);
  double share_to_tube(std::uint32_t tet, const Vector3& from, const Vector3& to) const;
  CellNames names_of_vertices() const;

  FramesOnTets field_;
  TetWalk walk_;
  std::vector<double> sizes_;
  std::vector<Tube> tubes_;
  std::vector<TubeAtTet> tubes_at_tets_;  ///< sorted
  mutable std::once_flag names_once_;
  mutable std::optional<CellNames> names_;
};

static_assert(kNoLineCell == kNoTet);

}  // namespace crossgrain
