// SPDX-License-Identifier: Apache-2.0
#include "grid/open_faces.hpp"

#include <gtest/gtest.h>

#include "grid/test_solid.hpp"
#include "harmonics/random_samples.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::RandomSamples;
using testing::TestSolid;

constexpr double kStep = 1.0 / kOpenFaceSamples;

double open_fraction(const GridLevel& level, const Solid& solid, CellIndex i, int face) {
  return kStep * open_samples(level, solid, i, face);
}

/// The share of the unit square centred at 0 where a x + b y < c, by clipping the square.
double share_below(double a, double b, double c) {
  const std::array<std::array<double, 2>, 4> square{{{-.5, -.5}, {.5, -.5}, {.5, .5}, {-.5, .5}}};
  std::vector<std::array<double, 2>> kept;
  for (int i = 0; i < 4; ++i) {
    const auto p = square[i], q = square[(i + 1) % 4];
    const double at_p = a * p[0] + b * p[1] - c, at_q = a * q[0] + b * q[1] - c;
    if (at_p < 0) kept.push_back(p);
    if ((at_p < 0) == (at_q < 0)) continue;
    const double t = at_p / (at_p - at_q);
    kept.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])});
  }
  double twice_area = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto p = kept[i], q = kept[(i + 1) % kept.size()];
    twice_area += p[0] * q[1] - p[1] * q[0];
  }
  return twice_area / 2;
}

TEST(OpenFraction, OfCellsAtAPlaneIsThePartOfTheFaceBehindIt) {
  RandomSamples random(1);
  double squares = 0, largest = 0;
  int cut = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const Quaternion turn = random.rotation();
    const TestSolid box(rotate_mesh(make_box({1, 1, 1}), turn));
    const GridLevel level = box.level(1.0 / 11);
    const Vector3 normal = rotate(turn, {0, 0, 1});
    for (CellIndex i = 0; i < level.size(); ++i) {
      const Vector3 p = rotate(conjugate(turn), level.tree.centre(i));
      // Cells that reach the top only.
      if (!level.holds_surface(i) || p[2] < 0.3 || std::abs(p[0]) > 0.4 || std::abs(p[1]) > 0.4) continue;
      const double size = level.tree.cell_size(i), depth_below = (0.5 - p[2]) / size;
      for (int face = 0; face < kFaceCount; ++face) {
        const int axis = face_axis(face), axis1 = (axis + 1) % 3, axis2 = (axis + 2) % 3;
        const double exact =
            share_below(normal[axis1], normal[axis2], depth_below - 0.5 * face_sign(face) * normal[axis]);
        const double error = std::abs(open_fraction(level, box.solid(), i, face) - exact);
        largest = std::max(largest, error);
        squares += error * error;
        ++cut;
      }
    }
  }
  ASSERT_GT(cut, 2000);
  // A line along a row of samples is off by half a row; on average it is off by less than one sample.
  EXPECT_LE(largest, 0.5 / kOpenFaceSide + 1e-9);
  EXPECT_LE(std::sqrt(squares / cut), kStep);
}

TEST(OpenFraction, OfALeafWithoutSurfaceIsOne) {
  const TestSolid box(make_box({1, 1, 1}));
  const GridLevel level = box.level(0.1);
  const CellIndex middle = level.tree.find_containing(*level.tree.root().locate({0, 0, 0}));
  for (int face = 0; face < kFaceCount; ++face) EXPECT_EQ(open_fraction(level, box.solid(), middle, face), 1);
}

TEST(OpenFraction, IsTheSameFromBothCellsOfAFaceAtASmoothSurface) {
  const TestSolid sphere(make_sphere(0.8, 3));
  const GridLevel level = sphere.level(0.11);
  int compared = 0;
  for (CellIndex i = 0; i < level.size(); ++i) {
    for (const int face : {1, 3, 5}) {
      const CellIndex j = level.tree.neighbour(i, face);
      if (j == kNoCell || !level.holds_surface(i) || !level.holds_surface(j)) continue;
      ASSERT_EQ(open_fraction(level, sphere.solid(), i, face),
                open_fraction(level, sphere.solid(), j, opposite_face(face)));
      ++compared;
    }
  }
  EXPECT_GT(compared, 200);
}

TEST(OpenFraction, OfASurfaceTurnedInsideOutIsTheSame) {
  const TestSolid solid(make_bracket(16)), inside_out(flip_mesh(make_bracket(16)));
  const GridLevel a = solid.level(0.08), b = inside_out.level(0.08);
  ASSERT_EQ(a.size(), b.size());
  for (CellIndex i = 0; i < a.size(); ++i) {
    for (int face = 0; face < kFaceCount; ++face)
      ASSERT_EQ(open_fraction(a, solid.solid(), i, face), open_fraction(b, inside_out.solid(), i, face));
  }
}

TEST(OpenFraction, IsZeroForCellFacesInTheGapBetweenTwoPlates) {
  for (const double gap : {0.02, 0.05, 0.09}) {
    const TestSolid plates(make_plates(gap));
    // A face between cells of 0.1 lies in the plane z = 0.1 * gap.
    const RootCube root{{-0.83, -0.77, -0.8 + 0.1 * gap}, 1.6};
    const GridLevel level = uniform_level(plates.solid(), root, 4).level;
    int faces = 0;
    for (CellIndex i = 0; i < level.size(); ++i) {
      const Box box = root.box(level.tree[i]);
      if (std::abs(box.high[2] - 0.1 * gap) > 1e-9) continue;
      ASSERT_EQ(open_fraction(level, plates.solid(), i, 5), 0);
      ++faces;
    }
    EXPECT_GE(faces, 100);
  }
}

TEST(TwoSheets, AreHeldByACellThatStraddlesAThinGap) {
  const TestSolid plates(make_plates(0.03));
  const RootCube root{{-0.83, -0.77, -0.85}, 1.6};  // cells of 0.1, one from z = -0.05 to 0.05
  const GridLevel level = uniform_level(plates.solid(), root, 4).level;
  int straddling = 0;
  for (CellIndex i = 0; i < level.size(); ++i) {
    const Vector3 centre = level.tree.centre(i);
    if (std::abs(centre[0]) > 0.4 || std::abs(centre[1]) > 0.4) continue;
    const bool straddles = std::abs(centre[2]) < 0.01;
    ASSERT_EQ(holds_two_sheets(level, plates.solid(), i), straddles);
    straddling += straddles;
  }
  EXPECT_GT(straddling, 40);
}

TEST(TwoSheets, AreHeldByACellWithAThinWallInIt) {
  RandomSamples random(2);
  const TestSolid wall(rotate_mesh(make_wall(0.02), random.rotation()));
  const GridLevel level = wall.level(0.1);
  std::size_t two = 0, all = 0;
  for (CellIndex i = 0; i < level.size(); ++i) {
    double area = 0;
    for (const SurfacePiece& piece : level.pieces_of(i)) area += piece.area;
    if (area < 0.01) continue;  // less than a cell face
    ++all;
    two += holds_two_sheets(level, wall.solid(), i);
  }
  EXPECT_GT(all, 50u);
  EXPECT_GT(two, 9 * all / 10);
}

TEST(TwoSheets, AreNotHeldByCellsOfAThickBlock) {
  RandomSamples random(3);
  const TestSolid box(rotate_mesh(make_box({1, 0.8, 0.6}), random.rotation()));
  const GridLevel level = box.level(0.1);
  for (CellIndex i = 0; i < level.size(); ++i) ASSERT_FALSE(holds_two_sheets(level, box.solid(), i));
}

}  // namespace
}  // namespace crossgrain
