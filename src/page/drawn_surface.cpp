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

/// What meshoptimizer gives for the place of a vertex without triangles.
constexpr std::uint32_t kUnused = UINT32_MAX;

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

  const std::size_t count = places.size(), stride = 3 * sizeof(float);
  std::vector<std::uint32_t>& vertices = drawn.vertices;
  if (triangles.size() > most) {
    std::vector<std::uint32_t> fewer(vertices.size());
    fewer.resize(meshopt_simplify(fewer.data(), vertices.data(), vertices.size(), drawn.positions.data(),
                                  count, stride, 3 * most, kAnyError, 0, nullptr));
    if (static_cast<double>(fewer.size()) > kEnough * 3 * static_cast<double>(most)) {
      fewer.resize(vertices.size());
      fewer.resize(meshopt_simplifySloppy(fewer.data(), vertices.data(), vertices.size(),
                                          drawn.positions.data(), count, stride, 3 * most, kAnyError,
                                          nullptr));
    }
    vertices.swap(fewer);
  }
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
