// SPDX-License-Identifier: Apache-2.0
#include "surface/bvh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

Vector3 random_point(std::mt19937& random, double reach = 1) {
  std::uniform_real_distribution<double> uniform(-reach, reach);
  const double x = uniform(random), y = uniform(random);
  return {x, y, uniform(random)};
}

/// A plain ray-triangle test (Moeller and Trumbore), of another kind than the tree's.
std::optional<RayHit> first_hit_of_all(const Surface& surface, const Vector3& origin,
                                       const Vector3& direction) {
  std::optional<RayHit> best;
  for (std::uint32_t i = 0; i < surface.size(); ++i) {
    const auto [a, b, c] = surface.corners(i);
    const Vector3 ab = b - a, ac = c - a, h = cross(direction, ac), s = origin - a, q = cross(s, ab);
    const double determinant = dot(ab, h), u = dot(s, h) / determinant, v = dot(direction, q) / determinant;
    const double t = dot(ac, q) / determinant;
    if (u < 0 || v < 0 || u + v > 1 || t < 0) continue;
    if (!best || t < best->t) best = RayHit{t, i};
  }
  return best;
}

/// The least squared distance to samples of the triangles, which no distance to the surface may exceed.
double least_distance_to_samples(const Surface& surface, const Vector3& p, int steps) {
  double least = INFINITY;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    const auto [a, b, c] = surface.corners(t);
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; i + j <= steps; ++j) {
        const double u = static_cast<double>(i) / steps, v = static_cast<double>(j) / steps;
        const Vector3 offset = a + u * (b - a) + v * (c - a) - p;
        least = std::min(least, dot(offset, offset));
      }
    }
  }
  return least;
}

std::size_t depth_of(const TriangleBvh& bvh) {
  std::vector<std::uint32_t> open_subtrees;
  std::size_t depth = 0;
  for (std::uint32_t i = 0; i < bvh.nodes().size(); ++i) {
    while (!open_subtrees.empty() && open_subtrees.back() <= i) open_subtrees.pop_back();
    open_subtrees.push_back(bvh.nodes()[i].skip);
    depth = std::max(depth, open_subtrees.size());
  }
  return depth;
}

TEST(TriangleBvh, HoldsEveryTriangleOnceInNestedBoxes) {
  const Surface surface = prepare_surface(make_torus(0.6, 0.25, 40, 20));
  const TriangleBvh bvh(surface);
  std::vector<std::uint32_t> order = bvh.triangle_order();
  std::sort(order.begin(), order.end());
  for (std::uint32_t t = 0; t < order.size(); ++t) ASSERT_EQ(order[t], t);
  ASSERT_EQ(bvh.nodes()[0].skip, bvh.nodes().size());
  for (const TriangleBvh::Node& node : bvh.nodes()) {
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      for (const Vector3& corner : surface.corners(bvh.triangle_order()[i])) {
        for (std::size_t k = 0; k < 3; ++k) {
          ASSERT_LE(node.box.low[k], corner[k]);
          ASSERT_GE(node.box.high[k], corner[k]);
        }
      }
    }
  }
}

TEST(TriangleBvh, ChildrenShareOutTheTrianglesOfTheirParent) {
  const Surface surface = prepare_surface(make_torus(0.6, 0.25, 40, 20));
  const TriangleBvh bvh(surface);
  for (std::uint32_t i = 0; i < bvh.nodes().size(); ++i) {
    const TriangleBvh::Node& node = bvh.nodes()[i];
    if (node.skip == i + 1) continue;
    const TriangleBvh::Node& left = bvh.nodes()[i + 1];
    const TriangleBvh::Node& right = bvh.nodes()[left.skip];
    ASSERT_EQ(right.skip, node.skip);
    ASSERT_EQ(left.first, node.first);
    ASSERT_EQ(right.first, left.first + left.count);
    ASSERT_EQ(left.count + right.count, node.count);
  }
}

