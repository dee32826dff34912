// SPDX-License-Identifier: Apache-2.0
#include "page/drawn_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/vector3.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

constexpr Vector3 kOrigin{0.1, -0.2, 0.3};

/// A sphere of 20,480 triangles.
SolvedSurface fine_sphere() {
  TriangleMesh mesh = make_sphere(0.7, 5);
  SolvedSurface surface;
  surface.vertices = std::move(mesh.vertices);
  surface.triangles = std::move(mesh.triangles);
  return surface;
}

double area_of(const SolvedSurface& surface) {
  double area = 0;
  for (const auto& [a, b, c] : surface.triangles)
    area += 0.5 *
            norm(cross(surface.vertices[b] - surface.vertices[a], surface.vertices[c] - surface.vertices[a]));
  return area;
}

TEST(DrawnSurface, IsOnVerticesOfTheSurfaceHoweverManyTrianglesItHas) {
  const SolvedSurface sphere = fine_sphere();
  for (const std::size_t most : {100u, 1000u, 5000u, 30000u}) {  // clustered, both ways, contracted, whole
    const DrawnSurface drawn = drawn_surface(sphere.vertices, sphere.triangles, kOrigin, most);
    ASSERT_EQ(drawn.positions.size(), 3 * drawn.originals.size());
    EXPECT_LE(drawn.vertices.size(), 3 * std::max<std::size_t>(3 * most / 2, 100));
    EXPECT_GE(drawn.vertices.size(), 3 * std::min<std::size_t>(most / 3, sphere.triangles.size()));
    EXPECT_LT(*std::max_element(drawn.vertices.begin(), drawn.vertices.end()), drawn.originals.size());
    for (std::size_t v = 0; v < drawn.originals.size(); ++v)
      for (std::size_t axis = 0; axis < 3; ++axis)
        ASSERT_EQ(drawn.positions[3 * v + axis],
                  static_cast<float>(sphere.vertices[drawn.originals[v]][axis] - kOrigin[axis]));
  }
}

TEST(ClusteredSurface, IsAboutTheSurfaceWithFewerTriangles) {
  const SolvedSurface sphere = fine_sphere();
  EXPECT_FALSE(clustered_surface(sphere, kOrigin, 2560));
  const auto fewer = clustered_surface(sphere, kOrigin, 2000);
  ASSERT_TRUE(fewer);
  EXPECT_LE(fewer->triangles.size(), 8000u);
  EXPECT_GE(fewer->triangles.size(), 3000u);
  EXPECT_NEAR(area_of(*fewer) / area_of(sphere), 1, 0.02);
  for (const Vector3& vertex : fewer->vertices) EXPECT_NEAR(norm(vertex), 0.7, 1e-12);
}

TEST(DrawnSurface, OfNothingIsNothing) {
  EXPECT_TRUE(drawn_surface({}, {}, kOrigin, 100).vertices.empty());
}

}  // namespace
}  // namespace crossgrain
