// SPDX-License-Identifier: Apache-2.0
#include "page/drawn_surface.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <cstdint>

#include "base/parallel.hpp"
#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Error limit of the simplification, as a share of the surface's extent: no limit, since only the number of
/// triangles matters.
constexpr float kAnyError = 1;

/// Largest accepted number of triangles, as a multiple of the number requested.
constexpr double kEnough = 1.5;

/// Contracting edges takes a microsecond a triangle. Surfaces with more than twice so many times the number
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

/// All triangles of a surface.
DrawnSurface whole_surface(const std::vector<Vector3>& places,
                           const std::vector<std::array<std::uint32_t, 3>>& triangles,
                           const Vector3& origin) {
  DrawnSurface drawn;
  drawn.positions = sized_vector<float>(3 * places.size());
  drawn.originals = sized_vector<std::uint32_t>(places.size());
  parallel_for(places.size(), [&](std::size_t v) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      drawn.positions[3 * v + axis] = static_cast<float>(places[v][axis] - origin[axis]);
    drawn.originals[v] = static_cast<std::uint32_t>(v);
  });
  drawn.vertices = sized_vector<std::uint32_t>(3 * triangles.size());
  parallel_for(triangles.size(), [&](std::size_t t) {
    for (std::size_t k = 0; k < 3; ++k) drawn.vertices[3 * t + k] = triangles[t][k];
  });
  return drawn;
}

/// Puts vertices in the order of their triangles and drops unused ones: fewer bytes, and better compression.
void drop_unused(DrawnSurface& drawn) {
  const std::size_t count = drawn.originals.size();
  std::vector<std::uint32_t> order(count);
  const std::size_t used =
      meshopt_optimizeVertexFetchRemap(order.data(), drawn.vertices.data(), drawn.vertices.size(), count);
  std::vector<std::uint32_t> originals(used);
  std::vector<float> positions(3 * used);
  for (std::uint32_t vertex = 0; vertex < count; ++vertex) {
    if (order[vertex] == kUnused) continue;
    originals[order[vertex]] = drawn.originals[vertex];
    for (std::size_t axis = 0; axis < 3; ++axis)
      positions[3 * order[vertex] + axis] = drawn.positions[3 * vertex + axis];
  }
  for (std::uint32_t& vertex : drawn.vertices) vertex = order[vertex];
  drawn.originals.swap(originals);
  drawn.positions.swap(positions);
}

bool is_to_be_clustered(std::size_t triangles, std::size_t most) {
  return triangles > 2 * kClustered * most;
}

}  // namespace

DrawnSurface drawn_surface(const std::vector<Vector3>& places,
                           const std::vector<std::array<std::uint32_t, 3>>& triangles, const Vector3& origin,
                           std::size_t most) {
  if (triangles.empty()) return {};
  DrawnSurface drawn = whole_surface(places, triangles, origin);
  if (is_to_be_clustered(triangles.size(), most)) {
    cluster(drawn.positions, kClustered * most, drawn.vertices);
    drop_unused(drawn);
  }
  if (drawn.vertices.size() > 3 * most) contract(drawn.positions, most, drawn.vertices);
  drop_unused(drawn);
  return drawn;
}

std::optional<SolvedSurface> clustered_surface(const SolvedSurface& surface, const Vector3& origin,
                                               std::size_t most) {
  if (!is_to_be_clustered(surface.triangles.size(), most)) return std::nullopt;
  DrawnSurface drawn = whole_surface(surface.vertices, surface.triangles, origin);
  cluster(drawn.positions, kClustered * most, drawn.vertices);
  drop_unused(drawn);
  SolvedSurface clustered;
  for (const std::uint32_t vertex : drawn.originals) clustered.vertices.push_back(surface.vertices[vertex]);
  for (std::size_t k = 0; k < drawn.vertices.size(); k += 3)
    clustered.triangles.push_back({drawn.vertices[k], drawn.vertices[k + 1], drawn.vertices[k + 2]});
  return clustered;
}

}  // namespace crossgrain
