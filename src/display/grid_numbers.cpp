// SPDX-License-Identifier: Apache-2.0
#include "display/grid_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

/// Longest sides of the pieces of the surface, in cells, from which cells are weighed, and to which corners
/// are fitted: a few pieces in each cell.
constexpr double kWeighed = 1.0, kFitted = 0.6;

/// Largest number of samples: enough for a percentile.
constexpr std::size_t kMostSamples = 40000;

/// Weights of leaves: 1/2 where the surface passes the centre, 1 from this depth of the centre below the
/// surface, in cells; never less than the least, so that a wall of such leaves has numbers.
constexpr double kFullDepth = 0.4, kLeastWeight = 0.02;

/// Weight of a leaf whose surface is too small for a piece.
constexpr float kUnknownWeight = 0.3f;

/// Cosines of the angles, about 12 and 24 degrees, up to which axes around a point are averaged as vectors,
/// so that the turn of a frame from cell to cell cancels, and from which the angles themselves are: axes that
/// are off to opposite sides must not pass for one that is right.
constexpr double kTogether = 0.978, kApart = 0.914;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The axis nearest to a direction, turned to its side.
Vector3 nearest_axis(const StoredQuaternion& frame, const Vector3& direction) {
  const auto axes = axes_of(Quaternion{frame.w, frame.x, frame.y, frame.z});
  double largest = 0;
  std::size_t nearest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double cosine = dot(axes[k], direction);
    if (std::abs(cosine) > std::abs(largest)) largest = cosine, nearest = k;
  }
  return largest < 0 ? -axes[nearest] : axes[nearest];
}

}  // namespace

GridNumbers::GridNumbers(const ShownField& field, SurfaceNumber number)
    : field_(field.grid()),
      surface_(field.surface()),
      number_(number),
      leaves_(field_),
      normals_(
          corner_normals(SmoothCorners(surface_.vertices, surface_.triangles), surface_.triangles.size())),
      spots_(surface_spots(surface_, field_, leaves_, kWeighed)) {
  weigh_leaves();
}

void GridNumbers::weigh_leaves() {
  std::vector<float> depths(field_.tree.size(), 0), areas(field_.tree.size(), 0);
  for (const SurfaceSpot& spot : spots_) {
    if (spot.leaf == kNoCell) continue;
    const double depth = dot(smooth_normal(spot.point), spot.point.place - field_.tree.centre(spot.leaf)) /
                         field_.tree.cell_size(spot.leaf);
    depths[spot.leaf] += static_cast<float>(depth * spot.area);
    areas[spot.leaf] += static_cast<float>(spot.area);
  }
  weights_.resize(field_.tree.size());
  parallel_for(weights_.size(), [&](std::size_t i) {
    if (field_.on_boundary[i] == 0)
      weights_[i] = 1;
    else if (areas[i] == 0)
      weights_[i] = kUnknownWeight;
    else
      weights_[i] =
          static_cast<float>(std::clamp(0.5 + 0.5 / kFullDepth * depths[i] / areas[i], kLeastWeight, 1.0));
  });
}

LeafBlock GridNumbers::block_at(const Vector3& place) const {
  LeafBlock block = leaf_block(field_.tree, leaves_.finder(), field_.open_faces, place);
  double sum = 0;
  for (std::size_t i = 0; i < block.count; ++i) {
    block.parts[i].share *= static_cast<double>(weights_[block.parts[i].leaf]);
    sum += block.parts[i].share;
  }
  for (std::size_t i = 0; i < block.count; ++i) block.parts[i].share /= sum;
  return block;
}

Vector3 GridNumbers::smooth_normal(const SurfacePoint& point) const {
  const auto& corners = normals_[point.triangle];
  Vector3 normal{};
  for (std::size_t k = 0; k < 3; ++k)
    normal[k] = static_cast<double>((1 - point.u - point.v) * corners[0][k] + point.u * corners[1][k] +
                                    point.v * corners[2][k]);
  return normalised(normal);
}

double GridNumbers::energy_of(const LeafBlock& block) const {
  double sum = 0;
  for (const LeafBlock::Part& part : block.used())
    sum += part.share * static_cast<double>(field_.energy_density[part.leaf]);
  return block.count > 0 ? sum : kNone;
}

