// SPDX-License-Identifier: Apache-2.0
#include "page/drawn_surface.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <cstdint>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Error limit of the simplification, as a share of the surface's extent: no limit, since only the number of
/// triangles matters.
constexpr float kAnyError = 1;

/// Largest accepted number of triangles, as a multiple of the number requested.
constexpr double kEnough = 1.5;

/// Contracting edges takes a microsecond a triangle. Surfaces with more than so many times the number
/// requested are first clustered to this: a page of 1600 pixels does not show the difference.
constexpr std::size_t kClustered = 4;

/// What meshoptimizer gives for the place of a vertex without triangles.
constexpr std::uint32_t kUnused = UINT32_MAX;

constexpr std::size_t kStride = 3 * sizeof(float);

/// Reduces triangles to about so many by joining vertices near one another.
void cluster(const std::vector<float>& positions, std::size_t most, std::vector<std::uint32_t>& vertices) {
  std::vector<std::uint32_t> fewer(vertices.size());
  fewer.resize(meshopt_simplifySloppy(fewer.data(), vertices.data(), vertices.size(), positions.data(),
                                      positions.size() / 3, kStride, 3 * most, kAnyError, nullptr));
  vertices.swap(fewer);
}

/// Reduces triangles to about so many by contracting edges, if there are enough edges.
void contract(const std::vector<float>& positions, std::size_t most, std::vector<std::uint32_t>& vertices) {
  std::vector<std::uint32_t> fewer(vertices.size());
  fewer.resize(meshopt_simplify(fewer.data(), vertices.data(), vertices.size(), positions.data(),
                                positions.size() / 3, kStride, 3 * most, kAnyError, 0, nullptr));
  if (static_cast<double>(fewer.size()) > kEnough * 3 * static_cast<double>(most))
    cluster(positions, most, vertices);
  else
    vertices.swap(fewer);
}

}  // namespace

DrawnSurface drawn_surface(const std::vector<Vector3>& places,
                           const std::vector<std::array<std::uint32_t, 3>>& triangles, const Vector3& origin,
                           std::size_t most) {
  if (triangles.empty()) return {};
  DrawnSurface drawn;
  drawn.positions.reserve(3 * places.size());
  for (const Vector3& place : places)
    for (std::size_t axis = 0; axis < 3; ++axis)
      drawn.positions.push_back(static_cast<float>(place[axis] - origin[axis]));
  drawn.vertices.reserve(3 * triangles.size());
  for (const auto& triangle : triangles)
    drawn.vertices.insert(drawn.vertices.end(), triangle.begin(), triangle.end());

  const std::size_t count = places.size();
  std::vector<std::uint32_t>& vertices = drawn.vertices;
  if (triangles.size() > 2 * kClustered * most) cluster(drawn.positions, kClustered * most, vertices);
  if (triangles.size() > most) contract(drawn.positions, most, vertices);
  // Vertices in the order of their triangles, without unused ones: fewer bytes, and better compression.
  std::vector<std::uint32_t> order(count);
  const std::size_t used =
      meshopt_optimizeVertexFetchRemap(order.data(), vertices.data(), vertices.size(), count);
  drawn.originals.resize(used);
  std::vector<float> positions(3 * used);
  for (std::uint32_t vertex = 0; vertex < count; ++vertex) {
    if (order[vertex] == kUnused) continue;
    drawn.originals[order[vertex]] = vertex;
    for (std::size_t axis = 0; axis < 3; ++axis)
      positions[3 * order[vertex] + axis] = drawn.positions[3 * vertex + axis];
  }
  for (std::uint32_t& vertex : vertices) vertex = order[vertex];
  drawn.positions.swap(positions);
  return drawn;
}

}  // namespace crossgrain