TEST(TriangleBvh, DoesNotDependOnTheNumberOfThreads) {
  const Surface surface = prepare_surface(make_sphere(1, 5));
  ASSERT_GT(surface.size(), 16384u);  // large enough to be built in parallel
  const auto order_with = [&](int threads) {
    const ThreadLimit limit(threads);
    return TriangleBvh(surface).triangle_order();
  };
  EXPECT_EQ(order_with(1), order_with(2));
}

TEST(TriangleBvh, OfManyEqualTrianglesStaysShallowEnoughToAsk) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 1000; ++i)
    mesh = join_meshes(mesh, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const Surface surface = prepare_surface(mesh);
  const std::optional<RayHit> hit = TriangleBvh(surface).first_hit({.2, .2, 1}, {0, 0, -1}, 0, 10);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->triangle, 0u);
  EXPECT_EQ(hit->t, 1);
}

TEST(TriangleBvh, OfTrianglesInGeometricProgressionIsNoList) {
  // Each triangle is half a bin of all the smaller ones, so binning splits off one at a time. The queries
  // have room for 96 levels.
  TriangleMesh mesh;
  double size = 1e90;
  for (int i = 0; i < 120; ++i, size /= 32)
    mesh = join_meshes(mesh, {{{size, 0, 0}, {size, size / 4, 0}, {size, 0, size / 4}}, {{0, 1, 2}}});
  const Surface surface = prepare_surface(mesh);
  const TriangleBvh bvh(surface);
  EXPECT_GT(depth_of(bvh), 60u);
  EXPECT_LT(depth_of(bvh), 96u);
  const std::optional<RayHit> hit = bvh.first_hit({0, 1e-3 * size, 1e-3 * size}, {1, 0, 0}, 0, 1e99);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->triangle, 119u);
  EXPECT_EQ(bvh.nearest({0, 0, 0}).triangle, 119u);
}

TEST(FirstHit, OfABoxIsItsFace) {
  const Surface surface = prepare_surface(make_box({2, 2, 2}));
  const TriangleBvh bvh(surface);
  const std::optional<RayHit> hit = bvh.first_hit({.3, .1, 0}, {0, 0, 2}, 0, 100);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t, 0.5);
  EXPECT_EQ(surface.normals[hit->triangle], (Vector3{0, 0, 1}));
}

TEST(FirstHit, KeepsToItsRange) {
  const Surface surface = prepare_surface(make_box({2, 2, 2}));
  const TriangleBvh bvh(surface);
  const Vector3 origin{.3, .1, -5}, up{0, 0, 1};
  EXPECT_EQ(bvh.first_hit(origin, up, 0, 100)->t, 4);
  EXPECT_EQ(bvh.first_hit(origin, up, 4, 100)->t, 4);
  EXPECT_EQ(bvh.first_hit(origin, up, 4.5, 100)->t, 6);
  EXPECT_EQ(bvh.first_hit(origin, up, 4.5, 6)->t, 6);
  EXPECT_FALSE(bvh.first_hit(origin, up, 4.5, 5.5));
  EXPECT_FALSE(bvh.first_hit(origin, -up, 0, 100));
}

TEST(FirstHit, AgreesWithAskingEveryTriangle) {
  const Surface surface = prepare_surface(make_bracket(32));
  const TriangleBvh bvh(surface);
  std::mt19937 random(1);
  int hits = 0;
  for (int repeat = 0; repeat < 3000; ++repeat) {
    const Vector3 origin = random_point(random), direction = random_point(random);
    const std::optional<RayHit> hit = bvh.first_hit(origin, direction, 0, 1e6);
    const std::optional<RayHit> expected = first_hit_of_all(surface, origin, direction);
    ASSERT_EQ(hit.has_value(), expected.has_value());
    if (!hit) continue;
    ++hits;
    ASSERT_NEAR(hit->t, expected->t, 1e-10 * (1 + expected->t));
  }
  EXPECT_GT(hits, 300);
}

