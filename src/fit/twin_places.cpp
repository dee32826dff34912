// SPDX-License-Identifier: Apache-2.0
#include "fit/twin_places.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "measure/hex_validity.hpp"

namespace crossgrain {
namespace {

/// A sixty-fourth of the depth is no room for a layer.
constexpr int kMostHalvings = 6;

/// Edges at right angles add up, as in a corner of a box; of parallel ones the mean is taken.
Vector3 sum_of_directions(std::span<const Vector3> edges) {
  Vector3 sum{0, 0, 0};
  for (const Vector3& edge : edges) {
    double alike = 0;
    for (const Vector3& other : edges) {
      const double cosine = std::max(0.0, dot(normalised(edge), normalised(other)));
      alike += cosine * cosine * cosine * cosine;
    }
    if (alike > 0) sum += (1 / alike) * edge;
  }
  return sum;
}

}  // namespace

TwinPlaces::TwinPlaces(const HexMesh& mesh, const std::vector<std::uint32_t>& original,
                       std::vector<TwinCorner> corners)
    : directions_(original.size(), Vector3{0, 0, 0}) {
  for (const std::uint32_t vertex : original) origins_.push_back(mesh.vertices[vertex]);
  std::ranges::sort(corners);
  const auto repeated = std::ranges::unique(corners);
  corners.erase(repeated.begin(), repeated.end());
  std::vector<Vector3> edges;
  for (std::size_t k = 0; k < corners.size();) {
    const std::uint32_t twin = corners[k].twin;
    edges.clear();
    for (; k < corners.size() && corners[k].twin == twin; ++k)
      edges.push_back(mesh.vertices[corners[k].inward] - origins_[twin]);
    directions_[twin] = sum_of_directions(edges);
  }
}

std::vector<std::uint32_t> TwinPlaces::put(HexMesh& mesh, std::size_t first, double depth) const {
  std::vector<double> depths(origins_.size(), depth);
  mesh.vertices.resize(first + origins_.size());
  const auto place = [&](std::size_t twin) {
    mesh.vertices[first + twin] = origins_[twin] + depths[twin] * directions_[twin];
  };
  for (std::size_t twin = 0; twin < origins_.size(); ++twin) place(twin);
  std::vector<std::uint32_t> inverted;
  for (std::uint32_t h = 0; h < mesh.hexahedra.size(); ++h)
    if (std::ranges::any_of(mesh.hexahedra[h], [&](std::uint32_t v) { return v >= first; }))
      inverted.push_back(h);
  const std::vector<std::uint32_t> touched = inverted;
  for (int halving = 0;; ++halving) {
    std::vector<std::uint8_t> is_bad(touched.size());
    parallel_for(touched.size(), [&](std::size_t k) { is_bad[k] = !is_valid(corners_of(mesh, touched[k])); });
    inverted.clear();
    for (std::size_t k = 0; k < touched.size(); ++k)
      if (is_bad[k]) inverted.push_back(touched[k]);
    if (inverted.empty() || halving == kMostHalvings) return inverted;
    std::vector<std::size_t> nearer;
    for (const std::uint32_t h : inverted)
      for (const std::uint32_t v : mesh.hexahedra[h])
        if (v >= first) nearer.push_back(v - first);
    std::ranges::sort(nearer);
    nearer.erase(std::unique(nearer.begin(), nearer.end()), nearer.end());
    for (const std::size_t twin : nearer) {
      depths[twin] *= 0.5;
      place(twin);
    }
  }
}

}  // namespace crossgrain
