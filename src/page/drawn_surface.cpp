// SPDX-License-Identifier: Apache-2.0
#include "page/drawn_surface.hpp"

#include <meshoptimizer.h>

#include <algorithm>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// As a share of the surface's extent: any, for what counts is the number of triangles.
constexpr float kAnyError = 1;

/// How many times as many triangles as asked for are few enough.
constexpr double kEnough = 1.5;

}  // namespace

DrawnSurface drawn_surface(const SolvedSurface& surface, const Vector3& origin, std::size_t most) {
  DrawnSurface drawn;
  drawn.positions.reserve(3 * surface.vertices.size());
  for (const Vector3& vertex : surface.vertices)
    for (std::size_t axis = 0; axis < 3; ++axis)
      drawn.positions.push_back(static_cast<float>(vertex[axis] - origin[axis]));
  drawn.vertices.reserve(3 * surface.triangles.size());
  for (const auto& triangle : surface.triangles)
    drawn.vertices.insert(drawn.vertices.end(), triangle.begin(), triangle.end());
  if (drawn.vertices.empty()) return {};

  const std::size_t count = surface.vertices.size(), stride = 3 * sizeof(float);
  std::vector<std::uint32_t>& vertices = drawn.vertices;
  if (surface.triangles.size() > most) {
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
  // Vertices in the order of their triangles, those of none left out: fewer bytes, and better packed.
  std::vector<float> positions(drawn.positions.size());
  positions.resize(3 * meshopt_optimizeVertexFetch(positions.data(), vertices.data(), vertices.size(),
                                                   drawn.positions.data(), count, stride));
  drawn.positions.swap(positions);
  return drawn;
}

}  // namespace crossgrain
