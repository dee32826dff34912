// SPDX-License-Identifier: Apache-2.0
#include "grid/refinement.hpp"

#include <gtest/gtest.h>

#include "grid/local_thickness.hpp"
#include "grid/test_solid.hpp"
#include "harmonics/random_samples.hpp"
#include "support/extrusion.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::RandomSamples;
using testing::refined;
using testing::TestSolid;

Marks no_marks(const GridLevel& level) {
  return Marks(level.size(), false);
}

bool any(const Marks& marks) {
  return std::find(marks.begin(), marks.end(), true) != marks.end();
}

/// The distance from the centre of leaf i, in its sizes.
double cells_from(const GridLevel& level, CellIndex i, const Vector3& p) {
  return norm(level.tree.centre(i) - p) / level.tree.cell_size(i);
}

TEST(InwardRay, ThroughAWallIsAsLongAsTheWallIsThick) {
  RandomSamples random(1);
  for (int trial = 0; trial < 5; ++trial) {
    const double thickness = random.uniform(0.05, 0.3);
    const Quaternion turn = random.rotation();
    const TestSolid wall(rotate_mesh(make_wall(thickness), turn));
    const GridLevel level = wall.level(0.06);
    int rays = 0;
    for (CellIndex i = 0; i < level.size(); ++i) {
      const auto ray = inward_ray(level, wall.solid(), i);
      ASSERT_EQ(ray.has_value(), level.holds_surface(i));
      if (!ray || std::abs(rotate(conjugate(turn), ray->direction)[2]) < 0.5) continue;
      ASSERT_NEAR(ray->thickness, thickness, 1e-9);
      ++rays;
    }
    EXPECT_GT(rays, 100);
  }
}

TEST(InwardRay, ThroughASphereIsItsDiameter) {
  const TestSolid sphere(make_sphere(0.5, 4));
  const GridLevel level = sphere.level(0.1);
  for (CellIndex i = 0; i < level.size(); ++i) {
    const auto ray = inward_ray(level, sphere.solid(), i);
    // Facets of 2 degrees across shorten chords by their sagitta and tilt them.
    if (ray) {
      ASSERT_NEAR(ray->thickness, 1, 0.005);
    }
  }
}

TEST(InwardRay, PointsInwardAlsoWhereTheSurfaceIsInsideOut) {
  const TestSolid sphere(flip_mesh(make_sphere(0.5, 3)));
  const GridLevel level = sphere.level(0.1);
  for (CellIndex i = 0; i < level.size(); ++i) {
    const auto ray = inward_ray(level, sphere.solid(), i);
    if (ray) {
      ASSERT_LT(dot(ray->direction, ray->origin), 0);
    }
  }
}

TEST(InwardRay, BehindAnOpenSurfaceIsInfinite) {
  TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}};
  const TestSolid solid(sheet);
  const GridLevel level = uniform_level(solid.solid(), {{-0.5, -0.5, -1.1}, 2}, 0).level;
  EXPECT_EQ(inward_ray(level, solid.solid(), 0)->thickness, INFINITY);
}

TEST(SurfaceCriterion, MarksTheLeavesThatHoldSurface) {
  const TestSolid solid(make_bracket(16));
  const GridLevel level = solid.level(0.08);
  Marks marks = no_marks(level);
  mark_surface(level, marks);
  for (CellIndex i = 0; i < level.size(); ++i) EXPECT_EQ(marks[i], level.holds_surface(i));
}

TEST(ConflictCriterion, MarksTheCellOfASmallCavityAndThoseAcrossItsFaces) {
  RandomSamples random(2);
  for (int trial = 0; trial < 6; ++trial) {
    const double size = 0.1, radius = random.uniform(0.01, 0.04);
    const Quaternion turn = random.rotation();
    const TriangleMesh block = rotate_mesh(make_box({1, 0.9, 0.8}), turn);
    const GridFrame frame = frame_around(prepare_surface(block).box, size);
    // The cavity is in the middle of the cell that holds the origin.
    const CellAddress finest = *frame.root.locate({0, 0, 0});
    CellAddress cell = finest;
    while (cell.depth() > frame.finest_depth) cell = cell.parent();
    const Vector3 centre = frame.root.centre(cell);
    const TestSolid solid(join_meshes(block, translate_mesh(flip_mesh(make_sphere(radius, 2)), centre)));
    const GridLevel level = uniform_level(solid.solid(), frame.root, frame.finest_depth).level;
    Marks marks = no_marks(level);
    mark_spectral_conflict(level, face_neighbours(level.tree), solid.solid(), marks);
    for (CellIndex i = 0; i < level.size(); ++i)
      ASSERT_EQ(marks[i], cells_from(level, i, centre) < 1.01) << "radius " << radius;
  }
}

