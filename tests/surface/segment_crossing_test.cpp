// SPDX-License-Identifier: Apache-2.0
#include "surface/segment_crossing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "harmonics/random_samples.hpp"
#include "support/shapes.hpp"
#include "surface/bvh.hpp"
#include "surface/winding_number.hpp"

namespace crossgrain {
namespace {

using testing::RandomSamples;

const std::array<Vector3, 3> kTriangle{Vector3{0, 0, 0}, Vector3{1, 0, 0}, Vector3{0, 1, 0}};  // normal +z

/// Along the segment from a to b; nothing where it is not certain.
std::optional<int> winding_change(const std::array<Vector3, 3>& corners, const Vector3& a, const Vector3& b) {
  const auto [change, certain] = CrossingsFrom(corners, a).to(b);
  if (!certain) return std::nullopt;
  return static_cast<int>(change);
}

TEST(WindingChange, IsOneAgainstTheNormalAndMinusOneAlongIt) {
  EXPECT_EQ(winding_change(kTriangle, {0.2, 0.3, 1}, {0.3, 0.2, -1}), 1);
  EXPECT_EQ(winding_change(kTriangle, {0.3, 0.2, -1}, {0.2, 0.3, 1}), -1);
}

TEST(WindingChange, IsNoneBesideTheTriangleAndShortOfIt) {
  EXPECT_EQ(winding_change(kTriangle, {0.8, 0.8, 1}, {0.8, 0.8, -1}), 0);
  EXPECT_EQ(winding_change(kTriangle, {0.2, 0.3, 1}, {0.2, 0.3, 0.1}), 0);
  EXPECT_EQ(winding_change(kTriangle, {-5, 0.2, 0.1}, {5, 0.2, 0.1}), 0);
}

TEST(WindingChange, IsLeftOpenAtEdgesCornersAndEndsInThePlane) {
  EXPECT_FALSE(winding_change(kTriangle, {0.5, 0, 1}, {0.5, 0, -1}));
  EXPECT_FALSE(winding_change(kTriangle, {0, 0, 1}, {0, 0, -1}));
  EXPECT_FALSE(winding_change(kTriangle, {0.5, 0.5, 1}, {0.5, 0.5, -1}));
  EXPECT_FALSE(winding_change(kTriangle, {0.2, 0.3, 0}, {0.2, 0.3, 1}));
}

TEST(WindingChange, IsCertainATrifleOffAnEdge) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const auto scaled = [&](double x, double y, double z) { return scale * Vector3{x, y, z}; };
    const std::array<Vector3, 3> triangle{scaled(0, 0, 0), scaled(1, 0, 0), scaled(0, 1, 0)};
    EXPECT_EQ(winding_change(triangle, scaled(0.5, 1e-12, 1), scaled(0.5, 1e-12, -1)), 1);
    EXPECT_EQ(winding_change(triangle, scaled(0.5, -1e-12, 1), scaled(0.5, -1e-12, -1)), 0);
  }
}

TEST(WindingChange, SumsUpToTheDifferenceOfWindingNumbersOverAClosedSurface) {
  RandomSamples random(1);
  const TriangleMesh overlapping =
      join_meshes(make_torus(0.6, 0.25, 24, 12), translate_mesh(make_sphere(0.4, 2), {0.5, 0.1, 0}));
  for (const TriangleMesh& mesh : {make_bracket(16), make_torus(0.6, 0.25, 24, 12), overlapping}) {
    const Surface surface = prepare_surface(rotate_mesh(mesh, random.rotation()));
    const TriangleBvh bvh(surface);
    const WindingNumber winding(bvh);
    int certain = 0, changed = 0;
    for (int trial = 0; trial < 2000; ++trial) {
      const Vector3 a = 0.4 * random.vector(), b = 0.4 * random.vector();
      int sum = 0;
      bool known = true;
      for (std::uint32_t t = 0; t < surface.size() && known; ++t) {
        const auto change = winding_change(surface.corners(t), a, b);
        known = change.has_value();
        sum += change.value_or(0);
      }
      if (!known) continue;
      ++certain;
      changed += sum != 0;
      ASSERT_EQ(sum, std::lround(winding.at(b)) - std::lround(winding.at(a)));
    }
    EXPECT_EQ(certain, 2000);
    EXPECT_GT(changed, 100);
  }
}

template <int W>
void expect_the_changes_of_single_segments() {
  RandomSamples random(11);
  for (int trial = 0; trial < 2000; ++trial) {
    // On a coarse grid of points, so that many segments pass edges, end in the plane or have no triangle.
    const auto point = [&] {
      const auto coordinate = [&] { return std::floor(random.uniform(0, 5)); };
      return Vector3{coordinate(), coordinate(), coordinate()};
    };
    const std::array<Vector3, 3> corners{point(), point(), point()};
    const Vector3 begin = point();
    BasicVector3<Lanes<W>> ends;
    for (int lane = 0; lane < W; ++lane) set_lane(ends, lane, point());
    const auto changes = CrossingsFrom(corners, begin).to(ends);
    for (int lane = 0; lane < W; ++lane) {
      const auto expected = winding_change(corners, begin, in_lane(ends, lane));
      ASSERT_EQ(changes.certain[lane], expected.has_value());
      if (expected.has_value()) {
        ASSERT_EQ(changes.change[lane], *expected);
      }
    }
  }
}

TEST(SegmentCrossing, OfSeveralSegmentsAtOnceIsThatOfEach) {
  expect_the_changes_of_single_segments<2>();
  expect_the_changes_of_single_segments<4>();
  expect_the_changes_of_single_segments<8>();
}

TEST(SegmentCrossing, ThatCannotReachTheEdgesIsTheSame) {
  RandomSamples random(12);
  int covered = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const std::array<Vector3, 3> corners{3 * random.vector(), 3 * random.vector(), 3 * random.vector()};
    const Vector3 begin = random.vector();
    const double reach = random.uniform(0.01, 1);
    Vector3 end = begin;
    for (double& x : end) x += random.uniform(-reach, reach);
    const auto expected = CrossingsFrom(corners, begin).to(end);
    const auto change = CrossingsFrom(corners, begin, reach).to(end);
    ASSERT_EQ(change.certain, expected.certain);
    ASSERT_EQ(change.change, expected.change);
    covered += change.change != 0;
  }
  EXPECT_GT(covered, 100);
}

}  // namespace
}  // namespace crossgrain
