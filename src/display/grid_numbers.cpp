// SPDX-License-Identifier: Apache-2.0
#include "display/grid_numbers.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "base/lists.hpp"
#include "base/parallel.hpp"
#include "display/leaf_corner_means.hpp"
#include "measure/alignment.hpp"
#include "sampling/frames_in_leaves.hpp"

namespace crossgrain {
namespace {

/// Largest number of pieces in a cell to which its corners are fitted.
constexpr int kFitted = 6;

/// Largest number of samples: enough for a percentile.
constexpr std::size_t kMostSamples = 40000;

/// Weights of leaves: 1/2 where the surface passes the centre, 1 from this depth of the centre below the
/// surface, in cells; never less than the least, so that a wall of such leaves has numbers.
constexpr double kFullDepth = 0.4, kLeastWeight = 0.02;

/// Depth below the surface, in cells, of the middle of the cells from which its energy is taken where there
/// are some: of those above, a varying part is missing.
constexpr double kEnergyDepth = 0.5;

/// Weight of a leaf whose surface is too small for a piece.
constexpr float kUnknownWeight = 0.3f;

/// Least share with which a facet counts that faces another way than the surface at a point: it then has a
/// number if there is no other.
constexpr double kLeastFacing = 1e-6;

/// Number of leaves per task: enough that two tasks compute few of the same turns.
constexpr std::size_t kLeafGrain = 4096;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Which of the six directions along coordinate axes is nearest.
std::size_t nearest_direction(const Vector3& normal) {
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(normal[k]) > std::abs(normal[nearest])) nearest = k;
  return 2 * nearest + (normal[nearest] > 0 ? 1 : 0);
}

}  // namespace

GridNumbers::GridNumbers(const ShownField& field, SurfaceNumber number, double longest)
    : field_(field.grid()),
      surface_(field.surface()),
      number_(number),
      leaves_(field_),
      normals_(std::make_shared<const CornerNormals>(
          corner_normals(SmoothCorners(surface_.vertices, surface_.triangles), surface_.triangles.size()))),
      spots_(std::make_shared<const std::deque<SurfaceSpot>>(
          surface_spots(surface_, field_, leaves_, longest))) {
  prepare();
}

GridNumbers::GridNumbers(const GridNumbers& other, SurfaceNumber number)
    : field_(other.field_),
      surface_(other.surface_),
      number_(number),
      leaves_(other.leaves_),
      normals_(other.normals_),
      spots_(other.spots_) {
  prepare();
}

void GridNumbers::prepare() {
  if (number_ == SurfaceNumber::kEnergy)
    weigh_leaves();
  else
    measure_facets();
}

