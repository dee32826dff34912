// SPDX-License-Identifier: Apache-2.0
#include "grid/cell_constraints.hpp"

#include <gtest/gtest.h>

#include <set>

#include "base/vector3.hpp"
#include "constraint/normal_form.hpp"
#include "grid/test_solid.hpp"
#include "harmonics/random_samples.hpp"
#include "support/shapes.hpp"
#include "surface/clipping.hpp"

namespace crossgrain {
namespace {

using testing::BothDegrees;
using testing::RandomSamples;
using testing::TestSolid;

template <int D>
double largest_difference(const QuadraticForm<D>& a, const QuadraticForm<D>& b) {
  double largest = testing::largest_difference(a.matrix, b.matrix);
  if constexpr (D == 4) {
    largest = std::max(
        {largest, testing::largest_difference(a.linear, b.linear), std::abs(a.constant - b.constant)});
  }
  return std::max(largest, std::abs(a.weight - b.weight));
}

/// The form of a box in double precision, from the surface itself.
template <int D>
QuadraticForm<D> form_of_box(const Surface& surface, const Box& box) {
  QuadraticForm<D> form;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    const double area = clip_triangle(surface.corners(t), box).area;
    if (area > 0) add_normal(form, surface.normals[t], area);
  }
  return form;
}

/// The leaf of `level` that holds the point.
CellIndex leaf_at(const GridLevel& level, const Vector3& p) {
  return level.tree.find_containing(*level.tree.root().locate(p));
}

template <class Degree>
class CellFormTest : public ::testing::Test {};
TYPED_TEST_SUITE(CellFormTest, BothDegrees);

TYPED_TEST(CellFormTest, OfAParentIsTheSumOverItsChildren) {
  constexpr int D = TypeParam::value;
  const TestSolid solid(make_bracket(24));
  const GridLevel coarse = solid.level(0.1);
  const auto [fine, neighbours, parent] =
      refined(coarse, face_neighbours(coarse.tree), solid.solid(), std::vector<bool>(coarse.size(), true));
  std::vector<QuadraticForm<D>> sums(coarse.size());
  for (CellIndex i = 0; i < fine.size(); ++i) sums[parent[i]] += cell_form<D>(fine, solid.solid(), i);
  for (CellIndex i = 0; i < coarse.size(); ++i) {
    const QuadraticForm<D> form = cell_form<D>(coarse, solid.solid(), i);
    // Areas are stored in single precision.
    ASSERT_LE(largest_difference(form, sums[i]), 1e-6 * form.weight);
  }
}

TYPED_TEST(CellFormTest, OfAParentIsTheSumOverItsChildrenToRoundingInDoublePrecision) {
  constexpr int D = TypeParam::value;
  RandomSamples random(1);
  const TestSolid solid(rotate_mesh(make_sphere(0.8, 2), random.rotation()));
  const GridLevel level = solid.level(0.25);
  for (CellIndex i = 0; i < level.size(); ++i) {
    if (!level.holds_surface(i)) continue;
    QuadraticForm<D> sum;
    for (int octant = 0; octant < 8; ++octant)
      sum += form_of_box<D>(solid.surface(), level.tree.root().box(level.tree[i].child(octant)));
    const auto whole = form_of_box<D>(solid.surface(), level.tree.root().box(level.tree[i]));
    ASSERT_LE(largest_difference(whole, sum), 1e-12 * whole.weight);
  }
}

TYPED_TEST(CellFormTest, OfAllCellsIsTheFormOfTheSurface) {
  constexpr int D = TypeParam::value;
  RandomSamples random(2);
  const TestSolid solid(rotate_mesh(make_bracket(24), random.rotation()));
  const GridLevel level = solid.level(0.05);
  QuadraticForm<D> sum, expected;
  for (CellIndex i = 0; i < level.size(); ++i) sum += cell_form<D>(level, solid.solid(), i);
  for (std::size_t t = 0; t < solid.surface().size(); ++t)
    add_normal(expected, solid.surface().normals[t], solid.surface().areas[t]);
  EXPECT_LE(largest_difference(sum, expected), 1e-6 * expected.weight);
}

TYPED_TEST(CellFormTest, OfManyPiecesIsTheSumOverThem) {
  constexpr int D = TypeParam::value;
  RandomSamples random(3);
  const TestSolid solid(rotate_mesh(make_sphere(0.8, 4), random.rotation()));
  const GridLevel level = solid.level(0.3);
  std::set<std::size_t> remainders;
  for (CellIndex i = 0; i < level.size(); ++i) {
    const auto pieces = level.pieces_of(i);
    if (pieces.size() < 40) continue;
    remainders.insert(pieces.size() % 8);
    QuadraticForm<D> sum;
    for (const SurfacePiece& piece : pieces)
      add_normal(sum, solid.surface().normals[piece.triangle], static_cast<double>(piece.area));
    const QuadraticForm<D> form = cell_form<D>(level, solid.solid(), i);
    ASSERT_LE(largest_difference(form, sum), 1e-13 * sum.weight);
    ASSERT_NEAR(form.weight, sum.weight, 1e-13 * sum.weight);
  }
  EXPECT_GT(remainders.size(), 4u);
}

/// A turned box of 1 x 0.8 x 0.6, and places on it.
class TurnedBoxTest : public ::testing::TestWithParam<unsigned> {
 protected:
  const Quaternion turn_ = RandomSamples(GetParam()).rotation();
  const TestSolid box_{rotate_mesh(make_box({1, 0.8, 0.6}), turn_)};
  const GridLevel level_ = box_.level(1.0 / 12);

