// SPDX-License-Identifier: Apache-2.0
#include "fit/quad_complex.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/vector3.hpp"
#include "fit/hex_lattice.hpp"

namespace crossgrain {
namespace {

using testing::lattice_mesh;

HexMesh two_boxes() {
  return lattice_mesh({3, 2, 2}, [](int x, int, int) { return x < 2 ? 1 : 2; });
}

TEST(QuadComplex, HasTheQuadsEdgesAndVerticesOfABoxsSurface) {
  const QuadComplex complex(two_boxes());
  EXPECT_EQ(complex.quads().size(), 2u * (3 * 2 + 3 * 2 + 2 * 2));
  EXPECT_EQ(complex.vertices().size() + complex.quads().size(), complex.edges().size() + 2);
  for (std::uint32_t e = 0; e < complex.edges().size(); ++e) {
    const auto uses = complex.uses_of_edge(e);
    ASSERT_EQ(uses.size(), 2u);
    EXPECT_NE(uses[0].is_left, uses[1].is_left);
    EXPECT_EQ(complex.across(uses[0].quad, e), uses[1].quad);
  }
}

TEST(QuadComplex, LooksFromTheHigherSolidToTheLower) {
  const HexMesh mesh = two_boxes();
  const QuadComplex complex(mesh, mesh.regions);
  const auto between = [](const QuadComplex::Quad& quad) { return quad.above != 0; };
  EXPECT_EQ(std::ranges::count_if(complex.quads(), between), 4);
  for (const QuadComplex::Quad& quad : complex.quads()) {
    const Vector3 area = area_vector(mesh, quad);
    EXPECT_DOUBLE_EQ(norm(area), 1.0);
    if (between(quad)) {
      EXPECT_EQ(quad.below, 2);
      EXPECT_DOUBLE_EQ(area[0], -1.0);
      EXPECT_EQ(mesh.regions[quad.hexahedron_above], 1);
    }
  }
}

TEST(QuadComplex, GoesCounterClockwiseAroundAVertex) {
  const HexMesh mesh = two_boxes();
  const QuadComplex complex(mesh);
  for (const std::uint32_t v : complex.vertices()) {
    const std::uint32_t first = complex.quads_of(v)[0];
    std::uint32_t last = 0;
    const auto fan = complex.around(
        v, first, [](std::uint32_t) { return false; }, last);
    EXPECT_EQ(std::set<std::uint32_t>(fan.begin(), fan.end()).size(), complex.quads_of(v).size());
    for (const std::uint32_t quad : fan) {
      const auto [from, to] = complex.edges_at(quad, v);
      const auto along = [&](std::uint32_t edge) {
        return mesh.vertices[complex.other_end(edge, v)] - mesh.vertices[v];
      };
      EXPECT_GT(dot(cross(along(from), along(to)), area_vector(mesh, complex.quads()[quad])), 0);
    }
  }
}

TEST(QuadComplex, EndsAFanWhereThreeSolidsMeet) {
  const HexMesh mesh = two_boxes();
  const QuadComplex complex(mesh, mesh.regions);
  for (std::uint32_t q = 0; q < complex.quads().size(); ++q)
    for (const std::uint32_t edge : complex.quads()[q].edges)
      EXPECT_EQ(complex.uses_of_edge(edge).size() == 3, complex.across(q, edge) == QuadComplex::kNone);
}

}  // namespace
}  // namespace crossgrain
