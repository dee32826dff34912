// SPDX-License-Identifier: Apache-2.0
#include "surface/creases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vector3.hpp"
#include "harmonics/random_samples.hpp"
#include "support/curved_shapes.hpp"
#include "support/extrusion.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::RandomSamples;

constexpr CreaseAngles kAngles;

double length_of(const CreaseCurve& curve) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < curve.points.size(); ++k)
    sum += norm(curve.points[k + 1] - curve.points[k]);
  return sum;
}

double length_of(const std::vector<CreaseCurve>& curves) {
  double sum = 0;
  for (const CreaseCurve& curve : curves) sum += length_of(curve);
  return sum;
}

TEST(Creases, OfEdgesThatGoStraightOnInEachOtherCountAsOneAtACorner) {
  const auto line = [](const Vector3& to) {
    return CreaseCurve{{Vector3{0, 0, 0}, to}, {normalised(to), normalised(to)}};
  };
  // Where a face between two boxes meets an edge of both.
  const std::vector<CreaseCurve> at_edge{line({1, 0, 0}), line({-1, 0, 0}), line({0, 1, 0}), line({0, 0, 1})};
  const std::vector<CreaseCorner> corners = corners_of(at_edge);
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_EQ(corners[0].curves, 4u);
  EXPECT_EQ(corners[0].directions, 3u);
  // A pyramid's apex.
  const std::vector<CreaseCurve> at_apex{line({1, 0, -1}), line({-1, 0, -1}), line({0, 1, -1}),
                                         line({0, -1, -1})};
  EXPECT_EQ(corners_of(at_apex)[0].directions, 4u);
}

TEST(Creases, OfTaggedEdgesAreCurvesWhateverTheSurfaceDoes) {
  const Surface sphere = prepare_surface(make_sphere(0.5, 1));
  const auto& [a, b, c] = sphere.mesh.triangles[0];
  EXPECT_TRUE(sharp_curves(sphere, kAngles).empty());
  const std::vector<std::array<std::uint32_t, 2>> tagged{{a, b}, {b, c}, {b, a}};
  const std::vector<CreaseCurve> curves = sharp_curves(sphere, kAngles, tagged);
  EXPECT_NEAR(
      length_of(curves),
      norm(sphere.corners(0)[0] - sphere.corners(0)[1]) + norm(sphere.corners(0)[1] - sphere.corners(0)[2]),
      1e-12);
}

TEST(Creases, OfABoxAreItsTwelveEdgesBetweenEightCornersOfThree) {
  RandomSamples random(1);
  for (int trial = 0; trial < 5; ++trial) {
    const Surface box = prepare_surface(rotate_mesh(make_box({1, 0.7, 0.4}), random.rotation()));
    const std::vector<CreaseCurve> curves = sharp_curves(box, kAngles);
    ASSERT_EQ(curves.size(), 12u);
    EXPECT_NEAR(length_of(curves), 4 * 2.1, 1e-12);
    for (const CreaseCurve& curve : curves) {
      for (const Vector3& tangent : curve.tangents)
        EXPECT_NEAR(norm(cross(tangent, normalised(curve.points.back() - curve.points.front()))), 0, 1e-12);
    }
    const std::vector<CreaseCorner> corners = corners_of(curves);
    EXPECT_EQ(corners.size(), 8u);
    for (const CreaseCorner& corner : corners) EXPECT_EQ(corner.curves, 3u);
  }
}

TEST(Creases, OfACylinderAreItsTwoRimsWithTangentsOfTheCircle) {
  const Surface cylinder = prepare_surface(make_cylinder(0.3, 0.5, 48, 3));
  const std::vector<CreaseCurve> curves = sharp_curves(cylinder, kAngles);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_TRUE(corners_of(curves).empty());
  for (const CreaseCurve& curve : curves) {
    ASSERT_EQ(curve.points.size(), 49u);
    EXPECT_EQ(curve.points.front(), curve.points.back());
    for (std::size_t k = 0; k < curve.points.size(); ++k) {
      const Vector3 radial = normalised({curve.points[k][0], curve.points[k][1], 0});
      EXPECT_NEAR(dot(curve.tangents[k], radial), 0, 1e-12);
      EXPECT_NEAR(norm(curve.tangents[k]), 1, 1e-12);
    }
  }
}

TEST(Creases, OfSmoothSurfacesAreNone) {
  EXPECT_TRUE(sharp_curves(prepare_surface(make_sphere(0.5, 3)), kAngles).empty());
  EXPECT_TRUE(sharp_curves(prepare_surface(make_torus(0.6, 0.25, 48, 24)), kAngles).empty());
}

TEST(Creases, DoNotDependOnWhichSideIsOutNorOnHowTrianglesRun) {
  TriangleMesh box = make_box({1, 1, 1});
  const double length = length_of(sharp_curves(prepare_surface(box), kAngles));
  EXPECT_EQ(length_of(sharp_curves(prepare_surface(flip_mesh(box)), kAngles)), length);
  std::swap(box.triangles[3][0], box.triangles[3][1]);
  EXPECT_EQ(length_of(sharp_curves(prepare_surface(box), kAngles)), length);
}

