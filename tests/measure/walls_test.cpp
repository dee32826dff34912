// SPDX-License-Identifier: Apache-2.0
#include "measure/walls.hpp"

#include <gtest/gtest.h>

#include "support/shapes.hpp"

namespace crossgrain {
namespace {

constexpr double kWanted = 4;

SolveReport::Walls walls_of(const TriangleMesh& mesh, double cell_size) {
  const Surface surface = prepare_surface(mesh);
  const TriangleBvh bvh(surface);
  const WindingNumber winding(bvh);
  const Solid solid{surface, bvh, winding};
  const auto [root, depth] = frame_around(surface.box, cell_size);
  return measure_walls(uniform_level(solid, root, depth).level, solid);
}

TEST(Walls, OfAPlateAreThinOverItsTwoSidesOnly) {
  const double thickness = 0.1, cell_size = 1.0 / 16;
  const auto walls = walls_of(make_wall(thickness), cell_size);
  EXPECT_NEAR(walls.thinnest_cells, thickness / cell_size, 1e-6);
  // Leaves at the rim hold both sides and rim, and are judged by the larger part.
  EXPECT_NEAR(walls.thin_share, 2 / (2 + 4 * thickness), 0.1);
  EXPECT_EQ(walls.cells_wanted, kWanted);
}

TEST(Walls, OfABoxAreThickForAllItsEdges) {
  const Quaternion tilt = from_rotation_vector({0.4, -0.7, 0.5});
  const auto walls = walls_of(rotate_mesh(make_box({1.4, 1.2, 0.6}), tilt), 1.0 / 16);
  EXPECT_EQ(walls.thin_share, 0);
  EXPECT_NEAR(walls.thinnest_cells, 0.6 * 16, 1e-6);
  EXPECT_EQ(walls.two_sheet_cells, 0u);
}

TEST(Walls, OfASphereAreItsDiameter) {
  const double radius = 0.8;
  const auto walls = walls_of(make_sphere(radius, 3), 1.0 / 8);
  EXPECT_EQ(walls.thin_share, 0);
  // The facets cut in by 1 - cos of half an edge's angle, 0.5 % of the radius.
  EXPECT_NEAR(walls.thinnest_cells, 2 * radius * 8, 0.02 * 2 * radius * 8);
}

TEST(Walls, OfAWedgeAreThinTowardsItsTip) {
  // A prism of three sides with angles of 20 degrees at two edges is thinner than four cells over a part of
  // it.
  TriangleMesh wedge = make_cylinder(0.5, 0.5, 3);
  for (Vector3& vertex : wedge.vertices) vertex[0] *= 0.2;
  const auto walls = walls_of(wedge, 1.0 / 32);
  EXPECT_GT(walls.thin_share, 0.1);
  EXPECT_LT(walls.thinnest_cells, 1);
}

TEST(Walls, ThinnerThanACellHaveBothTheirSheetsInOneCell) {
  EXPECT_GT(walls_of(make_wall(0.02), 1.0 / 16).two_sheet_cells, 100u);
}

TEST(Walls, AreMeasuredInsideAGapOnly) {
  // Two plates 0.4 thick with a gap of a tenth of a cell: the gap is no wall.
  const auto walls = walls_of(make_plates(0.1 / 16), 1.0 / 16);
  EXPECT_NEAR(walls.thinnest_cells, 0.4 * 16, 1e-6);
}

TEST(Walls, AreResolvedWithTheNumberOfCellsThatIsNamed) {
  const Quaternion tilt = from_rotation_vector({0.4, -0.7, 0.5});
  for (const auto& [name, mesh] : {std::pair{"plate", make_wall(0.1)},
                                   {"thirds", make_wall(1.0 / 30)},
                                   {"tilted plate", rotate_mesh(make_wall(0.1), tilt)},
                                   {"rod", make_cylinder(0.04, 0.5, 24)}}) {
    SCOPED_TRACE(name);
    const double side = longest_side(box_of(mesh.vertices));
    const int needed = walls_of(mesh, side / 16).resolution_needed;
    ASSERT_GT(needed, 16);
    const auto walls = walls_of(mesh, side / needed);
    EXPECT_EQ(walls.resolution_needed, 0) << needed << ", " << walls.thin_share;
    EXPECT_GT(walls_of(mesh, side / (0.8 * needed)).resolution_needed, 0);
  }
}

TEST(Walls, OfAPlateNeedAsManyCellsAsAreWantedAcross) {
  // A margin for rounding, and the next number.
  EXPECT_NEAR(walls_of(make_wall(0.1), 1.0 / 16).resolution_needed, kWanted / 0.1, 1);
}

}  // namespace
}  // namespace crossgrain
