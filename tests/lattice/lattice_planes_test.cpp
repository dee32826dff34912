// SPDX-License-Identifier: Apache-2.0
#include "lattice/lattice_planes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/shapes.hpp"

namespace crossgrain {
namespace {

Surface surface_of(TriangleMesh mesh) {
  return prepare_surface(CheckedMesh::derived(std::move(mesh)));
}

bool has(const std::vector<double>& planes, double coordinate) {
  return std::ranges::any_of(planes, [&](double one) { return std::abs(one - coordinate) < 1e-9; });
}

TEST(LatticePlanes, LieOnLargeFacesAndBetweenThemAsFitsTheSizeBest) {
  const Surface surface = surface_of(join_meshes(translate_mesh(make_box({10, 10, 2}), {0, 0, 1}),
                                                 translate_mesh(make_box({3, 3, 3.7}), {0, 0, 6})));
  const LatticePlanes planes = lattice_planes(surface, 1);
  for (const double z : {surface.box.low[2], surface.box.high[2]}) EXPECT_TRUE(has(planes.at[2], z)) << z;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_TRUE(std::ranges::is_sorted(planes.at[axis]));
    for (std::size_t k = 0; k + 1 < planes.at[axis].size(); ++k) {
      const double gap = planes.at[axis][k + 1] - planes.at[axis][k];
      EXPECT_GE(gap, kLeastGap);
      EXPECT_LE(gap, 1.5);
    }
    EXPECT_LT(planes.at[axis].front(), surface.box.low[axis]);
    EXPECT_GT(planes.at[axis].back(), surface.box.high[axis]);
  }
}

TEST(LatticePlanes, OfFacesThatAreTooNearAreThoseOfTheLargest) {
  const Surface surface =
      surface_of(join_meshes(make_box({10, 10, 10}), translate_mesh(make_box({4, 4, 0.2}), {0, 0, 5.1})));
  const LatticePlanes planes = lattice_planes(surface, 1);
  std::size_t near = 0;
  for (const double z : planes.at[2]) near += std::abs(z - surface.box.high[2]) < 0.4;
  EXPECT_EQ(near, 1u);
}

TEST(LatticePlanes, LieOnBothSidesOfThinWallsAndOfHolesIfAskedTo) {
  const Surface plate = surface_of(make_box({10, 10, 0.2}));
  EXPECT_EQ(lattice_planes(plate, 1).cells(2), 2u) << "one plane, and one beyond it on either side";
  const LatticePlanes planes = lattice_planes(plate, 1, {.walls = true});
  for (const double z : {plate.box.low[2], plate.box.high[2]}) EXPECT_TRUE(has(planes.at[2], z));
  const LatticePlanes at_hole =
      lattice_planes(plate, 1, {.walls = false, .holes = {{{1.3, 2.2, 0}, {1.7, 9, 0.2}}}});
  EXPECT_TRUE(has(at_hole.at[0], 1.3));
  EXPECT_TRUE(has(at_hole.at[0], 1.7));
  EXPECT_FALSE(has(at_hole.at[1], 2.2)) << "the hole is wide there";
}

}  // namespace
}  // namespace crossgrain
