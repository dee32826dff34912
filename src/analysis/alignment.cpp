// SPDX-License-Identifier: Apache-2.0
#include "analysis/alignment.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "analysis/angle_statistics.hpp"
#include "analysis/frame_blend.hpp"
#include "analysis/turn_cache.hpp"
#include "base/parallel.hpp"
#include "constraint/classification.hpp"
#include "grid/cell_constraints.hpp"
#include "surface/clipping.hpp"

namespace crossgrain {
namespace {

/// Leaves that one task measures: enough that few turns are worked out by two tasks.
constexpr std::size_t kLeafGrain = 4096;

void count(ConstraintClass constraint_class, SolveReport::Spectrum& spectrum) {
  switch (constraint_class) {
    case ConstraintClass::kFree:
      ++spectrum.free;
      break;
    case ConstraintClass::kPlane:
      ++spectrum.plane;
      break;
    case ConstraintClass::kAxis:
      ++spectrum.axis;
      break;
    case ConstraintClass::kFrame:
      ++spectrum.frame;
      break;
    case ConstraintClass::kFrameCompromised:
    case ConstraintClass::kConflicted:
      ++spectrum.conflicted;
      break;
  }
}

void add(const SolveReport::Spectrum& part, SolveReport::Spectrum& whole) {
  whole.plane += part.plane;
  whole.axis += part.axis;
  whole.frame += part.frame;
  whole.free += part.free;
  whole.conflicted += part.conflicted;
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

  /// Writes the angles of all pieces and the means of all leaves.
  SolveReport::Spectrum measure(std::vector<float>& angles, std::vector<float>& leaf_mean_deg) {
    SolveReport::Spectrum spectrum;
    for (CellIndex i = begin_; i < end_; ++i) {
      if (!level_.holds_surface(i)) continue;
      const ConstraintClass constraints = constraint_class(level_, solid_, i);
      count(constraints, spectrum);
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
      leaf_mean_deg[i] = area > 0 ? static_cast<float>(weighted / area) : 0;
    }
    return spectrum;
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
  std::vector<float> angles(level.pieces.size());
  std::vector<SolveReport::Spectrum> spectra((level.size() + kLeafGrain - 1) / kLeafGrain);
  parallel_for_chunks(level.size(), kLeafGrain, [&](std::size_t begin, std::size_t end) {
    RunOfLeaves run(level, solid, field, static_cast<CellIndex>(begin), static_cast<CellIndex>(end));
    spectra[begin / kLeafGrain] = run.measure(angles, result.leaf_mean_deg);
  });
  for (const SolveReport::Spectrum& of_run : spectra) add(of_run, result.spectrum);
  result.alignment_deg = angle_statistics(level.pieces, angles);
  return result;
}

}  // namespace crossgrain