TEST(Creases, EndWhereTheBoundaryOfAnOpenSheetBegins) {
  // Two squares at a right angle: one crease, and open edges around.
  const TriangleMesh sheet{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {0, 1, 1}},
                           {{0, 2, 3}, {0, 3, 1}, {0, 1, 5}, {0, 5, 4}}};
  const std::vector<CreaseCurve> curves = sharp_curves(prepare_surface(sheet), kAngles);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].points.size(), 2u);
  EXPECT_TRUE(corners_of(curves).empty());
}

/// Without the rule for creases that fade out.
CreaseAngles every_edge() {
  CreaseAngles angles;
  angles.fading.least_radii = 0;
  return angles;
}

TEST(Creases, OfCurvedSurfacesOfCoarseTrianglesAreNoneThoughManyEdgesAreSharp) {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
    for (const auto& [knobs, noise] : {std::pair{0.6, 0.0}, {0.4, 0.01}}) {
      const Surface surface = prepare_surface(make_knobbly_sphere(4, knobs, noise, seed));
      EXPECT_GT(sharp_curves(surface, every_edge()).size(), 5u) << seed;
      EXPECT_TRUE(sharp_curves(surface, kAngles).empty()) << seed << ' ' << knobs;
    }
  }
}

TEST(Creases, ThatFadeOutCountIfSharpOnceOrLongForTheirTriangles) {
  // Sharper than 35 degrees up to x = 1.5 (1 - tan(17.5 deg) / tan(angle / 2)).
  const auto length = [](int cells, double angle_deg) {
    return length_of(sharp_curves(prepare_surface(make_fading_ridge(cells, angle_deg)), kAngles));
  };
  const auto expected = [](double angle_deg) {
    const double degree = std::numbers::pi / 180;
    return 1.5 * (1 - std::tan(17.5 * degree) / std::tan(angle_deg / 2 * degree));
  };
  EXPECT_NEAR(length(10, 90), expected(90), 0.1);
  EXPECT_NEAR(length(160, 60), expected(60), 1. / 160);
  EXPECT_EQ(length(10, 60), 0);
}

TEST(Creases, EndAtACornerOfOtherCreasesWhateverTheirAngle) {
  // The chamfers of a block make two edges of 45 degrees each, from side to side.
  const Surface block = prepare_surface(extrude({{0, 0}, {1, 0}, {1, 0.8}, {0.8, 1}, {0, 1}}, {}, -1, {1}));
  EXPECT_EQ(sharp_curves(block, kAngles).size(), 15u);
}

/// A prism over an isosceles triangle with this angle at its tip, 2 long.
Surface wedge(double tip_deg) {
  const double half = tip_deg / 2 * std::numbers::pi / 180;
  return prepare_surface(
      extrude({{0, 0}, {std::cos(half), -std::sin(half)}, {std::cos(half), std::sin(half)}}, {}, -1, {1}));
}

KnifeEdges knives_of(const Surface& surface, bool inside_out = false) {
  return knife_edges(surface, sorted_edge_uses(surface.mesh.triangles), inside_out);
}

TEST(KnifeEdges, AreCountedInTheSolidOnly) {
  EXPECT_EQ(knives_of(wedge(30)).count, 1u);
  EXPECT_EQ(knives_of(wedge(50)).count, 0u);
  const KnifeEdges knives = knives_of(wedge(20));
  EXPECT_NEAR(norm(knives.places.at(0)), 0, 1e-12);
  // A slit of 20 degrees cut into a block leaves 340 degrees of solid.
  const double half = 10 * std::numbers::pi / 180;
  const Surface slit = prepare_surface(extrude(
      {{0, 0}, {1, std::tan(half)}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, -std::tan(half)}}, {}, -1, {1}));
  EXPECT_EQ(knives_of(slit).count, 0u);
  Surface turned = prepare_surface(flip_mesh(wedge(30).mesh));
  EXPECT_EQ(knives_of(turned, true).count, 1u);
}

TEST(CreaseCorners, AreWhereOneCurveBendsOrThreeMeet) {
  const auto straight = [](const Vector3& a, const Vector3& b) {
    const Vector3 t = normalised(b - a);
    return CreaseCurve{{a, b}, {t, t}};
  };
  const std::vector<CreaseCurve> smooth{straight({0, 0, 0}, {1, 0, 0}), straight({2, 0.2, 0}, {1, 0, 0})};
  EXPECT_TRUE(corners_of(smooth).empty());
  const std::vector<CreaseCurve> bent{straight({0, 0, 0}, {1, 0, 0}), straight({1, 1, 0}, {1, 0, 0})};
  ASSERT_EQ(corners_of(bent).size(), 1u);
  EXPECT_EQ(corners_of(bent)[0].position, (Vector3{1, 0, 0}));
}

}  // namespace
}  // namespace crossgrain
