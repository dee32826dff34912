// SPDX-License-Identifier: Apache-2.0
#include "analysis/alignment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.hpp"
#include "constraint/classification.hpp"
#include "grid/cell_constraints.hpp"
#include "surface/clipping.hpp"

namespace crossgrain {
namespace {

/// One number per piece, in the order of GridLevel::pieces; kExcluded for those in leaves that no frame
/// suits.
using PieceAngles = std::vector<float>;
constexpr float kExcluded = -1;

/// The leaf's mean; writes its pieces' angles.
double measure_leaf(const GridLevel& level, const Solid& solid, const Sampler& sampler, CellIndex i,
                    bool included, PieceAngles& angles) {
  const Box box = level.tree.root().box(level.tree[i]);
  double weighted = 0, area = 0;
  for (std::uint32_t k = level.piece_begin[i]; k < level.piece_begin[i + 1]; ++k) {
    const SurfacePiece& piece = level.pieces[k];
    const Vector3 centroid = clip_triangle(solid.surface.corners(piece.triangle), box).centroid;
    const double angle =
        angle_to_nearest_axis_deg(sampler.in_leaf(i, centroid), solid.surface.normals[piece.triangle]);
    angles[k] = included ? static_cast<float>(angle) : kExcluded;
    weighted += piece.area * angle;
    area += piece.area;
  }
  return area > 0 ? weighted / area : 0;
}

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

/// The statistics of the angles that are not excluded, each weighted by its piece's area.
SolveReport::Alignment summed_up(const std::vector<SurfacePiece>& pieces, const PieceAngles& angles) {
  struct WeightedAngle {
    float angle, area;
    auto operator<=>(const WeightedAngle&) const = default;
  };
  std::vector<WeightedAngle> included;
  double included_area = 0, excluded_area = 0, weighted = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (angles[k] == kExcluded) {
      excluded_area += pieces[k].area;
      continue;
    }
    included.push_back({angles[k], pieces[k].area});
    included_area += pieces[k].area;
    weighted += static_cast<double>(pieces[k].area) * angles[k];
  }
  SolveReport::Alignment alignment;
  if (excluded_area > 0) alignment.excluded_share = excluded_area / (excluded_area + included_area);
  if (included.empty()) return alignment;
  std::sort(included.begin(), included.end());
  alignment.mean = weighted / included_area;
  alignment.max = included.back().angle;
  alignment.p95 = alignment.max;
  double above = 0;
  for (auto it = included.rbegin(); it != included.rend() && above <= 0.05 * included_area; ++it) {
    alignment.p95 = it->angle;
    above += it->area;
  }
  return alignment;
}

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

AlignmentMeasurement measure_alignment(const GridLevel& level, const Solid& solid, const Sampler& sampler) {
  AlignmentMeasurement result;
  result.leaf_mean_deg.resize(level.size());
  PieceAngles angles(level.pieces.size());
  std::vector<ConstraintClass> classes(level.size());
  parallel_for(level.size(), [&](std::size_t index) {
    const auto i = static_cast<CellIndex>(index);
    if (!level.holds_surface(i)) return;
    classes[i] = constraint_class(level, solid, i);
    const double mean = measure_leaf(level, solid, sampler, i, compatible(classes[i]), angles);
    result.leaf_mean_deg[i] = static_cast<float>(mean);
  });
  for (CellIndex i = 0; i < level.size(); ++i) {
    if (level.holds_surface(i)) count(classes[i], result.spectrum);
  }
  result.alignment_deg = summed_up(level.pieces, angles);
  return result;
}

}  // namespace crossgrain
