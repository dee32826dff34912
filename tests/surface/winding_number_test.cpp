// SPDX-License-Identifier: Apache-2.0
#include "surface/winding_number.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "base/vector3.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

/// What the class promises of `at`.
constexpr double kAccuracy = 0.02;

Vector3 random_point(std::mt19937& random, double reach = 1) {
  std::uniform_real_distribution<double> uniform(-reach, reach);
  const double x = uniform(random), y = uniform(random);
  return {x, y, uniform(random)};
}

/// A few random triangles of each size.
TriangleMesh random_soup(int count) {
  std::mt19937 random(7);
  TriangleMesh soup;
  for (int i = 0; i < count; ++i) {
    const Vector3 centre = random_point(random);
    TriangleMesh triangle{{}, {{0, 1, 2}}};
    for (int k = 0; k < 3; ++k) triangle.vertices.push_back(centre + 0.2 * random_point(random));
    soup = join_meshes(std::move(soup), triangle);
  }
  return soup;
}

/// The sum of solid angles over all triangles, an arc tangent each.
double exact_winding_number(const Surface& surface, const Vector3& p) {
  double sum = 0;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    const auto corners = surface.corners(t);
    const Vector3 a = corners[0] - p, b = corners[1] - p, c = corners[2] - p;
    const double la = norm(a), lb = norm(b), lc = norm(c);
    sum +=
        2 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return sum / (4 * std::numbers::pi);
}

struct Prepared {
  explicit Prepared(TriangleMesh mesh)
      : surface(prepare_surface(std::move(mesh))), bvh(surface), winding(bvh) {}
  Surface surface;
  TriangleBvh bvh;
  WindingNumber winding;
};

/// The largest error over points all around and over points near the surface.
double largest_error(const Surface& surface, const WindingNumber& winding, int points) {
  std::mt19937 random(8);
  const Vector3 size = surface.box.high - surface.box.low,
                middle = 0.5 * (surface.box.high + surface.box.low);
  const double reach = std::max({size[0], size[1], size[2]});
  double largest = 0;
  for (int i = 0; i < points; ++i) {
    const Vector3 anywhere = middle + random_point(random, reach);
    const Vector3 nearby = surface.corners(random() % surface.size())[0] + random_point(random, 0.03 * reach);
    for (const Vector3& p : {anywhere, nearby}) {
      const double exact = exact_winding_number(surface, p) * (winding.flipped() ? -1 : 1);
      largest = std::max(largest, std::abs(winding.at(p) - exact));
    }
  }
  return largest;
}

TEST(WindingNumber, IsOneInsideABoxAndZeroOutside) {
  const Prepared box(make_box({1, 1, 1}));
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vector3 p = random_point(random);
    const double depth = 0.5 - std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    ASSERT_NEAR(box.winding.at(p), depth > 0 ? 1 : 0, kAccuracy);
    ASSERT_EQ(box.winding.inside(p), depth > 0);
  }
}

TEST(WindingNumber, IsExactNextToTheSurface) {
  // So near that every triangle of the side counts exactly; what is left is the far side's multipoles.
  const Prepared sphere(make_sphere(1, 3));
  for (std::size_t t = 0; t < sphere.surface.size(); t += 7) {
    const auto corners = sphere.surface.corners(t);
    const Vector3 on = (1.0 / 3) * (corners[0] + corners[1] + corners[2]);
    for (const double distance : {1e-3, 1e-6, 1e-9, 1e-12}) {
      ASSERT_NEAR(sphere.winding.at(on + distance * sphere.surface.normals[t]), 0, kAccuracy) << distance;
      ASSERT_NEAR(sphere.winding.at(on - distance * sphere.surface.normals[t]), 1, kAccuracy) << distance;
    }
  }
}

TEST(WindingNumber, OfOneTriangleIsItsSolidAngle) {
  // An octant seen from the origin: 1/8 of the sphere, from inside, of a triangle facing away from it.
  const Prepared octant({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}}});
  EXPECT_NEAR(std::abs(octant.winding.at({0, 0, 0})), 0.125, 1e-15);
}

TEST(WindingNumber, IsWithinItsAccuracyOfTheExactSumOnSmoothSolids) {
  for (const TriangleMesh& mesh :
       {make_sphere(0.8, 4), make_torus(0.6, 0.25, 72, 36), make_cylinder(0.5, 0.7, 96, 20)}) {
    const Prepared solid(mesh);
    EXPECT_LT(largest_error(solid.surface, solid.winding, 300), kAccuracy);
  }
}

TEST(WindingNumber, IsWithinItsAccuracyOfTheExactSumOnPartsWithLongTriangles) {
  for (const TriangleMesh& mesh :
       {make_bracket(64), make_box_with_hole(48), make_wall(0.01), make_thin_cylinder()}) {
    const Prepared solid(mesh);
    EXPECT_LT(largest_error(solid.surface, solid.winding, 500), kAccuracy);
  }
}

TEST(WindingNumber, IsWithinItsAccuracyOfTheExactSumOnASoup) {
  const Prepared soup(random_soup(1000));
  EXPECT_LT(largest_error(soup.surface, soup.winding, 300), kAccuracy);
}

TEST(WindingNumber, ErrorFallsWithTheThirdPowerOfBeta) {
  // The first multipole left out is of relative size (radius / distance)^3. From beta 2 to 4 that is a factor
  // 8; the largest error over a sample scatters, so half of that is asked for.
  const Surface surface = prepare_surface(make_torus(0.6, 0.25, 48, 24));
  const TriangleBvh bvh(surface);
  const double coarse = largest_error(surface, WindingNumber(bvh, 2), 200);
  const double fine = largest_error(surface, WindingNumber(bvh, 4), 200);
  EXPECT_GT(coarse, 4 * fine);
  EXPECT_GT(fine, 0);
}

