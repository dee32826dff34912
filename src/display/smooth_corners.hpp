// SPDX-License-Identifier: Apache-2.0
// Which triangles of a surface continue each other smoothly at a vertex.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/lists.hpp"
#include "base/vector3.hpp"

namespace crossgrain {

/// For each triangle and corner, the triangles at that vertex whose normals are within 32 degrees of its own:
/// they are shown as one curved face. Refers to `triangles`. Safe to use from any number of threads.
class SmoothCorners {
 public:
  SmoothCorners(const std::vector<Vector3>& vertices,
                const std::vector<std::array<std::uint32_t, 3>>& triangles);

  /// Normal of a triangle with twice its area as length.
  const Vector3& area_vector(std::size_t triangle) const { return area_vectors_[triangle]; }
  const Vector3& normal(std::size_t triangle) const { return normals_[triangle]; }

  /// Calls visit(other) for each of them, `triangle` itself included, in ascending order.
  template <class Visit>
  void for_each_at(std::size_t triangle, std::size_t corner, const Visit& visit) const {
    const std::uint32_t vertex = triangles_[triangle][corner];
    for (const std::uint32_t other : at_vertices_[vertex])
      if (other == triangle || dot(normals_[other], normals_[triangle]) > least_cosine_) visit(other);
  }

 private:
  const std::vector<std::array<std::uint32_t, 3>>& triangles_;
  double least_cosine_;
  std::vector<Vector3> area_vectors_, normals_;
  Lists<std::uint32_t> at_vertices_;  ///< the triangles at each vertex
};

using CornerNormals = std::vector<std::array<std::array<float, 3>, 3>>;

/// Unit normals at the corners of each triangle for smooth shading: the mean over the triangles that continue
/// it, weighted by area.
CornerNormals corner_normals(const SmoothCorners& corners, std::size_t triangles);

}  // namespace crossgrain
