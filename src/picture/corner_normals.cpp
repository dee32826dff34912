// SPDX-License-Identifier: Apache-2.0
#include "picture/corner_normals.hpp"

#include <cmath>
#include <numbers>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

/// The triangles at each vertex, sorted by vertex.
struct TrianglesOfVertices {
  std::vector<std::uint32_t> begin, triangles;

  TrianglesOfVertices(std::size_t vertices, const std::vector<std::array<std::uint32_t, 3>>& all)
      : begin(vertices + 1, 0), triangles(3 * all.size()) {
    for (const auto& corners : all)
      for (const std::uint32_t vertex : corners) ++begin[vertex + 1];
    for (std::size_t i = 0; i < vertices; ++i) begin[i + 1] += begin[i];
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t t = 0; t < all.size(); ++t)
      for (const std::uint32_t vertex : all[t]) triangles[next[vertex]++] = static_cast<std::uint32_t>(t);
  }
};

}  // namespace

std::vector<std::array<std::array<float, 3>, 3>> corner_normals(
    const std::vector<Vector3>& vertices, const std::vector<std::array<std::uint32_t, 3>>& triangles,
    double crease_deg) {
  std::vector<Vector3> areas(triangles.size()), units(triangles.size());
  parallel_for(triangles.size(), [&](std::size_t t) {
    const auto& [a, b, c] = triangles[t];
    areas[t] = cross(vertices[b] - vertices[a], vertices[c] - vertices[a]);
    units[t] = normalised(areas[t]);
  });
  const TrianglesOfVertices at(vertices.size(), triangles);
  const double least = std::cos(crease_deg * std::numbers::pi / 180);
  std::vector<std::array<std::array<float, 3>, 3>> normals(triangles.size());
  parallel_for(triangles.size(), [&](std::size_t t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = triangles[t][corner];
      Vector3 sum{0, 0, 0};
      for (std::uint32_t i = at.begin[vertex]; i < at.begin[vertex + 1]; ++i) {
        const std::uint32_t other = at.triangles[i];
        if (other == t || dot(units[other], units[t]) > least) sum += areas[other];
      }
      const Vector3 normal = normalised(sum);
      for (std::size_t k = 0; k < 3; ++k) normals[t][corner][k] = static_cast<float>(normal[k]);
    }
  });
  return normals;
}

}  // namespace crossgrain