TEST(WindingNumber, MultipolesLeaveAnErrorOfFifthOrderInTheDistance) {
  // With a beta near 0 all triangles are one cluster. A dipole falls with the second power of the distance
  // and each further order with one more: what follows the octupole, kept correctly, with the fifth. Twice
  // the distance: 1/32.
  const Surface surface = prepare_surface(random_soup(20));
  const TriangleBvh bvh(surface);
  const WindingNumber winding(bvh, 1e-9);
  const auto mean_square_error = [&](double distance) {
    std::mt19937 random(9);
    double sum = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vector3 p = distance * normalised(random_point(random));
      const double exact = exact_winding_number(surface, p) * (winding.flipped() ? -1 : 1);
      sum += (winding.at(p) - exact) * (winding.at(p) - exact);
    }
    return sum / 2000;
  };
  EXPECT_NEAR(std::sqrt(mean_square_error(6) / mean_square_error(12)), 32, 4);
}

TEST(WindingNumber, WithAHugeBetaIsTheExactSum) {
  const Surface surface = prepare_surface(random_soup(300));
  const TriangleBvh bvh(surface);
  EXPECT_LT(largest_error(surface, WindingNumber(bvh, 1e6), 200), 1e-12);
}

TEST(WindingNumber, OfASurfaceInsideOutIsThatOfTheSurface) {
  const Prepared outward(make_bracket(24)), inward(flip_mesh(make_bracket(24)));
  EXPECT_FALSE(outward.winding.flipped());
  EXPECT_TRUE(inward.winding.flipped());
  std::mt19937 random(2);
  for (int i = 0; i < 500; ++i) {
    const Vector3 p = random_point(random);
    ASSERT_NEAR(inward.winding.at(p), outward.winding.at(p), 1e-6);
  }
}

TEST(WindingNumber, KnowsAnOpenSurfaceInsideOutWhereverItLies) {
  TriangleMesh open = make_box({1, 1, 1});
  open.triangles.erase(open.triangles.begin(), open.triangles.begin() + 2);
  for (const double offset : {-100.0, 0.0, 100.0}) {
    EXPECT_FALSE(Prepared(translate_mesh(open, {offset, 0, offset})).winding.flipped());
    EXPECT_TRUE(Prepared(translate_mesh(flip_mesh(open), {offset, 0, offset})).winding.flipped());
  }
}

TEST(WindingNumber, IsHardlyMovedByASmallHole) {
  TriangleMesh mesh = make_sphere(1, 3);
  mesh.triangles.pop_back();
  const Prepared sphere(mesh);
  EXPECT_NEAR(sphere.winding.at({0, 0, 0}), 1, kAccuracy);
  EXPECT_TRUE(sphere.winding.inside({.5, .5, .5}));
  EXPECT_FALSE(sphere.winding.inside({1, .5, .5}));
}

TEST(WindingNumber, OfNestedOppositeSurfacesLeavesTheCavityOutside) {
  const Prepared shell(join_meshes(make_sphere(1, 3), flip_mesh(make_sphere(0.5, 3))));
  EXPECT_FALSE(shell.winding.inside({.1, .2, .3}));
  EXPECT_TRUE(shell.winding.inside({.5, .5, .2}));
}

TEST(WindingNumber, CountsOverlapsTwice) {
  const Prepared two(join_meshes(make_box({1, 1, 1}), translate_mesh(make_box({1, 1, 1}), {.5, .25, .125})));
  EXPECT_NEAR(two.winding.at({.25, .1, .1}), 2, kAccuracy);
}

TEST(WindingNumber, DoesNotDependOnUnitsAndPosition) {
  // Powers of two change no rounding; a far origin leaves 2^-20 of the size to a coordinate's last bits.
  const TriangleMesh mesh = make_bracket(24);
  const Prepared plain(mesh), large(scale_mesh(mesh, 0x1p100)), small(scale_mesh(mesh, 0x1p-100));
  const Vector3 far_away{0x1p30, -0x1p30, 0x1p30};
  const Prepared moved(translate_mesh(mesh, far_away));
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    const Vector3 p = random_point(random);
    ASSERT_EQ(large.winding.at(0x1p100 * p), plain.winding.at(p));
    ASSERT_EQ(small.winding.at(0x1p-100 * p), plain.winding.at(p));
    if (plain.bvh.nearest(p).squared_distance < 1e-8) continue;
    ASSERT_NEAR(moved.winding.at(p + far_away), plain.winding.at(p), kAccuracy);
  }
}

TEST(WindingNumber, IsZeroFarAway) {
  const Prepared box(make_box({1, 1, 1}));
  for (const double distance : {1e3, 1e7, 1e30, 1e300})
    EXPECT_NEAR(box.winding.at({distance, distance, 0}), 0, 1e-6);
}

TEST(WindingNumber, IsFiniteOnTheSurfaceItself) {
  const Prepared box(make_box({1, 1, 1}));
  for (const Vector3& p : {Vector3{.5, .5, .5}, {.5, 0, 0}, {.5, .5, 0}, {.5, .25, .25}}) {
    const double value = box.winding.at(p);
    EXPECT_GE(value, -kAccuracy);
    EXPECT_LE(value, 1 + kAccuracy);
  }
}

}  // namespace
}  // namespace crossgrain
