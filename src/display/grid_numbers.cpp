// SPDX-License-Identifier: Apache-2.0
#include "display/grid_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "display/leaf_corner_means.hpp"
#include "measure/alignment.hpp"
#include "sampling/sampling.hpp"

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
      spots_(std::make_shared<const std::vector<SurfaceSpot>>(
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

void GridNumbers::measure_facets() {
  // Sums over the spots of each leaf and direction, in the order of leaves.
  struct Sum {
    Vector3 places{}, normals{};
    double area = 0;
  };
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < spots_->size(); ++i)
    if ((*spots_)[i].leaf != kNoCell) order.push_back(i);
  // Of the triangles themselves, which the solve follows; their mean in a cell is smooth enough.
  const auto normal_at = [&](const SurfaceSpot& spot) {
    const auto& [a, b, c] = surface_.triangles[spot.triangle];
    return normalised(
        cross(surface_.vertices[b] - surface_.vertices[a], surface_.vertices[c] - surface_.vertices[a]));
  };
  std::vector<std::uint64_t> keys(spots_->size());
  parallel_for(spots_->size(), [&](std::size_t i) {
    keys[i] = std::uint64_t{6} * (*spots_)[i].leaf + nearest_direction(normal_at((*spots_)[i]));
  });
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return keys[a] < keys[b]; });
  facets_begin_.assign(field_.tree.size() + 1, 0);
  std::vector<Vector3> places;
  std::vector<CellIndex> leaves;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    Sum sum;
    for (; end < order.size() && keys[order[end]] == keys[order[begin]]; ++end) {
      const SurfaceSpot& spot = (*spots_)[order[end]];
      const auto area = static_cast<double>(spot.area);
      sum.places += area * spot.on(surface_).place;
      sum.normals += area * normal_at(spot);
      sum.area += area;
    }
    facets_.push_back({normalised(sum.normals), sum.area, 0});
    places.push_back((1 / sum.area) * sum.places);
    leaves.push_back((*spots_)[order[begin]].leaf);
    ++facets_begin_[leaves.back() + 1];
  }
  for (std::size_t i = 0; i < field_.tree.size(); ++i) facets_begin_[i + 1] += facets_begin_[i];
  const Sampler sampler(field_.tree, field_.frames, field_.open_faces);
  parallel_for(facets_.size(), [&](std::size_t k) {
    const Box box = field_.tree.root().box(field_.tree[leaves[k]]);
    Vector3 place = places[k];  // the middle of a curved facet is in its leaf, to rounding
    for (std::size_t axis = 0; axis < 3; ++axis)
      place[axis] = std::clamp(place[axis], box.low[axis], box.high[axis]);
    facets_[k].angle_deg = angle_to_nearest_axis_deg(sampler.in_leaf(leaves[k], place), facets_[k].normal);
  });
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

std::vector<SurfaceNumbers::LeafCorners> GridNumbers::at_leaf_corners() const {
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
  LeafCornerMeans means(field_);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    SurfaceSpot spot = (*spots_)[chosen[i]];
    spot.area *= static_cast<float>(step_in(spot.leaf));
    if (std::isfinite(numbers[i])) means.add(spot, spot.on(surface_).place, static_cast<double>(numbers[i]));
  }
  return means.result();
}

}  // namespace crossgrain
