// SPDX-License-Identifier: Apache-2.0
#include "surface/solid_split.hpp"

#include <gtest/gtest.h>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "support/shapes.hpp"
#include "surface/creases.hpp"
#include "surface/surface.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

/// A box of the given solid, with its low corner at `low`. All quads are cut by the diagonal from their
/// lowest to their highest corner, so that boxes with a face in common have its triangles in common.
void add_box(TriangleMesh& mesh, const Vector3& low, const Vector3& size, std::int32_t solid) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    mesh.vertices.push_back({low[0] + size[0] * (corner & 1), low[1] + size[1] * (corner >> 1 & 1),
                             low[2] + size[2] * (corner >> 2)});
  }
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const std::uint32_t x = 1u << axis, y = 1u << (axis + 1) % 3, z = 1u << (axis + 2) % 3;
    const std::array<std::array<std::uint32_t, 3>, 2> low_side{{{0, y + z, y}, {0, z, y + z}}};
    for (const auto& [a, b, c] : low_side) {
      mesh.triangles.push_back({first + a, first + b, first + c});
      mesh.triangles.push_back({first + x + a, first + x + c, first + x + b});
      mesh.solids.insert(mesh.solids.end(), 2, solid);
    }
  }
}

/// Two boxes that have the square x = 1 in common, of solids 7 and 3.
TriangleMesh glued_boxes() {
  TriangleMesh mesh;
  add_box(mesh, {0, 0, 0}, {1, 1, 1}, 7);
  add_box(mesh, {1, 0, 0}, {0.5, 1, 1}, 3);
  return mesh;
}

TEST(SolidSplit, TakesOutTheFaceThatTwoSolidsHaveInCommon) {
  for (const TriangleMesh& mesh : {glued_boxes(), weld(glued_boxes()), to_soup(glued_boxes())}) {
    TriangleMesh with_solids = mesh;
    with_solids.solids = glued_boxes().solids;
    const SolidSplit split = split_solids(with_solids, false);
    EXPECT_EQ(split.outer->triangles.size(), 20u);
    EXPECT_EQ(split.outer->solids.size(), 20u);
    EXPECT_TRUE(analyse_topology(weld(*split.outer)).watertight);
    ASSERT_EQ(split.inner.triangles.size(), 2u);
    // As solid 3 sees it, which lies behind it along x.
    for (const auto& normals : split.inner.corner_normals) EXPECT_EQ(normals[0], (Vector3{-1, 0, 0}));
  }
}

TEST(SolidSplit, LeavesASingleSolidAndSolidsApartAsTheyAre) {
  TriangleMesh single = make_box({1, 1, 1});
  single.solids.assign(single.triangles.size(), 4);
  EXPECT_FALSE(has_several_solids(single));
  EXPECT_EQ(split_solids(single, false).outer->triangles, single.triangles);
  TriangleMesh apart;
  add_box(apart, {0, 0, 0}, {1, 1, 1}, 0);
  add_box(apart, {2, 0, 0}, {1, 1, 1}, 1);
  EXPECT_TRUE(has_several_solids(apart));
  const SolidSplit split = split_solids(apart, false);
  EXPECT_EQ(split.outer->triangles, apart.triangles);
  EXPECT_TRUE(split.inner.triangles.empty());
}

TEST(SolidSplit, TakesNoPairOfOneSolidAndNoneThatFacesTheSameWay) {
  TriangleMesh twice = make_box({1, 1, 1});
  const std::size_t count = twice.triangles.size();
  twice = join_meshes(twice, make_box({1, 1, 1}));
  twice.solids.assign(2 * count, 0);
  std::fill(twice.solids.begin() + static_cast<std::ptrdiff_t>(count), twice.solids.end(), 1);
  EXPECT_EQ(split_solids(twice, false).outer->triangles, twice.triangles);
}

TEST(SolidSplit, OfAUnionHasNoFacesBetweenSolidsButTheTaggedOnes) {
  TriangleMesh mesh = weld(glued_boxes());
  mesh.inner_faces = {{0, 1, 6}, {0, 0, 1}};
  const SolidSplit split = split_solids(mesh, true);
  EXPECT_EQ(split.outer->triangles.size(), 20u);
  EXPECT_EQ(split.inner.triangles.size(), 1u);  // the other has no area
  EXPECT_EQ(split_solids(mesh, false).inner.triangles.size(), 3u);
}

TEST(SolidSplit, OfAUnionDropsCreasesThatAreOnlyThoseOfSolids) {
  TriangleMesh mesh = weld(glued_boxes());
  const auto line = [](const Vector3& a, const Vector3& b, std::int32_t tag) {
    const Vector3 tangent = normalised(b - a);
    return CreaseCurve{{a, b}, {tangent, tangent}, tag};
  };
  mesh.creases = {line({1, 0, 0}, {1, 1, 0}, 1), line({0, 0, 0}, {1, 0, 0}, 2),
                  line({0, 0, 0}, {0, 1, 0}, 3)};
  const SolidSplit split = split_solids(mesh, true);
  ASSERT_EQ(split.outer->creases.size(), 2u);
  EXPECT_EQ(split.outer->creases[0].tag, 2);
  EXPECT_EQ(split.outer->creases[1].tag, 3);
  EXPECT_EQ(split_solids(mesh, false).outer->creases.size(), 3u);
}

TEST(SolidSplit, KeepsUnionCreasesWhereTheSurfaceBendsAtTheFaceBetween) {
  // A step: the second box is lower, so the upper edge of the face between is one of the surface too.
  TriangleMesh mesh;
  add_box(mesh, {0, 0, 0}, {1, 1, 1}, 0);
  add_box(mesh, {0, 0, 1}, {1, 1, 1}, 0);
  add_box(mesh, {1, 0, 0}, {1, 1, 1}, 1);
  mesh = weld(mesh);
  mesh.creases = {CreaseCurve{{Vector3{1, 0, 1}, {1, 1, 1}}, {Vector3{0, 1, 0}, {0, 1, 0}}, 5}};
  EXPECT_EQ(split_solids(mesh, true).outer->creases.size(), 1u);
}

TEST(SolidSplit, MakesGuidesAcrossFacesInside) {
  const SolidSplit split = split_solids(glued_boxes(), false);
  const std::vector<GuideFace> guides = guides_across(split.inner);
  ASSERT_EQ(guides.size(), 2u);
  for (const GuideFace& guide : guides) {
    EXPECT_EQ(guide.weight, 1);
    for (const Vector3& corner : guide.corners) EXPECT_EQ(corner[0], 1);
    for (const Vector3& direction : guide.directions) EXPECT_EQ(std::abs(direction[0]), 1);
  }
}

TEST(SolidSplit, RefusesInnerFacesOfVerticesThatAreNot) {
  TriangleMesh mesh = make_box({1, 1, 1});
  mesh.inner_faces = {{0, 1, 99}};
  EXPECT_THROW(split_solids(mesh, false), Error);
}

}  // namespace
}  // namespace crossgrain