TEST(FirstHit, NoRayFromTheCentreEscapesThroughEdgesAndCorners) {
  const Surface surface = prepare_surface(make_sphere(0.7, 3));
  const TriangleBvh bvh(surface);
  const Vector3 origin{0.01, 0.02, -0.03};
  std::mt19937 random(2);
  for (const auto& triangle : surface.mesh.triangles) {
    const Vector3& a = surface.mesh.vertices[triangle[0]];
    const Vector3& b = surface.mesh.vertices[triangle[1]];
    ASSERT_TRUE(bvh.first_hit(origin, a - origin, 0, 2)) << "through a corner";
    const double s = std::uniform_real_distribution<double>(0, 1)(random);
    ASSERT_TRUE(bvh.first_hit(origin, a + s * (b - a) - origin, 0, 2)) << "through an edge";
  }
}

TEST(FirstHit, OfARayAlongAnAxisWorksWhereItsOriginLiesInTheSidesOfBoxes) {
  // All coordinates are multiples of 1/2, so most nodes have a side through the ray; zeros of either sign.
  const Surface surface = prepare_surface(make_box({1, 1, 1}));
  const TriangleBvh bvh(surface);
  for (const double zero : {0.0, -0.0}) {
    for (const double y : {-0.5, 0.0, 0.5}) {
      const std::optional<RayHit> hit = bvh.first_hit({-2, y, 0.5}, {1, zero, zero}, 0, 10);
      ASSERT_TRUE(hit) << "y = " << y;
      EXPECT_EQ(hit->t, 1.5);
    }
  }
}

TEST(Nearest, OfAPointOutsideABoxIsOnItsFaceEdgeOrCorner) {
  const Surface surface = prepare_surface(make_box({2, 2, 2}));
  const TriangleBvh bvh(surface);
  EXPECT_NEAR(norm(bvh.nearest({3, .2, .3}).point - Vector3{1, .2, .3}), 0, 1e-15);
  EXPECT_EQ(bvh.nearest({3, 3, .3}).squared_distance, 8);
  EXPECT_EQ(bvh.nearest({3, -3, 3}).squared_distance, 12);
}

TEST(Nearest, FromTheSphereIsWithinItsFacetDepthOfTheRadius) {
  // A facet with edges of length e <= 0.17 lies at most e^2 / 6 below the unit sphere.
  const Surface surface = prepare_surface(make_sphere(1, 3));
  const TriangleBvh bvh(surface);
  std::mt19937 random(3);
  for (int repeat = 0; repeat < 500; ++repeat) {
    const Vector3 p = random_point(random, 2);
    ASSERT_NEAR(std::sqrt(bvh.nearest(p).squared_distance), std::abs(norm(p) - 1), 0.17 * 0.17 / 6);
  }
}

TEST(Nearest, IsOnTheSurfaceAndNoSampleOfItIsNearer) {
  const Surface surface = prepare_surface(make_bracket(12));
  const TriangleBvh bvh(surface);
  std::mt19937 random(4);
  for (int repeat = 0; repeat < 300; ++repeat) {
    const Vector3 p = random_point(random);
    const NearestPoint nearest = bvh.nearest(p);
    const Vector3 offset = nearest.point - p;
    ASSERT_DOUBLE_EQ(dot(offset, offset), nearest.squared_distance);
    ASSERT_LE(nearest.squared_distance, least_distance_to_samples(surface, p, 12) + 1e-12);
    // The point is in its triangle: the three triangles that it makes with the sides have the area of the
    // whole.
    const auto [a, b, c] = surface.corners(nearest.triangle);
    const Vector3 u = a - nearest.point, v = b - nearest.point, w = c - nearest.point;
    ASSERT_NEAR(norm(cross(u, v)) + norm(cross(v, w)) + norm(cross(w, u)),
                2 * surface.areas[nearest.triangle], 1e-12);
  }
}

}  // namespace
}  // namespace crossgrain
