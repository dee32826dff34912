// SPDX-License-Identifier: Apache-2.0
#include "measure/alignment.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

#include "base/elementary.hpp"
#include "base/parallel.hpp"
#include "constraint/classification.hpp"
#include "grid/cell_constraints.hpp"
#include "measure/angle_statistics.hpp"
#include "sampling/frames_in_leaves.hpp"
#include "surface/clipping.hpp"

namespace crossgrain {
namespace {

/// Number of leaves per task: enough that two tasks compute few of the same turns.
constexpr std::size_t kLeafGrain = 4096;

CellConstraint as_written(ConstraintClass constraint_class) {
  switch (constraint_class) {
    case ConstraintClass::kFree:
      return CellConstraint::kFree;
    case ConstraintClass::kPlane:
      return CellConstraint::kPlane;
    case ConstraintClass::kAxis:
      return CellConstraint::kAxis;
    case ConstraintClass::kFrame:
      return CellConstraint::kFrame;
    case ConstraintClass::kFrameCompromised:
    case ConstraintClass::kConflicted:
      break;
  }
  return CellConstraint::kConflicted;
}

SolveReport::Spectrum spectrum_of(const Share& share, std::span<const CellConstraint> constraints) {
  std::array<std::size_t, kCellConstraintCount> counts{};
  for (const CellConstraint constraint : constraints) ++counts[static_cast<std::size_t>(constraint)];
  add_up(share, std::span<std::size_t>(counts));
  const auto of = [&](CellConstraint constraint) { return counts[static_cast<std::size_t>(constraint)]; };
  SolveReport::Spectrum spectrum;
  spectrum.plane = of(CellConstraint::kPlane);
  spectrum.axis = of(CellConstraint::kAxis);
  spectrum.frame = of(CellConstraint::kFrame);
  spectrum.free = of(CellConstraint::kFree);
  spectrum.conflicted = of(CellConstraint::kConflicted);
  return spectrum;
}

/// Measures the pieces of a range of leaves, several side by side.
class RunOfLeaves {
 public:
  RunOfLeaves(const GridLevel& level, const Solid& solid, const LeafField& field, CellIndex begin,
              CellIndex end)
      : level_(level),
        solid_(solid),
        field_(field),
        begin_(begin),
        end_(end),
        frames_(field),
        leaves_(end - begin) {}

  /// Sets the angles of all pieces, and the means and constraints of all leaves.
  void measure(std::vector<float>& angles, AlignmentMeasurement& result) {
    for (CellIndex i = begin_; i < end_; ++i) {
      if (!level_.holds_surface(i)) continue;
      const ConstraintClass constraints = constraint_class(level_, solid_, i);
      result.leaf_constraints[i] = as_written(constraints);
      for (std::uint32_t k = level_.piece_begin[i]; k < level_.piece_begin[i + 1]; ++k) {
        if (frames_.is_full()) measure_points(angles);
        add_point(i, k, compatible(constraints));
      }
    }
    measure_points(angles);
    for (CellIndex i = begin_; i < end_; ++i) {
      const auto& [weighted, area] = leaves_[i - begin_];
      result.leaf_mean_deg[i] = area > 0 ? static_cast<float>(weighted / area) : 0;
    }
  }

 private:
  struct Point {
    CellIndex leaf;
    std::uint32_t piece;
    bool included;
    Vector3 normal;  ///< surface normal at the point
  };
  struct LeafSum {
    double weighted = 0, area = 0;
  };

  void add_point(CellIndex leaf, std::uint32_t k, bool included) {
    const Box box = field_.tree.root().box(field_.tree[leaf]);
    const Vector3 centroid = clip_triangle(solid_.surface.corners(level_.pieces[k].triangle), box).centroid;
    points_[point_count_++] = {leaf, k, included,
                               solid_.surface.normal_at(level_.pieces[k].triangle, centroid)};
    frames_.add(leaf, centroid);
  }

  void measure_points(std::vector<float>& angles) {
    const std::span<const Quaternion> frames = frames_.frames();
    for (std::size_t p = 0; p < point_count_; ++p) {
      const auto& [leaf, k, included, normal] = points_[p];
      const SurfacePiece& piece = level_.pieces[k];
      const double angle = angle_to_nearest_axis_deg(frames[p], normal);
      angles[k] = included ? static_cast<float>(angle) : kExcludedAngle;
      LeafSum& sum = leaves_[leaf - begin_];
      sum.weighted += piece.area * angle;
      sum.area += piece.area;
    }
    point_count_ = 0;
  }

  const GridLevel& level_;
  const Solid& solid_;
  const LeafField& field_;
  CellIndex begin_, end_;
  FramesInLeaves frames_;
  std::vector<LeafSum> leaves_;
  std::size_t point_count_ = 0;
  std::array<Point, FramesInLeaves::kMost> points_;
};

}  // namespace

double angle_to_nearest_axis_deg(const Quaternion& frame, const Vector3& direction) {
  double sine = 1, cosine = 0;
  for (const Vector3& axis : axes_of(frame)) {
    const double along = std::abs(dot(axis, direction));
    if (along <= cosine) continue;
    cosine = along;
    sine = norm(cross(axis, direction));
  }
  // The arc cosine would lose half of the digits of small angles.
  return arc_tangent(sine, cosine) * 180 / std::numbers::pi;
}

AlignmentMeasurement measure_alignment(const GridLevel& level, const Solid& solid, const LeafField& field) {
  AlignmentMeasurement result;
  result.leaf_mean_deg.resize(level.size());
  result.leaf_constraints.resize(level.size(), CellConstraint::kNoSurface);
  std::vector<float> angles(level.pieces.size());
  const Share share = level.share();
  parallel_for_chunks(share.size(), kLeafGrain, [&](std::size_t begin, std::size_t end) {
    RunOfLeaves run(level, solid, field, static_cast<CellIndex>(share.begin + begin),
                    static_cast<CellIndex>(share.begin + end));
    run.measure(angles, result);
  });
  result.spectrum = spectrum_of(share, std::span(result.leaf_constraints).subspan(share.begin, share.size()));
  const std::size_t first = level.piece_begin[share.begin], last = level.piece_begin[share.end];
  result.alignment_deg = angle_statistics(
      std::span(level.pieces).subspan(first, last - first), std::span(angles).subspan(first, last - first),
      std::accumulate(solid.surface.areas.begin(), solid.surface.areas.end(), 0.0), share);
  return result;
}

}  // namespace crossgrain
