// SPDX-License-Identifier: Apache-2.0
#include "lattice/holes.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "base/vector3.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

std::vector<std::vector<Vector3>> holes_in(TriangleMesh mesh) {
  return holes_of(feature_complex(prepare_surface(CheckedMesh::derived(std::move(mesh)))));
}

TEST(Holes, AreThoseOfABoxWithAHoleAndTheSideOfACylinder) {
  EXPECT_TRUE(holes_in(make_box({1, 2, 3})).empty());
  const auto holes = holes_in(make_box_with_hole(48));
  ASSERT_EQ(holes.size(), 1u);
  const Box box = box_of(holes.front());
  EXPECT_NEAR(box.low[0], 0.2 - 0.25, 0.01);
  EXPECT_NEAR(box.high[1], 0.1 + 0.25, 0.01);
  EXPECT_EQ(holes_in(make_cylinder(1, 2, 32)).size(), 1u);
}

TEST(Holes, HaveNoWallThatLooksToOneSide) {
  // A fillet and a chamfer look away from their edge; the round hole is the only one.
  EXPECT_EQ(holes_in(make_bracket(24)).size(), 1u);
}

}  // namespace
}  // namespace crossgrain