TEST(ConflictCriterion, MarksNothingOnAnyTurnedBox) {
  RandomSamples random(3);
  for (int trial = 0; trial < 4; ++trial) {
    const TestSolid solid(rotate_mesh(make_box({1, 0.8, 0.6}), random.rotation()));
    const GridLevel level = solid.level(0.08);
    Marks marks = no_marks(level);
    mark_spectral_conflict(level, face_neighbours(level.tree), solid.solid(), marks);
    EXPECT_FALSE(any(marks));
  }
}

/// The share of a leaf's surface, leaving aside the largest of the three sides of an upright prism, that is
/// on other sides. Sides are told apart by their normals.
double share_of_other_sides(const GridLevel& level, const TestSolid& solid, CellIndex i, const Vector3& up) {
  std::vector<std::pair<Vector3, double>> sides;
  double total = 0;
  for (const SurfacePiece& piece : level.pieces_of(i)) {
    const Vector3& normal = solid.surface().normals[piece.triangle];
    total += piece.area;
    if (std::abs(dot(normal, up)) > 0.5) continue;
    auto side = std::find_if(sides.begin(), sides.end(),
                             [&](const auto& other) { return dot(other.first, normal) > 0.9; });
    if (side == sides.end()) side = sides.insert(side, {normal, 0});
    side->second += piece.area;
  }
  double sum = 0, largest = 0;
  for (const auto& [normal, area] : sides) {
    sum += area;
    largest = std::max(largest, area);
  }
  return total > 0 ? (sum - largest) / total : 0;
}

TEST(ConflictCriterion, MarksCellsThatHoldTwoSidesOfATriangularPrismAndTheirNeighbours) {
  // Angles of 60 degrees: no frame has axes along both normals. Its caps are at right angles to its sides.
  RandomSamples random(4);
  const double height = std::sqrt(0.75);
  const Loop2 triangle{{-0.5, -height / 3}, {0.5, -height / 3}, {0, 2 * height / 3}};
  for (int trial = 0; trial < 3; ++trial) {
    const Quaternion turn = random.rotation();
    const TestSolid solid(rotate_mesh(extrude(triangle, {}, -0.4, {0.4}), turn));
    const GridLevel level = solid.level(0.05);
    const Vector3 up = rotate(turn, {0, 0, 1});
    Marks marks = no_marks(level);
    mark_spectral_conflict(level, face_neighbours(level.tree), solid.solid(), marks);
    int conflicted = 0;
    for (CellIndex i = 0; i < level.size(); ++i) {
      double nearby = share_of_other_sides(level, solid, i, up);
      // A third of the area on another side leaves no doubt, even beside a cap.
      if (nearby > 0.33) {
        ASSERT_TRUE(marks[i]);
        ++conflicted;
      }
      for (int face = 0; face < kFaceCount; ++face) {
        const CellIndex j = level.tree.neighbour(i, face);
        if (j != kNoCell) nearby = std::max(nearby, share_of_other_sides(level, solid, j, up));
      }
      if (nearby == 0) {
        ASSERT_FALSE(marks[i]);
      }
    }
    EXPECT_GT(conflicted, 10);
  }
}

TEST(ThicknessCriterion, MarksAllOfAWallThinnerThanFourCells) {
  RandomSamples random(5);
  for (int trial = 0; trial < 6; ++trial) {
    const double size = 0.05, cells = random.uniform(0.7, 3.9);
    const Quaternion turn = random.rotation();
    const TestSolid wall(rotate_mesh(make_wall(cells * size), turn));
    const GridLevel level = wall.level(size);
    Marks marks = no_marks(level);
    mark_thin_walls(level, wall.solid(), marks);
    std::size_t away = 0, missed = 0;
    for (CellIndex i = 0; i < level.size(); ++i) {
      const Vector3 p = rotate(conjugate(turn), level.tree.centre(i));
      if (std::max(std::abs(p[0]), std::abs(p[1])) > 0.5 - 2 * size) continue;
      ++away;
      missed += !marks[i];
    }
    EXPECT_GT(away, 200u);
    // Cells without surface are marked from the rays that pass through them, one a boundary cell: some slip
    // between the rays.
    EXPECT_LE(missed, away / 50) << cells << " cells thick";
  }
}

