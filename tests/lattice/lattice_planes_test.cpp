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
  for (const double gap : {0.2, 0.01, 0.001}) {
    const Surface boxes = surface_of(
        join_meshes(make_box({10, 10, 4}), translate_mesh(make_box({10, 10, 4}), {0, 0, 4 + gap})));
    EXPECT_EQ(lattice_planes(boxes, 1).cells(2), 2 + 8) << "one plane for both sides of a gap of " << gap;
    const LatticePlanes planes = lattice_planes(boxes, 1, {.walls = true});
    for (const double z : {2.0, 2 + gap}) EXPECT_TRUE(has(planes.at[2], z)) << gap;
  }
  const Surface plate = surface_of(make_box({10, 10, 0.2}));
  const LatticePlanes at_hole =
      lattice_planes(plate, 1, {.walls = false, .boxes = {{{1.3, 2.2, 0}, {1.7, 9, 0.2}}}});
  EXPECT_TRUE(has(at_hole.at[0], 1.3));
  EXPECT_TRUE(has(at_hole.at[0], 1.7));
  EXPECT_FALSE(has(at_hole.at[1], 2.2)) << "the hole is wide there";
}

TEST(LatticePlanes, LieOnBothSidesOfThinWallsBesideHolesIfAskedTo) {
  const Surface box = surface_of(make_box({10, 10, 10}));
  const auto planes = [&](const Box& hole, bool is_boss) {
    return lattice_planes(box, 1, {.walls = true, .holes = {{hole, is_boss}}}).at[0];
  };
  for (const double thickness : {0.6, 0.1, 0.03}) {
    EXPECT_TRUE(has(planes({{1, -2, 0}, {5 - thickness, 2, 5}}, false), 5 - thickness)) << thickness;
    EXPECT_TRUE(has(planes({{thickness - 5, -2, 0}, {1, 2, 5}}, false), thickness - 5)) << thickness;
  }
  EXPECT_FALSE(has(planes({{1, -2, 0}, {3.7, 2, 5}}, false), 3.7)) << "the wall is thick";
  EXPECT_FALSE(has(planes({{1, -2, 0}, {4.9, 2, 5}}, true), 4.9)) << "there is no gap beside a boss";
  const Surface walls = surface_of(join_meshes(make_box({10, 10, 10}), flip_mesh(make_box({8, 8, 8}))));
  for (const double side : {3.8, -3.8})
    EXPECT_TRUE(has(
        lattice_planes(
            walls, 1,
            {.walls = true, .holes = {{{{std::min(side, 0.0), -2, -2}, {std::max(side, 0.0), 2, 2}}, true}}})
            .at[0],
        side))
        << "a gap beside a boss";
  EXPECT_FALSE(has(planes({{1, 6, 0}, {4.9, 8, 5}}, false), 4.9)) << "the hole is not beside the face";
  const std::vector<double> between =
      lattice_planes(box, 1,
                     {.walls = true, .holes = {{{{-3, -2, 0}, {0.3, 2, 5}}}, {{{0.7, -2, 0}, {3, 2, 5}}}}})
          .at[0];
  EXPECT_TRUE(has(between, 0.3) && has(between, 0.7)) << "a wall between two holes";
}

TEST(LatticePlanes, LieOnBothSidesOfSheetsAndNeedles) {
  for (const double thickness : {0.5, 0.01, 1e-4}) {
    for (const Vector3& sides : {Vector3{10, 10, thickness}, Vector3{10, thickness, thickness}}) {
      const LatticePlanes planes = lattice_planes(surface_of(make_box(sides)), 1);
      for (const double z : {-0.5 * thickness, 0.5 * thickness})
        EXPECT_TRUE(std::ranges::any_of(planes.at[2], [&](double at) { return std::abs(at - z) < 1e-12; }))
            << z;
    }
  }
}

TEST(LatticePlanes, AreNearerAtFinePlacesAndGrowApartSlowly) {
  const Surface box = surface_of(make_box({20, 20, 20}));
  const LatticePlanes planes = lattice_planes(box, 2, {.fine = {{{4, 0, 0}, 0.5, {1, 0, 0}}}});
  const std::vector<double>& x = planes.at[0];
  double least = 2;
  for (std::size_t k = 1; k + 2 < x.size(); ++k) {
    const double gap = x[k + 1] - x[k], before = x[k] - x[k - 1];
    least = std::min(least, gap);
    EXPECT_LT(std::max(gap / before, before / gap), 1.75) << x[k];
    if (std::abs(x[k] - 4) < 0.5) {
      EXPECT_NEAR(gap, 0.55, 0.1);
    }
  }
  EXPECT_NEAR(least, 0.5, 0.1);
  EXPECT_NEAR(x[2] - x[1], 2, 0.2) << "far away";
  EXPECT_EQ(planes.cells(1), lattice_planes(box, 2).cells(1)) << "the surface there lies along y";
  const LatticePlanes all = lattice_planes(box, 2, {.fine = {{{4, 0, 0}, 0.5}}});
  EXPECT_EQ(all.cells(0), planes.cells(0));
  EXPECT_EQ(all.cells(1), all.cells(2));
  EXPECT_GT(all.cells(1), planes.cells(1));
}

TEST(LatticePlanes, LieAtLinesThatAreLongAndNotNearToOthers) {
  const Surface box = surface_of(make_box({10, 10, 10}));
  const auto has_plane_at = [&](double x, const Box& line) {
    return has(lattice_planes(box, 1, {.lines = {line}}).at[0], x);
  };
  EXPECT_TRUE(has_plane_at(1.7, {{1.7, -4, 3}, {1.7, 4, 3}}));
  EXPECT_FALSE(has_plane_at(1.7, {{1.7, 0, 3}, {1.7, 1, 3}})) << "short";
  EXPECT_FALSE(has_plane_at(4.6, {{4.6, -4, 3}, {4.6, 4, 3}})) << "near to the border";
  EXPECT_FALSE(has_plane_at(1.7, {{1.4, -4, 3}, {2, 4, 3}})) << "not across";
}

TEST(PlaneDistance, CountsWhatItPlaces) {
  const PlaneDistance distance(2, {{{1, 0, 0}, 0.25}, {{3, 0, 0}, 0.5}}, 0);
  EXPECT_EQ(distance.at(1), 0.25);
  EXPECT_EQ(distance.at(-50), 2);
  const double all = distance.between(-8, 9);
  EXPECT_GT(all, 17 / 2.0);
  for (const double share : {0.1, 0.5, 0.9}) {
    const double at = distance.after(-8, 9, share * all);
    EXPECT_NEAR(distance.between(-8, at), share * all, 0.02 * all) << share;
  }
  EXPECT_EQ(distance.after(-8, 9, 2 * all), 9);
}

}  // namespace
}  // namespace crossgrain
