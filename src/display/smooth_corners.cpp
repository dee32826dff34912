// SPDX-License-Identifier: Apache-2.0
#include "display/smooth_corners.hpp"

#include <cmath>
#include <numbers>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

/// Largest angle between faces that are shown as one curved face.
constexpr double kSmoothDeg = 32;

}  // namespace

SmoothCorners::SmoothCorners(const std::vector<Vector3>& vertices,
                             const std::vector<std::array<std::uint32_t, 3>>& triangles)
    : triangles_(triangles),
      least_cosine_(std::cos(kSmoothDeg * std::numbers::pi / 180)),
      area_vectors_(triangles.size()),
      normals_(triangles.size()),
      at_vertices_(vertices.size(), [&](const auto& add) {
        for (std::uint32_t t = 0; t < triangles.size(); ++t)
          for (const std::uint32_t vertex : triangles[t]) add(vertex, t);
      }) {
  parallel_for(triangles.size(), [&](std::size_t t) {
    const auto& [a, b, c] = triangles[t];
    area_vectors_[t] = cross(vertices[b] - vertices[a], vertices[c] - vertices[a]);
    normals_[t] = normalised(area_vectors_[t]);
  });
}

CornerNormals corner_normals(const SmoothCorners& corners, std::size_t triangles) {
  CornerNormals normals(triangles);
  parallel_for(triangles, [&](std::size_t t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Vector3 sum{0, 0, 0};
      corners.for_each_at(t, corner, [&](std::uint32_t other) { sum += corners.area_vector(other); });
      const Vector3 normal = normalised(sum);
      for (std::size_t k = 0; k < 3; ++k) normals[t][corner][k] = static_cast<float>(normal[k]);
    }
  });
  return normals;
}

}  // namespace crossgrain
