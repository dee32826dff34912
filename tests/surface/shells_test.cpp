// SPDX-License-Identifier: Apache-2.0
#include "surface/shells.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "support/shapes.hpp"

namespace crossgrain {
namespace {

/// Both meshes without common vertices.
TriangleMesh together(TriangleMesh mesh, const TriangleMesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({first + a, first + b, first + c});
  return mesh;
}

TEST(EulerNumbersOfShells, AreTwoLessTwoForEachTunnel) {
  EXPECT_EQ(euler_numbers_of_shells(make_sphere(1, 2).triangles), std::vector{2});
  EXPECT_EQ(euler_numbers_of_shells(make_torus(0.6, 0.25, 12, 8).triangles), std::vector{0});
  EXPECT_EQ(euler_numbers_of_shells(together(make_sphere(1, 1), make_torus(5, 1, 9, 6)).triangles),
            (std::vector{0, 2}));
}

TEST(EulerNumbersOfShells, CountAVertexOfTwoShellsOnceForEach) {
  TriangleMesh two = together(make_box({1, 1, 1}), make_box({1, 1, 1}));
  const auto first = static_cast<std::uint32_t>(two.vertices.size() / 2);
  for (auto& triangle : two.triangles)
    for (std::uint32_t& vertex : triangle) vertex = vertex == first ? 0 : vertex;
  EXPECT_EQ(euler_numbers_of_shells(two.triangles), (std::vector{2, 2}));
}

TEST(EulerNumbersOfShells, AreNoneOfWhatDoesNotCloseUp) {
  TriangleMesh mesh = make_box({1, 1, 1});
  mesh.triangles.pop_back();
  EXPECT_TRUE(euler_numbers_of_shells(mesh.triangles).empty());
  EXPECT_TRUE(euler_numbers_of_shells({}).empty());
}

TEST(BodiesIn, AreNoVoids) {
  TriangleMesh hollow = make_sphere(1, 2), core = make_sphere(0.3, 2);
  TriangleMesh wall = make_sphere(0.6, 2);
  for (auto& [a, b, c] : wall.triangles) std::swap(b, c);
  const TriangleMesh all = together(together(hollow, wall), core);
  const std::vector<ShellBody> bodies = bodies_in(all.triangles, all.vertices);
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_NEAR(bodies[1].volume / bodies[0].volume, 0.027, 1e-9);
  EXPECT_NEAR(bodies[1].box.high[0], 0.3, 1e-9);
  EXPECT_TRUE(bodies_in({}, {}).empty());
}

TEST(EulerNumbersOfShells, DoNotCountTrianglesWithARepeatedVertex) {
  TriangleMesh mesh = make_box({1, 1, 1});
  mesh.triangles.push_back({0, 0, 1});
  EXPECT_EQ(euler_numbers_of_shells(mesh.triangles), std::vector{2});
}

}  // namespace
}  // namespace crossgrain
