// SPDX-License-Identifier: Apache-2.0
#include "measure/alignment.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "base/parallel.hpp"
#include "constraint/classification.hpp"
#include "grid/cell_constraints.hpp"
#include "measure/angle_statistics.hpp"
#include "sampling/frame_blend.hpp"
#include "sampling/turn_cache.hpp"
#include "surface/clipping.hpp"

namespace crossgrain {
namespace {

/// Leaves that one task measures: enough that few turns are worked out by two tasks.
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

SolveReport::Spectrum spectrum_of(const std::vector<CellConstraint>& constraints) {
  std::array<std::size_t, kCellConstraintCount> counts{};
  for (const CellConstraint constraint : constraints) ++counts[static_cast<std::size_t>(constraint)];
  const auto of = [&](CellConstraint constraint) { return counts[static_cast<std::size_t>(constraint)]; };
  SolveReport::Spectrum spectrum;
  spectrum.plane = of(CellConstraint::kPlane);
  spectrum.axis = of(CellConstraint::kAxis);
  spectrum.frame = of(CellConstraint::kFrame);
  spectrum.free = of(CellConstraint::kFree);
  spectrum.conflicted = of(CellConstraint::kConflicted);
  return spectrum;
}

/// Measures the pieces of a run of leaves, several side by side.
class RunOfLeaves {
 public:
  RunOfLeaves(const GridLevel& level, const Solid& solid, const LeafField& field, CellIndex begin,
              CellIndex end)
      : level_(level),
        solid_(solid),
        field_(field),
        begin_(begin),
        end_(end),
        around_(field.tree, field.finder),
        turns_(field),
        leaves_(end - begin),
        terms_(kTermsAtOnce) {}

  /// Writes the angles of all pieces, and the means and constraints of all leaves.
  void measure(std::vector<float>& angles, AlignmentMeasurement& result) {
    for (CellIndex i = begin_; i < end_; ++i) {
      if (!level_.holds_surface(i)) continue;
      const ConstraintClass constraints = constraint_class(level_, solid_, i);
      result.leaf_constraints[i] = as_written(constraints);
      around_.move_to(i);
      for (std::uint32_t k = level_.piece_begin[i]; k < level_.piece_begin[i + 1]; ++k) {
        if (point_count_ == kPointsAtOnce || term_count_ + LeavesAround::kMost > kTermsAtOnce)
          measure_points(angles);
        add_point(k, compatible(constraints));
      }
    }
    measure_points(angles);
    for (CellIndex i = begin_; i < end_; ++i) {
      const auto& [weighted, area] = leaves_[i - begin_];
      result.leaf_mean_deg[i] = area > 0 ? static_cast<float>(weighted / area) : 0;
    }
  }

 private:
  static constexpr std::size_t kPointsAtOnce = 64, kTermsAtOnce = 16 * kPointsAtOnce;

  struct Point {
    CellIndex leaf;
    std::uint32_t piece;
    bool included;
    Vector3 normal;  ///< of the surface there
  };
  struct LeafSum {
    double weighted = 0, area = 0;
  };

  void add_point(std::uint32_t k, bool included) {
    const CellIndex leaf = around_.leaf();
    const RootCube& root = field_.tree.root();
    const Box box = root.box(field_.tree[leaf]);
    const Vector3 centroid = clip_triangle(solid_.surface.corners(level_.pieces[k].triangle), box).centroid;
    const LeavesAround around(field_, around_, 1 / root.unit() * (centroid - root.origin));
    points_[point_count_] = {leaf, k, included,
                             solid_.surface.normal_at(level_.pieces[k].triangle, centroid)};
    const FrameBlend& blend = blends_[point_count_++] =
        frame_blend(field_, around, turns_, &terms_[term_count_]);
    term_count_ += blend.terms.size();
  }

  void measure_points(std::vector<float>& angles) {
    blend_frames({blends_.data(), point_count_}, {frames_.data(), point_count_});
    for (std::size_t p = 0; p < point_count_; ++p) {
      const auto& [leaf, k, included, normal] = points_[p];
      const SurfacePiece& piece = level_.pieces[k];
      const double angle = angle_to_nearest_axis_deg(frames_[p], normal);
      angles[k] = included ? static_cast<float>(angle) : kExcludedAngle;
      LeafSum& sum = leaves_[leaf - begin_];
      sum.weighted += piece.area * angle;
      sum.area += piece.area;
    }
    point_count_ = term_count_ = 0;
  }

  const GridLevel& level_;
  const Solid& solid_;
  const LeafField& field_;
  CellIndex begin_, end_;
  LeafSurroundings around_;
  TurnCache turns_;
  std::vector<LeafSum> leaves_;
  std::size_t point_count_ = 0, term_count_ = 0;
  std::array<Point, kPointsAtOnce> points_;
  std::array<FrameBlend, kPointsAtOnce> blends_;
  std::array<Quaternion, kPointsAtOnce> frames_;
  std::vector<BlendTerm> terms_;
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
  return std::atan2(sine, cosine) * 180 / std::numbers::pi;
}

AlignmentMeasurement measure_alignment(const GridLevel& level, const Solid& solid, const LeafField& field) {
  AlignmentMeasurement result;
  result.leaf_mean_deg.resize(level.size());
  result.leaf_constraints.resize(level.size(), CellConstraint::kNoSurface);
  std::vector<float> angles(level.pieces.size());
  parallel_for_chunks(level.size(), kLeafGrain, [&](std::size_t begin, std::size_t end) {
    RunOfLeaves run(level, solid, field, static_cast<CellIndex>(begin), static_cast<CellIndex>(end));
    run.measure(angles, result);
  });
  result.spectrum = spectrum_of(result.leaf_constraints);
  result.alignment_deg = angle_statistics(level.pieces, angles);
  return result;
}

}  // namespace crossgrain
