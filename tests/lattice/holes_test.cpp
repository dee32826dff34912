// SPDX-License-Identifier: Apache-2.0
#include "lattice/holes.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "base/vector3.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

std::vector<Hole> holes_in(TriangleMesh mesh) {
  return holes_of(feature_complex(prepare_surface(CheckedMesh::derived(std::move(mesh)))));
}

TEST(Holes, AreThoseOfABoxWithAHoleAndTheSideOfACylinder) {
  EXPECT_TRUE(holes_in(make_box({1, 2, 3})).empty());
  const auto holes = holes_in(make_box_with_hole(48));
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_FALSE(holes.front().is_boss);
  EXPECT_FALSE(holes_in(translate_mesh(make_box_with_hole(48), {1e4, -2e4, 3e4})).front().is_boss);
  const Box box = box_of(holes.front().points);
  EXPECT_NEAR(box.low[0], 0.2 - 0.25, 0.01);
  EXPECT_NEAR(box.high[1], 0.1 + 0.25, 0.01);
  const auto cylinder = holes_in(make_cylinder(1, 2, 32));
  ASSERT_EQ(cylinder.size(), 1u);
  EXPECT_TRUE(cylinder.front().is_boss);
  EXPECT_TRUE(holes_in(translate_mesh(make_cylinder(1, 2, 32), {-1e4, 2e4, 3e4})).front().is_boss);
}

TEST(Holes, HaveNoWallThatLooksToOneSide) {
  // A fillet and a chamfer look away from their edge; the round hole is the only one.
  EXPECT_EQ(holes_in(make_bracket(24)).size(), 1u);
}

}  // namespace
}  // namespace crossgrain