void GridNumbers::weigh_leaves() {
  std::vector<float> depths(field_.tree.size(), 0), areas(field_.tree.size(), 0);
  for (const SurfaceSpot& spot : *spots_) {
    if (spot.leaf == kNoCell) continue;
    const SurfacePoint point = spot.on(surface_);
    const double depth = dot(smooth_normal(point), point.place - field_.tree.centre(spot.leaf)) /
                         field_.tree.cell_size(spot.leaf);
    depths[spot.leaf] += static_cast<float>(depth) * spot.area;
    areas[spot.leaf] += spot.area;
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

/// The normal of the triangle itself, which the solve follows; the mean of a cell is smooth enough.
Vector3 GridNumbers::flat_normal(const SurfaceSpot& spot) const {
  const auto& [a, b, c] = surface_.triangles[spot.triangle];
  return normalised(
      cross(surface_.vertices[b] - surface_.vertices[a], surface_.vertices[c] - surface_.vertices[a]));
}

void GridNumbers::measure_facets() {
  const Lists<std::uint32_t> spots(field_.tree.size(), [&](const auto& add) {
    for (std::uint32_t i = 0; i < spots_->size(); ++i)
      if ((*spots_)[i].leaf != kNoCell) add((*spots_)[i].leaf, i);
  });
  facets_begin_.assign(field_.tree.size() + 1, 0);
  parallel_for(field_.tree.size(), [&](std::size_t leaf) {
    unsigned directions = 0;
    for (const std::uint32_t i : spots[leaf])
      directions |= 1u << nearest_direction(flat_normal((*spots_)[i]));
    facets_begin_[leaf + 1] = static_cast<std::uint32_t>(std::popcount(directions));
  });
  for (std::size_t i = 0; i < field_.tree.size(); ++i) facets_begin_[i + 1] += facets_begin_[i];
  facets_.resize(facets_begin_.back());
  const LeafField frames{field_.tree, field_.frames, field_.open_faces};
  parallel_for_chunks(field_.tree.size(), kLeafGrain, [&](std::size_t begin, std::size_t end) {
    FramesInLeaves at_facets(frames);
    std::vector<std::uint32_t> pending;
    const auto measure = [&] {
      const std::span<const Quaternion> frames_there = at_facets.frames();
      for (std::size_t k = 0; k < pending.size(); ++k) {
        Facet& facet = facets_[pending[k]];
        facet.angle_deg = angle_to_nearest_axis_deg(frames_there[k], facet.normal);
      }
      pending.clear();
    };
    for (std::size_t leaf = begin; leaf < end; ++leaf) {
      std::uint32_t facet = facets_begin_[leaf];
      for_each_facet(static_cast<CellIndex>(leaf), spots[leaf], [&](const Facet& made, const Vector3& place) {
        if (at_facets.is_full()) measure();
        pending.push_back(facet);
        facets_[facet++] = made;
        at_facets.add(static_cast<CellIndex>(leaf), place);
      });
    }
    measure();
  });
}

/// Calls visit(facet, place) for each facet of a leaf, still without its angle, and a place on it.
template <class Visit>
void GridNumbers::for_each_facet(CellIndex leaf, std::span<const std::uint32_t> spots,
                                 const Visit& visit) const {
  if (spots.empty()) return;
  struct Sum {
    Vector3 places{}, normals{};
    double area = 0;
  };
  std::array<Sum, 6> sums;
  for (const std::uint32_t i : spots) {
    const SurfaceSpot& spot = (*spots_)[i];
    const Vector3 normal = flat_normal(spot);
    Sum& sum = sums[nearest_direction(normal)];
    const auto area = static_cast<double>(spot.area);
    sum.places += area * spot.on(surface_).place;
    sum.normals += area * normal;
    sum.area += area;
  }
  const Box box = field_.tree.root().box(field_.tree[leaf]);
  for (const Sum& sum : sums) {
    if (!(sum.area > 0)) continue;
    Vector3 place = (1 / sum.area) * sum.places;  // of a curved facet in its leaf, to rounding
    for (std::size_t axis = 0; axis < 3; ++axis)
      place[axis] = std::clamp(place[axis], box.low[axis], box.high[axis]);
    visit(Facet{normalised(sum.normals), sum.area, 0}, place);
  }
}

LeafBlock GridNumbers::block_at(const Vector3& place) const {
  return leaf_block(field_.tree, leaves_.finder(), field_.open_faces, place);
}

Vector3 GridNumbers::smooth_normal(const SurfacePoint& point) const {
  const auto& corners = (*normals_)[point.triangle];
  Vector3 normal{};
  for (std::size_t k = 0; k < 3; ++k)
    normal[k] = static_cast<double>((1 - point.u - point.v) * corners[0][k] + point.u * corners[1][k] +
                                    point.v * corners[2][k]);
  return normalised(normal);
}

/// The mean over the cells that lie in the part.
double GridNumbers::energy_of(const LeafBlock& block) const {
  double sum = 0, weights = 0;
  for (const LeafBlock::Part& part : block.used()) {
    const double weight = part.share * static_cast<double>(weights_[part.leaf]);
    sum += weight * static_cast<double>(field_.energy_density[part.leaf]);
    weights += weight;
  }
  return weights > 0 ? sum / weights : kNone;
}

/// The mean over the surface around that faces the same way.
double GridNumbers::alignment_of(const LeafBlock& block, const Vector3& normal) const {
  double sum = 0, weights = 0;
  for (const LeafBlock::Part& part : block.used()) {
    for (std::uint32_t k = facets_begin_[part.leaf]; k < facets_begin_[part.leaf + 1]; ++k) {
      const Facet& facet = facets_[k];
      const double facing = std::max(dot(facet.normal, normal), 0.0), facing2 = facing * facing;
      const double weight = part.share * facet.area * std::max(facing2 * facing2 * facing2, kLeastFacing);
      sum += weight * facet.angle_deg;
      weights += weight;
    }
  }
  return weights > 0 ? sum / weights : kNone;
}

double GridNumbers::at(const SurfacePoint& point) const {
  const Vector3 normal = smooth_normal(point);
  const auto [place, leaf] = leaves_.beside(point.place, normal);
  if (leaf == kNoCell) return kNone;
  if (number_ == SurfaceNumber::kAlignment) return alignment_of(block_at(place), normal);
  const LeafBlock below = block_at(place - kEnergyDepth * field_.tree.cell_size(leaf) * normal);
  if (below.home == leaf) return energy_of(below);
  const LeafBlock block = block_at(place);
  return energy_of(block.holds(below.home) ? below : block);
}

double GridNumbers::energy_at(const Vector3& place) const {
  return energy_of(block_at(place));
}

std::vector<SurfaceNumbers::Sample> GridNumbers::samples() const {
  const std::size_t step = spots_->size() / kMostSamples + 1;
  std::vector<SurfaceNumbers::Sample> samples((spots_->size() + step - 1) / step);
  parallel_for(samples.size(), [&](std::size_t i) {
    const SurfaceSpot& spot = (*spots_)[step * i];
    samples[i] = {at(spot.on(surface_)), static_cast<double>(spot.area)};
  });
  return samples;
}

std::vector<SurfaceNumbers::LeafCorners> GridNumbers::at_leaf_corners(const CornersOfLeaves& corners) const {
  // Surfaces of many small triangles have many pieces in a cell, of which some are enough.
  std::vector<std::uint16_t> counts(field_.tree.size(), 0), passed(field_.tree.size(), 0);
  for (const SurfaceSpot& spot : *spots_)
    if (spot.leaf != kNoCell && counts[spot.leaf] < UINT16_MAX) ++counts[spot.leaf];
  const auto step_in = [&](CellIndex leaf) { return (counts[leaf] + kFitted - 1) / kFitted; };
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t i = 0; i < spots_->size(); ++i) {
    const CellIndex leaf = (*spots_)[i].leaf;
    if (leaf != kNoCell && passed[leaf]++ % step_in(leaf) == 0) chosen.push_back(i);
  }
  std::vector<float> numbers(chosen.size());
  parallel_for(chosen.size(), [&](std::size_t i) {
    numbers[i] = static_cast<float>(at((*spots_)[chosen[i]].on(surface_)));
  });
  LeafCornerMeans means(field_, corners);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    SurfaceSpot spot = (*spots_)[chosen[i]];
    spot.area *= static_cast<float>(step_in(spot.leaf));
    if (std::isfinite(numbers[i])) means.add(spot, spot.on(surface_).place, static_cast<double>(numbers[i]));
  }
  return means.result();
}

}  // namespace crossgrain
