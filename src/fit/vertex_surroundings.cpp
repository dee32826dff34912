// SPDX-License-Identifier: Apache-2.0
#include "fit/vertex_surroundings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "fit/corner_shape.hpp"
#include "measure/hex_faces.hpp"

namespace crossgrain {
namespace {

/// A corner of 0.1 counts as 130 of 0.4.
constexpr int kWorstPower = 12;

/// base^(kWorstPower - 1), by products.
double eleventh_power(double base) {
  static_assert(kWorstPower == 12);
  const double square = base * base, fourth = square * square;
  return fourth * fourth * square * base;
}

}  // namespace

double scaled_jacobian_of(const HexCorners& corners) {
  double least = 1;
  for (std::size_t k = 0; k < 8; ++k) least = std::min(least, CornerShape(corners, k).value);
  return least;
}

VertexSurroundings::VertexSurroundings(const HexMesh& mesh, std::span<const std::uint32_t> uses) {
  for (const std::uint32_t use : uses) uses_.push_back({use / 8, use % 8, corners_of(mesh, use / 8)});
}

void VertexSurroundings::move_to(const Vector3& place) {
  for (Use& use : uses_) use.corners[use.corner] = place;
}

bool VertexSurroundings::are_valid() const {
  return std::all_of(uses_.begin(), uses_.end(), [](const Use& use) { return is_valid(use.corners); });
}

double VertexSurroundings::least_scaled_jacobian() const {
  double least = 1;
  for (const Use& use : uses_) least = std::min(least, scaled_jacobian_of(use.corners));
  return least;
}

double VertexSurroundings::mean_edge() const {
  double sum = 0;
  for (const Use& use : uses_)
    for (const std::uint8_t other : kHexNeighbours[use.corner])
      sum += norm(use.corners[other] - use.corners[use.corner]);
  return sum / (3 * static_cast<double>(uses_.size()));
}

double VertexSurroundings::least_edge() const {
  double least = INFINITY;
  for (const Use& use : uses_)
    for (const std::uint8_t other : kHexNeighbours[use.corner])
      least = std::min(least, norm(use.corners[other] - use.corners[use.corner]));
  return least;
}

double VertexSurroundings::mean_size(std::span<const double> sizes) const {
  double sum = 0;
  for (const Use& use : uses_) sum += sizes[use.hexahedron];
  return sum / static_cast<double>(uses_.size());
}

double VertexSurroundings::energy(std::span<const double> sizes, const CornerEnergyOptions& options) const {
  double sum = 0;
  for (const Use& use : uses_) sum += energy_at(use.corners, use.corner, 1 / sizes[use.hexahedron], options);
  return sum;
}

bool VertexSurroundings::add_energy(std::span<const double> sizes, const CornerEnergyOptions& options,
                                    SecondOrder& sum) const {
  return std::all_of(uses_.begin(), uses_.end(), [&](const Use& use) {
    return add_energy_at(use.corners, use.corner, 1 / sizes[use.hexahedron], options, sum);
  });
}

double VertexSurroundings::badness() const {
  double sum = 0;
  const auto add = [&](const CornerShape& shape) {
    sum += eleventh_power(1 - shape.value) * (1 - shape.value);
  };
  for (const Use& use : uses_) {
    add(CornerShape(use.corners, use.corner));
    for (const std::uint8_t other : kHexNeighbours[use.corner]) add(CornerShape(use.corners, other));
  }
  return sum;
}

Vector3 VertexSurroundings::badness_gradient() const {
  Vector3 sum{0, 0, 0};
  for (const Use& use : uses_) {
    const CornerShape own(use.corners, use.corner);
    if (!(own.lengths > 0)) continue;
    const double factor = kWorstPower * eleventh_power(1 - own.value);
    for (std::size_t n = 0; n < 3; ++n) sum += factor * own.by_edge(n);
    for (const std::uint8_t other : kHexNeighbours[use.corner]) {
      const CornerShape shape(use.corners, other);
      if (!(shape.lengths > 0)) continue;
      const auto& around = kHexNeighbours[other];
      const auto at = std::find(around.begin(), around.end(), use.corner) - around.begin();
      sum += -kWorstPower * eleventh_power(1 - shape.value) * shape.by_edge(static_cast<std::size_t>(at));
    }
  }
  return sum;
}

std::vector<std::vector<std::uint32_t>> independent_sets(const HexMesh& mesh,
                                                         const Lists<std::uint32_t>& uses) {
  constexpr std::uint32_t kNone = UINT32_MAX;
  std::vector<std::uint32_t> set_of(mesh.vertices.size(), kNone);
  std::vector<std::vector<std::uint32_t>> sets;
  std::vector<std::uint32_t> taken_by;  // the vertex that found the set taken last
  Checkpoint checkpoint;
  for (std::uint32_t v = 0; v < set_of.size(); ++v) {
    checkpoint.pass();
    for (const std::uint32_t use : uses[v])
      for (const std::uint32_t w : mesh.hexahedra[use / 8])
        if (set_of[w] != kNone) taken_by[set_of[w]] = v;
    std::uint32_t set = 0;
    while (set < sets.size() && taken_by[set] == v) ++set;
    if (set == sets.size()) sets.emplace_back(), taken_by.push_back(kNone);
    set_of[v] = set;
    sets[set].push_back(v);
  }
  return sets;
}

}  // namespace crossgrain
