// SPDX-License-Identifier: Apache-2.0
#include "sampling/streamline_seeds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "sampling/point_order.hpp"

namespace crossgrain {
namespace {

/// The real roots of g^(k + 1) = g + 1 for sequences of k = 1, 2 and 3 numbers.
constexpr double kGolden = 1.6180339887498948482, kPlastic = 1.3247179572447460260,
                 kCubic = 1.2207440846057594754;

/// Extra draws, as a factor, for a solid much smaller than the box or the cells in which seeds are drawn.
constexpr double kPatience = 100;

/// Depth of seeds below the surface, in cells: lines that run along facets of a curved surface should stay
/// inside. Halved this often where the solid is thin.
constexpr double kDepthCells = 0.25;
constexpr int kHalvings = 3;

/// Depth at which the cell below a point of the surface is looked up, in longest sides: beyond rounding.
constexpr double kJustBelow = 1e-6;

/// Number `draw` of the sequence with this generator, along one of its axes.
double in_sequence(double generator, int axis, std::uint64_t draw) {
  double power = 1;
  for (int k = 0; k <= axis; ++k) power /= generator;
  return std::fmod(0.5 + power * static_cast<double>(draw), 1.0);
}

/// Draws until there are `count` seeds, at most `most` times. seed_of(draw) is empty if it gives none.
template <class Seed, class SeedOf>
std::vector<Seed> drawn(std::size_t count, double most, const Monitor& monitor, const SeedOf& seed_of) {
  std::vector<Seed> seeds;
  for (std::uint64_t draw = 1; seeds.size() < count && static_cast<double>(draw) <= most; ++draw) {
    if (draw % 1024 == 0) monitor.check();
    if (const std::optional<Seed> seed = seed_of(draw)) seeds.push_back(*seed);
  }
  return seeds;
}

/// The cell in which a line may start at a point; kNoLineCell if none may.
LineCell cell_to_start(const LineSpace& space, const Vector3& point) {
  const LineCell cell = space.cell_at(point);
  return cell == kNoLineCell || space.is_at_arc({point, cell}) ? kNoLineCell : cell;
}

/// The triangles of a surface in an order in which those near each other come soon after each other, with
/// areas summed up.
class AreaSequence {
 public:
  explicit AreaSequence(const LineSurface& surface) : surface_(surface) {
    const std::size_t count = surface.triangles.size();
    Box box = empty_box();
    for (const auto& corners : surface.triangles)
      for (const std::uint32_t v : corners) include(box, surface.vertices[v]);
    auto middles = sized_vector<Vector3>(count);
    parallel_for(count, [&](std::size_t t) {
      const auto& [a, b, c] = surface.triangles[t];
      middles[t] = 1.0 / 3 * (surface.vertices[a] + surface.vertices[b] + surface.vertices[c]);
    });
    order_ = morton_order({box.low, longest_side(box)}, middles);
    areas_ = sized_vector<double>(count);
    parallel_for(count, [&](std::size_t k) { areas_[k] = norm(twice_area(order_[k])); });
    std::partial_sum(areas_.begin(), areas_.end(), areas_.begin());
  }

  struct Place {
    Vector3 point, normal;
  };

  Place at(std::uint64_t draw) const {
    const double area = in_sequence(kGolden, 0, draw) * areas_.back();
    const auto found = std::upper_bound(areas_.begin(), areas_.end() - 1, area) - areas_.begin();
    const std::uint32_t triangle = order_[static_cast<std::size_t>(found)];
    double s = in_sequence(kPlastic, 0, draw), t = in_sequence(kPlastic, 1, draw);
    if (s + t > 1) {
      s = 1 - s;
      t = 1 - t;
    }
    const auto& [a, b, c] = surface_.triangles[triangle];
    const Vector3& corner = surface_.vertices[a];
    return {corner + s * (surface_.vertices[b] - corner) + t * (surface_.vertices[c] - corner),
            normalised(twice_area(triangle))};
  }

