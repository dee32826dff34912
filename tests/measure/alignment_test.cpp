// SPDX-License-Identifier: Apache-2.0
#include "measure/alignment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/parallel.hpp"
#include "field/connected_level.hpp"
#include "field/octree_graph.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Single precision in which frames are stored, in degrees.
constexpr double kStorage_deg = 2e-5;

/// A solid on a uniform grid, and one frame for every cell.
struct Measured {
  Measured(const TriangleMesh& mesh, double cell_size, const Quaternion& frame)
      : surface(prepare_surface(mesh)), bvh(surface), winding(bvh) {
    const auto [root, depth] = frame_around(surface.box, cell_size);
    level = uniform_level(solid, root, depth).level;
    open_faces = testing::connect_leaves(level, solid).open_faces;
    frames.assign(level.size(), to_stored(frame));
  }

  AlignmentMeasurement alignment() const {
    return measure_alignment(level, solid, {level.tree, frames, open_faces});
  }

  Surface surface;
  TriangleBvh bvh;
  WindingNumber winding;
  Solid solid{surface, bvh, winding};
  GridLevel level;
  std::vector<std::uint8_t> open_faces;
  std::vector<StoredQuaternion> frames;
};

const Quaternion kTilt = from_rotation_vector({0.4, -0.7, 0.5});

TEST(AngleToNearestAxis, IsTheTiltForSmallTiltsAndItsComplementPast45Degrees) {
  for (const double angle_deg : {1e-7, 0.1, 30.0, 44.9}) {
    const Quaternion frame = from_rotation_vector({0, 0, angle_deg * kDegree});
    EXPECT_NEAR(angle_to_nearest_axis_deg(frame, {1, 0, 0}), angle_deg, 1e-13);
  }
  EXPECT_NEAR(angle_to_nearest_axis_deg(from_rotation_vector({0, 0, 50 * kDegree}), {1, 0, 0}), 40, 1e-12);
}

TEST(AngleToNearestAxis, IsLargestAlongTheDiagonal) {
  const double s = 1 / std::sqrt(3.0);
  EXPECT_NEAR(angle_to_nearest_axis_deg({}, {s, -s, s}), std::acos(s) / kDegree, 1e-12);
}

TEST(Alignment, OfATiltedBoxInItsOwnFrameIsZero) {
  const Measured box(rotate_mesh(make_box({1.4, 1.2, 0.6}), kTilt), 1.0 / 8, kTilt);
  const AlignmentMeasurement result = box.alignment();
  EXPECT_LT(result.alignment_deg.max.value(), kStorage_deg);
  EXPECT_EQ(result.alignment_deg.excluded_share, 0);
}

TEST(Alignment, OfABoxTurnedAboutItsThirdAxisIsTheTurnOverTheShareOfItsSides) {
  const double turn_deg = 7;
  const Quaternion turned = kTilt * from_rotation_vector({0, 0, turn_deg * kDegree});
  const Measured box(rotate_mesh(make_box({1.4, 1.2, 0.6}), kTilt), 1.0 / 8, turned);
  const AlignmentMeasurement result = box.alignment();
  const double sides = 2 * (1.4 + 1.2) * 0.6, ends = 2 * 1.4 * 1.2;
  // Areas of pieces are stored in single precision.
  EXPECT_NEAR(result.alignment_deg.mean.value(), turn_deg * sides / (sides + ends), 1e-5);
  EXPECT_NEAR(result.alignment_deg.max.value(), turn_deg, kStorage_deg);
  EXPECT_NEAR(result.alignment_deg.p95.value(), turn_deg, kStorage_deg);
}

TEST(Alignment, NinetyFifthPercentileLeavesOutWhatIsWorseOnLessArea) {
  // A plate: its rim is 2 % of the surface.
  const Measured plate(make_box({1, 1, 0.01}), 1.0 / 8, from_rotation_vector({0, 0, 0.2}));
  const AlignmentMeasurement result = plate.alignment();
  EXPECT_LT(result.alignment_deg.p95.value(), kStorage_deg);
}

TEST(Alignment, OfALeafIsTheMeanOverItsOwnSurface) {
  const Measured box(make_box({1.4, 1.2, 0.6}), 1.0 / 8, from_rotation_vector({0, 0, 5 * kDegree}));
  const AlignmentMeasurement result = box.alignment();
  for (CellIndex i = 0; i < box.level.size(); ++i) {
    double sides = 0, area = 0;
    for (const SurfacePiece& piece : box.level.pieces_of(i)) {
      area += piece.area;
      if (std::abs(box.surface.normals[piece.triangle][2]) < 0.5) sides += piece.area;
    }
    ASSERT_NEAR(result.leaf_mean_deg[i], area > 0 ? 5 * sides / area : 0, kStorage_deg);
  }
}

TEST(Alignment, CountsEveryLeafWithSurfaceInOneClass) {
  const Measured box(make_box({1.4, 1.2, 0.6}), 1.0 / 8, {});
  const auto spectrum = box.alignment().spectrum;
  std::size_t with_surface = 0;
  for (CellIndex i = 0; i < box.level.size(); ++i) with_surface += box.level.holds_surface(i);
  EXPECT_EQ(spectrum.plane + spectrum.axis + spectrum.frame + spectrum.free + spectrum.conflicted,
            with_surface);
  EXPECT_GT(spectrum.plane, 2 * spectrum.frame);
  EXPECT_GT(spectrum.frame, 0u);
}

TEST(Alignment, SaysOfEveryLeafWhatItsSurfaceAsksFor) {
  const Measured box(make_box({1.4, 1.2, 0.6}), 1.0 / 8, {});
  const AlignmentMeasurement result = box.alignment();
  ASSERT_EQ(result.leaf_constraints.size(), box.level.size());
  for (CellIndex i = 0; i < box.level.size(); ++i)
    EXPECT_EQ(result.leaf_constraints[i] != CellConstraint::kNoSurface, box.level.holds_surface(i));
  const auto of = [&](CellConstraint constraint) {
    return static_cast<std::size_t>(std::ranges::count(result.leaf_constraints, constraint));
  };
  EXPECT_EQ(of(CellConstraint::kPlane), result.spectrum.plane);
  EXPECT_EQ(of(CellConstraint::kFrame), result.spectrum.frame);
}

TEST(Alignment, LeavesOutTheSurfaceInCellsThatNoFrameSuits) {
  // A rod of three sides, each cell holding all of them: no frame has an axis along normals at 120 degrees.
  const Measured rod(make_cylinder(0.03, 0.8, 3), 0.2, {});
  const AlignmentMeasurement result = rod.alignment();
  EXPECT_EQ(result.spectrum.plane, 0u);
  EXPECT_GT(result.spectrum.axis + result.spectrum.conflicted, 0u);
  EXPECT_EQ(result.alignment_deg.excluded_share, 1);
  EXPECT_FALSE(result.alignment_deg.max);
}

TEST(Alignment, IsTheSameToTheBitOnOneThread) {
  const Measured bracket(make_bracket(32), 0.06, kTilt);
  const AlignmentMeasurement many = bracket.alignment();
  const ThreadLimit one_thread(1);
  const AlignmentMeasurement one = bracket.alignment();
  EXPECT_EQ(many.alignment_deg.mean.value(), one.alignment_deg.mean.value());
  EXPECT_EQ(many.alignment_deg.p95.value(), one.alignment_deg.p95.value());
  EXPECT_EQ(many.leaf_mean_deg, one.leaf_mean_deg);
  EXPECT_EQ(many.leaf_constraints, one.leaf_constraints);
}

}  // namespace
}  // namespace crossgrain