  CellIndex cell_at(const Vector3& p) const { return leaf_at(level_, rotate(turn_, p)); }
};

TEST_P(TurnedBoxTest, CellInTheMiddleOfAFaceHasASingleNormalAndIsAPlane) {
  for (const Vector3& p : {Vector3{0.4999, 0, 0}, {0, -0.3999, 0}, {0, 0, 0.2999}}) {
    ASSERT_TRUE(level_.holds_surface(cell_at(p)));
    EXPECT_TRUE(has_single_normal(level_, box_.solid(), cell_at(p)));
    EXPECT_EQ(constraint_class(level_, box_.solid(), cell_at(p)), ConstraintClass::kPlane);
  }
}

TEST_P(TurnedBoxTest, CellAtAnEdgeHasNoSingleNormal) {
  for (const Vector3& p : {Vector3{0.4999, 0.3999, 0}, {0, -0.3999, 0.2999}, {-0.4999, 0, 0.2999}})
    EXPECT_FALSE(has_single_normal(level_, box_.solid(), cell_at(p)));
}

TEST_P(TurnedBoxTest, CellsAtEdgesAreFramesWhereTheFacesCountAlikeAndNeverConflicted) {
  int frames = 0;
  for (CellIndex i = 0; i < level_.size(); ++i) {
    if (!level_.holds_surface(i)) continue;
    const ConstraintClass constraint = constraint_class(level_, box_.solid(), i);
    ASSERT_TRUE(compatible(constraint));
    frames += constraint == ConstraintClass::kFrame;
    // Two orthogonal planes of shares p and 1 - p have eigenvalues {0, min(p, 1 - p), ...}: with a tenth in
    // each the second one stands out.
    double largest = 0, total = 0;
    std::array<double, 3> areas{};
    for (const SurfacePiece& piece : level_.pieces_of(i)) {
      const Vector3 n = rotate(conjugate(turn_), box_.surface().normals[piece.triangle]);
      for (int axis = 0; axis < 3; ++axis)
        if (std::abs(n[axis]) > 0.5) areas[axis] += piece.area;
      total += piece.area;
    }
    largest = *std::max_element(areas.begin(), areas.end());
    if (largest < 0.85 * total) {
      ASSERT_EQ(constraint, ConstraintClass::kFrame);
    } else if (largest > 0.95 * total) {
      ASSERT_EQ(constraint, ConstraintClass::kPlane);
    }
  }
  EXPECT_GT(frames, 20);
}

TEST_P(TurnedBoxTest, CellAtACornerIsAFrame) {
  // A cell with the corner in its middle holds three faces of similar area.
  const Vector3 corner = rotate(turn_, {0.5, 0.4, 0.3});
  const double size = 0.1;
  const RootCube root{corner - Vector3{2.5 * size, 2.5 * size, 2.5 * size}, 8 * size};
  const GridLevel level = uniform_level(box_.solid(), root, 3).level;
  EXPECT_EQ(constraint_class(level, box_.solid(), leaf_at(level, corner)), ConstraintClass::kFrame);
}

INSTANTIATE_TEST_SUITE_P(Rotations, TurnedBoxTest, ::testing::Values(1u, 2u, 3u));

TEST(SingleNormal, CountsBothSidesOfAThinWallAsOne) {
  const TestSolid wall(make_wall(0.05));
  const GridLevel level = uniform_level(wall.solid(), {{-0.75, -0.75, -0.85}, 1.6}, 3).level;
  const CellIndex middle = leaf_at(level, {0, 0, 0});
  ASSERT_GE(level.pieces_of(middle).size(), 2u);
  EXPECT_TRUE(has_single_normal(level, wall.solid(), middle));
  EXPECT_EQ(constraint_class(level, wall.solid(), middle), ConstraintClass::kPlane);
}

TEST(SingleNormal, IsNotSeenWhereNormalsDifferByAThousandthOfADegree) {
  const double bend_rad = 2e-5;
  TriangleMesh roof;
  roof.vertices = {{-1, -1, 0}, {-1, 1, 0}, {0, -1, 0}, {0, 1, 0}, {1, -1, -bend_rad}, {1, 1, -bend_rad}};
  roof.triangles = {{0, 2, 3}, {0, 3, 1}, {2, 4, 5}, {2, 5, 3}};
  const TestSolid solid(roof);
  const GridLevel level = uniform_level(solid.solid(), {{-1.51, -1.53, -1.47}, 3}, 0).level;
  EXPECT_FALSE(has_single_normal(level, solid.solid(), 0));
}

TEST(SingleNormal, IsNotHadByACellWithoutSurface) {
  const TestSolid solid(make_box({1, 1, 1}));
  const GridLevel level = solid.level(0.1);
  EXPECT_FALSE(has_single_normal(level, solid.solid(), leaf_at(level, {0, 0, 0})));
}

TEST(ConstraintClassOfACell, WithAWholeSmallSphereIsFree) {
  const TestSolid sphere(make_sphere(0.3, 2));
  const GridLevel level = uniform_level(sphere.solid(), {{-0.5, -0.5, -0.5}, 1}, 0).level;
  EXPECT_EQ(constraint_class(level, sphere.solid(), 0), ConstraintClass::kFree);
}

TEST(ConstraintClassOfACell, ThatAThinRodPassesThroughIsAnAxis) {
  RandomSamples random(3);
  const TestSolid rod(rotate_mesh(make_cylinder(0.01, 2, 48), random.rotation()));
  // The ends, where caps are, lie in other cells than the middle.
  const GridLevel level = uniform_level(rod.solid(), {{-3.5, -3.5, -3.5}, 8}, 3).level;
  EXPECT_EQ(constraint_class(level, rod.solid(), leaf_at(level, {0, 0, 0})), ConstraintClass::kAxis);
}

}  // namespace
}  // namespace crossgrain