 private:
  Vector3 twice_area(std::uint32_t triangle) const {
    const auto& [a, b, c] = surface_.triangles[triangle];
    return cross(surface_.vertices[b] - surface_.vertices[a], surface_.vertices[c] - surface_.vertices[a]);
  }

  LineSurface surface_;
  std::vector<std::uint32_t> order_;
  std::vector<double> areas_;
};

}  // namespace

std::vector<Vector3> seeds_in_volume(const LineSpace& space, std::size_t count, const Monitor& monitor) {
  const Box box = space.box_of_seeds();
  const Vector3 sides = box.high - box.low;
  const double share =
      space.volume() / std::max(sides[0] * sides[1] * sides[2], std::numeric_limits<double>::min());
  if (!(share > 0)) return {};
  const double most = kPatience * static_cast<double>(count) / std::min(share, 1.0);
  return drawn<Vector3>(count, most, monitor, [&](std::uint64_t draw) -> std::optional<Vector3> {
    Vector3 point;
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      point[axis] = box.low[axis] + in_sequence(kCubic, k, draw) * sides[axis];
    }
    if (cell_to_start(space, point) == kNoLineCell) return std::nullopt;
    return point;
  });
}

std::vector<StreamlineSeed> seeds_on_surface(const LineSpace& space, std::size_t count,
                                             const Monitor& monitor) {
  const LineSurface surface = space.surface();
  if (surface.triangles.empty()) throw Error(ErrorKind::kUsage, "the field has no surface for seeds");
  const AreaSequence places(surface);
  const double step = kJustBelow * longest_side(space.bounds());
  const double most = kPatience * static_cast<double>(count);
  return drawn<StreamlineSeed>(count, most, monitor,
                               [&](std::uint64_t draw) -> std::optional<StreamlineSeed> {
                                 const auto [point, normal] = places.at(draw);
                                 const LineCell below = space.cell_at(point - step * normal);
                                 if (below == kNoLineCell) return std::nullopt;
                                 double depth = kDepthCells * space.cell_size(below);
                                 for (int k = 0; k < kHalvings; ++k, depth /= 2) {
                                   const StreamlineSeed seed{point - depth * normal, normal};
                                   if (cell_to_start(space, seed.point) != kNoLineCell) return seed;
                                 }
                                 return std::nullopt;
                               });
}

std::vector<StreamlineSeed> seeds_on_cut(const LineSpace& space, int axis, std::optional<double> position,
                                         std::size_t count, const Monitor& monitor) {
  if (axis < 0 || axis > 2) throw Error(ErrorKind::kUsage, "the axis of the cut must be 0, 1 or 2");
  const Box box = space.box_of_seeds();
  const auto across = static_cast<std::size_t>(axis), u = (across + 1) % 3, v = (across + 2) % 3;
  const double at = position.value_or(0.5 * (box.low[across] + box.high[across]));
  if (!(at > box.low[across] && at < box.high[across]))
    throw Error(ErrorKind::kUsage,
                fmt::format("the cut at {} = {:.6g} is outside the part, which extends from {:.6g} to {:.6g}",
                            "xyz"[across], at, box.low[across], box.high[across]));
  StreamlineSeed seed;
  seed.across[across] = 1;
  const double most = kPatience * static_cast<double>(count);
  return drawn<StreamlineSeed>(
      count, most, monitor, [&](std::uint64_t draw) -> std::optional<StreamlineSeed> {
        seed.point[across] = at;
        seed.point[u] = box.low[u] + in_sequence(kPlastic, 0, draw) * (box.high[u] - box.low[u]);
        seed.point[v] = box.low[v] + in_sequence(kPlastic, 1, draw) * (box.high[v] - box.low[v]);
        if (cell_to_start(space, seed.point) == kNoLineCell) return std::nullopt;
        return seed;
      });
}

}  // namespace crossgrain