TEST(ThicknessCriterion, MarksEverySurfaceCellOfThinWallsAwayFromTheRim) {
  RandomSamples random(6);
  const Quaternion turn = random.rotation();
  const TestSolid wall(rotate_mesh(make_wall(0.17), turn));
  const GridLevel level = wall.level(0.05);
  Marks marks = no_marks(level);
  mark_thin_walls(level, wall.solid(), marks);
  for (CellIndex i = 0; i < level.size(); ++i) {
    const Vector3 p = rotate(conjugate(turn), level.tree.centre(i));
    if (!level.holds_surface(i) || std::max(std::abs(p[0]), std::abs(p[1])) > 0.4) continue;
    ASSERT_TRUE(marks[i]);
  }
}

TEST(ThicknessCriterion, MarksNothingInABlockOfMoreThanFourCells) {
  RandomSamples random(7);
  for (int trial = 0; trial < 4; ++trial) {
    const double size = 0.05;
    const TestSolid block(rotate_mesh(make_wall(random.uniform(4.01, 8) * size), random.rotation()));
    const GridLevel level = block.level(size);
    Marks marks = no_marks(level);
    mark_thin_walls(level, block.solid(), marks);
    EXPECT_FALSE(any(marks));
  }
}

TEST(EnergyCriterion, MarksWhatExceedsTheThresholdInItsOwnSize) {
  const TestSolid solid(make_sphere(0.5, 2));
  GridLevel level = solid.level(0.2);
  Marks first(level.size(), false);
  first[0] = first[level.size() - 1] = true;
  level = refined(level, solid.solid(), first);  // cells of two sizes
  RandomSamples random(8);
  std::vector<float> density(level.size());
  for (float& value : density) value = static_cast<float>(random.uniform(0, 40));
  Marks marks = no_marks(level);
  mark_energy_density(level, density, 0.2, marks);
  for (CellIndex i = 0; i < level.size(); ++i) {
    const double size = level.tree[i].depth() == level.tree[level.size() / 2].depth() ? 0.2 : 0.1;
    EXPECT_EQ(marks[i], density[i] * size * size > 0.2);
  }
}

class RefinementMarksTest : public ::testing::Test {
 protected:
  Marks marks(int finest_depth, const std::vector<float>& density = {}) const {
    return refinement_marks(level_, neighbours_, solid_.solid(), density, 0.2, finest_depth);
  }

  // A wall of three cells, and a part thick enough for cells without a mark, with a small cavity for
  // conflict.
  const TestSolid solid_{
      join_meshes(join_meshes(make_cylinder(0.5, 0.6, 40), flip_mesh(make_sphere(0.03, 2))),
                  translate_mesh(make_cylinder(0.5, 0.12, 40), {1.2, 0, 0}))};
  const GridLevel level_ = solid_.level(0.08);
  const std::vector<FaceNeighbours> neighbours_ = face_neighbours(level_.tree);
  const int depth_ = frame_around(solid_.surface().box, 0.08).finest_depth;
};

TEST_F(RefinementMarksTest, AreThoseOfAllCriteria) {
  Marks of_surface = no_marks(level_);
  mark_surface(level_, of_surface);
  Marks of_walls = of_surface;
  mark_thin_walls(level_, solid_.solid(), of_walls);
  EXPECT_NE(of_walls, of_surface);
  Marks expected = of_walls;
  mark_spectral_conflict(level_, neighbours_, solid_.solid(), expected);
  EXPECT_NE(expected, of_walls);
  EXPECT_EQ(marks(depth_ + 1), expected);

  const auto inside =
      static_cast<CellIndex>(std::find(expected.begin(), expected.end(), false) - expected.begin());
  ASSERT_LT(inside, level_.size());
  std::vector<float> density(level_.size(), 0);
  density[inside] = 1e6;
  expected[inside] = true;
  EXPECT_EQ(marks(depth_ + 1, density), expected);
}

TEST_F(RefinementMarksTest, SpareWhatIsFinestAlready) {
  EXPECT_FALSE(any(marks(depth_)));
  EXPECT_TRUE(any(marks(depth_ + 1)));
}

}  // namespace
}  // namespace crossgrain
