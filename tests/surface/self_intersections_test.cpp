// SPDX-License-Identifier: Apache-2.0
#include "surface/self_intersections.hpp"

#include <gtest/gtest.h>

#include <random>

#include "crossgrain/thread_limit.hpp"
#include "surface/damage.hpp"
#include "surface/triangle_pairs.hpp"

namespace crossgrain {
namespace {

SurfaceFindings findings_of(const TriangleMesh& mesh) {
  const MendedSurface mended = mend_surface(mesh);
  const TriangleBvh bvh(mended.surface);
  const WindingNumber winding(bvh);
  SurfaceFindings findings;
  find_self_intersections(mended, bvh, winding, findings);
  return findings;
}

std::size_t count_of(const SurfaceFindings& findings, FindingKind kind) {
  const Finding* finding = find(findings, kind);
  return finding == nullptr ? 0 : finding->count;
}

/// All pairs, one by one.
std::size_t crossings_among(const TriangleMesh& mesh, double tolerance) {
  const Surface surface = prepare_surface(mesh);
  std::size_t count = 0;
  for (std::size_t a = 0; a < surface.size(); ++a)
    for (std::size_t b = a + 1; b < surface.size(); ++b)
      count += crossing_of(surface.corners(a), surface.normals[a], surface.corners(b), surface.normals[b],
                           tolerance)
                   .has_value();
  return count;
}

TriangleMesh random_triangles(int count, std::mt19937& random) {
  std::normal_distribution<double> normal;
  TriangleMesh mesh;
  for (int t = 0; t < count; ++t) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back({normal(random), normal(random), normal(random)});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TEST(CrossingOf, TrianglesThatPassThroughEachOtherLiesInBoth) {
  const std::array<Vector3, 3> flat{Vector3{0, 0, 0}, {4, 0, 0}, {0, 4, 0}},
      upright{Vector3{1, 1, -1}, {1, 1, 3}, {9, 1, 1}};
  const auto place = crossing_of(flat, {0, 0, 1}, upright, {0, 1, 0}, 1e-9);
  ASSERT_TRUE(place.has_value());
  EXPECT_EQ((*place)[2], 0);
  EXPECT_EQ((*place)[1], 1);
  EXPECT_GT((*place)[0], 1);
  EXPECT_LT((*place)[0], 3);
}

TEST(CrossingOf, NeighboursThatShareAnEdgeOrAVertexIsNone) {
  const std::array<Vector3, 3> a{Vector3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::array<Vector3, 3> over_edge{Vector3{1, 0, 0}, {0, 0, 0}, {.3, -.5, 1}},
      over_vertex{Vector3{0, 0, 0}, {-1, -1, 1}, {-1, -1, -1}};
  EXPECT_FALSE(crossing_of(a, shape_of(a).normal, over_edge, shape_of(over_edge).normal, 1e-9));
  EXPECT_FALSE(crossing_of(a, shape_of(a).normal, over_vertex, shape_of(over_vertex).normal, 1e-9));
}

TEST(CrossingOf, TrianglesThatShareAVertexAndCrossBeyondItIsFound) {
  const std::array<Vector3, 3> a{Vector3{0, 0, 0}, {2, 0, 0}, {0, 2, 0}},
      b{Vector3{0, 0, 0}, {.5, .5, 1}, {.5, .5, -1}};
  EXPECT_TRUE(crossing_of(a, shape_of(a).normal, b, shape_of(b).normal, 1e-9));
}

TEST(CrossingOf, EdgesThatMeetInAPointIsNone) {
  const std::array<Vector3, 3> a{Vector3{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}},
      b{Vector3{0, 0, -1}, {0, 0, 1}, {0, -1, 0}};
  EXPECT_FALSE(crossing_of(a, shape_of(a).normal, b, shape_of(b).normal, 1e-9));
}

TEST(CrossingOf, AnEdgeThroughTheMiddleOfAnEdgeIsFound) {
  // Two boxes drawn in round numbers meet each other's faces on their diagonals.
  EXPECT_GT(crossings_among(
                join_meshes(make_box({1, 1, 1}), translate_mesh(make_box({1, 1, 1}), {.5, .5, .5})), 1e-9),
            0u);
}

TEST(SelfIntersections, OfSoundPartsThereAreNone) {
  std::mt19937 random(1);
  for (const TriangleMesh& mesh : {make_bracket(32), make_torus(0.6, 0.25, 60, 30), make_sphere(1, 4),
                                   make_box_with_hole(40), make_plates(0.1)})
    EXPECT_TRUE(findings_of(put_anywhere(mesh, random)).empty());
}

TEST(SelfIntersections, AreThoseOfAllPairs) {
  std::mt19937 random(2);
  const TriangleMesh inner = random_triangles(120, random);
  // Within a box, so that there is an inside; the box goes around all of them.
  MendedSurface mended = mend_surface(make_box({40, 40, 40}));
  mended.surface = prepare_surface(inner);
  const TriangleBvh bvh(mended.surface);
  const WindingNumber winding(bvh);
  SurfaceFindings findings;
  find_self_intersections(mended, bvh, winding, findings);
  EXPECT_EQ(count_of(findings, FindingKind::kSelfIntersection), crossings_among(inner, 1e-6));
}

TEST(SelfIntersections, AreCountedAndPlacedAlikeForAnyNumberOfThreads) {
  std::mt19937 random(3);
  const TriangleMesh soup = join_meshes(make_sphere(4, 3), random_triangles(500, random));
  SurfaceFindings findings[2];
  for (int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    findings[threads - 1] = findings_of(soup);
  }
  ASSERT_EQ(findings[0].size(), findings[1].size());
  for (std::size_t k = 0; k < findings[0].size(); ++k) {
    EXPECT_EQ(findings[0][k].count, findings[1][k].count);
    EXPECT_EQ(findings[0][k].place, findings[1][k].place);
  }
}

TEST(SelfIntersections, OfTwoPartsAreAnOverlap) {
  std::mt19937 random(4);
  const TriangleMesh balls =
      join_meshes(make_sphere(1, 3), translate_mesh(make_sphere(0.8, 3), {1.1, 0.2, 0.1}));
  const SurfaceFindings findings = findings_of(put_anywhere(balls, random));
  EXPECT_EQ(count_of(findings, FindingKind::kOverlappingComponents), 1u);
  EXPECT_EQ(count_of(findings, FindingKind::kSelfIntersection), 0u);
}

TEST(SelfIntersections, APartInsideAnotherIsAnOverlapAndAVoidIsNot) {
  const TriangleMesh outer = make_sphere(1, 3), inner = make_sphere(0.5, 2);
  EXPECT_EQ(count_of(findings_of(join_meshes(outer, inner)), FindingKind::kOverlappingComponents), 1u);
  EXPECT_TRUE(findings_of(join_meshes(outer, flip_mesh(inner))).empty());
}

TEST(SelfIntersections, PartsThatMeetInAFaceAnEdgeOrAPointTouch) {
  const TriangleMesh box = make_box({1, 1, 1});
  for (const Vector3& offset : {Vector3{1, 0.3, 0.2}, {1, 1, 0.2}, {1, 1, 1}}) {
    const SurfaceFindings findings = findings_of(join_meshes(box, translate_mesh(box, offset)));
    EXPECT_EQ(count_of(findings, FindingKind::kTouchingComponents), 1u);
    EXPECT_EQ(findings.size(), 1u);
  }
  EXPECT_TRUE(findings_of(join_meshes(box, translate_mesh(box, {1.001, 0, 0}))).empty());
}

TEST(SelfIntersections, PartsWithSidesInCommonPlanesThatReachIntoEachOtherAreAnOverlap) {
  const TriangleMesh box = make_box({1, 1, 1});
  for (const Vector3& offset : {Vector3{0.5, 0, 0}, {0, 0.2, 0}, {0.3, 0.4, 0}}) {
    const SurfaceFindings findings = findings_of(join_meshes(box, translate_mesh(box, offset)));
    EXPECT_EQ(count_of(findings, FindingKind::kOverlappingComponents), 1u);
    EXPECT_EQ(findings.size(), 1u);
  }
}

TEST(SelfIntersections, CountingThemEndsEarlyWhereThereAreVeryMany) {
  std::mt19937 random(5);
  MendedSurface mended = mend_surface(make_box({1, 1, 1}));
  mended.surface = prepare_surface(random_triangles(20000, random));
  const TriangleBvh bvh(mended.surface);
  const WindingNumber winding(bvh);
  SurfaceFindings findings;
  find_self_intersections(mended, bvh, winding, findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_TRUE(findings[0].at_least);
  EXPECT_GE(findings[0].count, kMostCrossings);
}

}  // namespace
}  // namespace crossgrain