double GridNumbers::alignment_of(const LeafBlock& block, const Vector3& normal) const {
  if (block.count == 0) return kNone;
  Vector3 axis{0, 0, 0};
  for (const LeafBlock::Part& part : block.used())
    axis += part.share * nearest_axis(field_.frames[part.leaf], normal);
  const double mean_cosine = dot(axis, normal), cosine_of_mean = mean_cosine / norm(axis);
  const double share = std::clamp((kTogether - mean_cosine) / (kTogether - kApart), 0.0, 1.0);
  const double cosine = cosine_of_mean + share * (mean_cosine - cosine_of_mean);
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * (180 / std::numbers::pi);
}

double GridNumbers::at(const SurfacePoint& point) const {
  const Vector3 normal = smooth_normal(point);
  const LeafBlock block = block_at(leaves_.beside(point.place, normal).place);
  return number_ == SurfaceNumber::kEnergy ? energy_of(block) : alignment_of(block, normal);
}

double GridNumbers::energy_at(const Vector3& place) const {
  return energy_of(block_at(place));
}

std::vector<SurfaceNumbers::Sample> GridNumbers::samples() const {
  const std::size_t step = spots_.size() / kMostSamples + 1;
  std::vector<SurfaceNumbers::Sample> samples((spots_.size() + step - 1) / step);
  parallel_for(samples.size(), [&](std::size_t i) {
    const SurfaceSpot& spot = spots_[step * i];
    samples[i] = {at(spot.point), spot.area};
  });
  return samples;
}

std::vector<SurfaceNumbers::LeafCorners> GridNumbers::at_leaf_corners() const {
  const std::vector<SurfaceSpot> spots = surface_spots(surface_, field_, leaves_, kFitted);
  std::vector<double> numbers(spots.size());
  parallel_for(spots.size(), [&](std::size_t i) { numbers[i] = at(spots[i].point); });

  // The corners of leaves with surface, and the corners of each leaf among them.
  std::vector<SurfaceNumbers::LeafCorners> leaves;
  std::vector<std::uint32_t> row(field_.tree.size(), 0);  // of each leaf
  std::vector<std::uint64_t> corners;
  const auto corner_of = [&](CellIndex leaf, std::size_t octant) {
    GridPoint at = field_.tree[leaf].corner();
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (octant >> axis & 1) at[axis] += field_.tree[leaf].width();
    return morton::spread(static_cast<std::uint64_t>(at[0])) |
           morton::spread(static_cast<std::uint64_t>(at[1])) << 1 |
           morton::spread(static_cast<std::uint64_t>(at[2])) << 2;
  };
  for (CellIndex i = 0; i < field_.tree.size(); ++i) {
    if (field_.on_boundary[i] == 0) continue;
    row[i] = static_cast<std::uint32_t>(leaves.size());
    leaves.push_back({i, {}});
    for (std::size_t octant = 0; octant < 8; ++octant) corners.push_back(corner_of(i, octant));
  }
  std::vector<std::uint64_t> sorted = corners;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  std::vector<std::uint32_t> index(corners.size());
  parallel_for(corners.size(), [&](std::size_t i) {
    index[i] = static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), corners[i]) -
                                          sorted.begin());
  });

  std::vector<double> sums(sorted.size(), 0), weights(sorted.size(), 0);
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const CellIndex leaf = spots[i].leaf;
    if (leaf == kNoCell || field_.on_boundary[leaf] == 0 || !std::isfinite(numbers[i])) continue;
    const Box box = field_.tree.root().box(field_.tree[leaf]);
    for (std::size_t octant = 0; octant < 8; ++octant) {
      double weight = spots[i].area;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double share = std::clamp(
            (spots[i].point.place[axis] - box.low[axis]) / (box.high[axis] - box.low[axis]), 0.0, 1.0);
        weight *= octant >> axis & 1 ? share : 1 - share;
      }
      const std::uint32_t corner = index[8 * row[leaf] + octant];
      sums[corner] += weight * numbers[i];
      weights[corner] += weight;
    }
  }
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    double sum = 0, weight = 0;
    for (std::size_t octant = 0; octant < 8; ++octant)
      sum += sums[index[8 * k + octant]], weight += weights[index[8 * k + octant]];
    for (std::size_t octant = 0; octant < 8; ++octant) {
      const std::uint32_t corner = index[8 * k + octant];
      const double number = weights[corner] > 0 ? sums[corner] / weights[corner] : sum / weight;
      leaves[k].numbers[octant] = static_cast<float>(weight > 0 ? number : 0);
    }
  }
  return leaves;
}

}  // namespace crossgrain
