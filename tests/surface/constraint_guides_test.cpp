// SPDX-License-Identifier: Apache-2.0
#include "surface/constraint_guides.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "harmonics/random_samples.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::RandomSamples;

constexpr double kRounding = 1e-12;

/// sum of value_i e_i e_i^T.
std::array<double, 6> tensor_of(const Quaternion& frame, const Vector3& values) {
  std::array<double, 6> t{};
  const auto axes = axes_of(frame);
  for (int i = 0; i < 3; ++i) {
    const auto& [x, y, z] = axes[i];
    const std::array<double, 6> outer{x * x, y * y, z * z, y * z, x * z, x * y};
    for (std::size_t k = 0; k < 6; ++k) t[k] += values[i] * outer[k];
  }
  return t;
}

void expect_gaps(const Vector3& values, const std::array<double, 3>& gaps) {
  RandomSamples random(7);
  for (int trial = 0; trial < 10; ++trial) {
    const Quaternion frame = random.rotation();
    const StressAxes axes = stress_axes(tensor_of(frame, values));
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(axes.gaps[k], gaps[k], kRounding);
      if (gaps[k] == 0) continue;
      EXPECT_NEAR(std::abs(dot(axes.directions[k], axes_of(frame)[k])), 1, kRounding);
    }
  }
}

TEST(StressAxes, WeighEachEigenvectorByTheGapOfItsEigenvalue) {
  expect_gaps({-1, 0, 1}, {0.5, 0.5, 0.5});
  expect_gaps({0, 1, 4}, {0.25, 0.25, 0.75});
  expect_gaps({-4, -3, -1}, {0.25, 0.25, 0.5});
}

TEST(StressAxes, OfTwoEqualEigenvaluesFixOneAxisOnly) {
  expect_gaps({0, 0, 5}, {0, 0, 1});
  expect_gaps({-5, 0, 0}, {1, 0, 0});
  expect_gaps({-1, -1, 1}, {0, 0, 1});
}

TEST(StressAxes, OfPressureOrNothingSayNothing) {
  expect_gaps({3, 3, 3}, {0, 0, 0});
  EXPECT_TRUE(stress_axes({}).say_nothing());
}

TEST(StressAxes, DoNotDependOnTheUnit) {
  for (const double unit : {1e-300, 1e-30, 1e30, 1e300}) {
    const StressAxes axes = stress_axes({0, unit, 4 * unit, 0, 0, 0});
    EXPECT_NEAR(axes.gaps[0], 0.25, kRounding);
    EXPECT_NEAR(axes.gaps[2], 0.75, kRounding);
  }
}

TEST(StressAxes, ReadShearsInTheOrderYzXzXy) {
  const double half = std::sqrt(0.5);
  const std::array<Vector3, 3> along{Vector3{0, half, half}, {half, 0, half}, {half, half, 0}};
  for (std::size_t shear = 0; shear < 3; ++shear) {
    std::array<double, 6> tensor{};
    tensor[3 + shear] = 1;
    const StressAxes axes = stress_axes(tensor);
    EXPECT_NEAR(std::abs(dot(axes.directions[2], along[shear])), 1, kRounding);
  }
}

TEST(Directions, OfAFrameAreTheNearestAtRightAngles) {
  // Two axes that lean towards each other by one angle are both turned by half of it.
  const double lean = 0.5 * std::numbers::pi / 180;
  const std::vector<Vector3> axes{{2, 0, 0}, {std::sin(lean), std::cos(lean), 0}, {0, 0, 1e200}};
  const std::vector<Vector3> directions = directions_of(axes);
  EXPECT_NEAR(directions[0][0], std::cos(lean / 2), kRounding);
  EXPECT_NEAR(directions[0][1], -std::sin(lean / 2), kRounding);
  EXPECT_NEAR(directions[1][0], std::sin(lean / 2), kRounding);
  EXPECT_NEAR(directions[1][1], std::cos(lean / 2), kRounding);
  EXPECT_NEAR(directions[2][2], 1, kRounding);
}

Guides guides_of(const Constraints& constraints) {
  TriangleMesh box = make_box({1, 1, 1});
  for (std::size_t t = 0; t < box.triangles.size(); ++t)
    box.faces.push_back(static_cast<std::int32_t>(t / 2) + 1);
  Guides guides;
  add_constraints(constraints, prepare_surface(box), guides);
  return guides;
}

TEST(ConstraintGuides, OfPolylinesRunAlongEachPieceAndPassOverRepeatedPoints) {
  const Guides guides =
      guides_of({.polylines = {{{{0, 0, 0}, {0.25, 0, 0}, {0.25, 0, 0}, {0.25, 0.5, 0}}, {}, 2}}});
  ASSERT_EQ(guides.segments.size(), 2u);
  EXPECT_EQ(guides.segments[0].directions[0], (Vector3{1, 0, 0}));
  EXPECT_EQ(guides.segments[1].directions[1], (Vector3{0, 1, 0}));
  EXPECT_EQ(guides.segments[1].weight, 2);
}

TEST(ConstraintGuides, OfAFrameAreThreeAxesOfTheSameWeight) {
  const std::vector<Vector3> frame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Guides guides = guides_of({.points = {{{0, 0, 0}, frame, 3}},
                                   .polylines = {{{{0, 0, 0}, {1, 0, 0}}, frame}},
                                   .faces = {{2, frame}}});
  ASSERT_EQ(guides.points.size(), 1u);
  EXPECT_EQ(guides.points[0].weights, (std::array<double, 3>{3, 3, 3}));
  EXPECT_EQ(guides.segments.size(), 3u);
  EXPECT_EQ(guides.faces.size(), 6u);  // of two triangles
}

TEST(ConstraintGuides, OfFacesHaveTheirNormalsUnlessToldOtherwise) {
  const Guides guides = guides_of({.faces = {{1}}});
  ASSERT_EQ(guides.faces.size(), 2u);
  for (const GuideFace& face : guides.faces) {
    const auto& [a, b, c] = face.corners;
    EXPECT_NEAR(std::abs(dot(face.directions[1], normalised(cross(b - a, c - a)))), 1, kRounding);
  }
}

TEST(ConstraintGuides, OfStressesThatSayNothingAreNone) {
  EXPECT_TRUE(guides_of({.stresses = {{{0, 0, 0}, {1, 1, 1, 0, 0, 0}}}}).empty());
}

std::string message_of(const Constraints& constraints) {
  try {
    check_constraints(constraints);
    guides_of(constraints);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    return error.what();
  }
  return "";
}

TEST(ConstraintGuides, NameFacesThatTheModelHasNotAndThoseThatItHas) {
  EXPECT_EQ(message_of({.faces = {{1}, {17}}}), "constraints: the model has no face 17, only 1 to 6");
  EXPECT_EQ(message_of({.faces = {{7, {}, 1, 12}}, .source = "c.json"}),
            "c.json: line 12: the model has no face 7, only 1 to 6");
}

TEST(Constraints, ThatMakeNoSenseAreRefused) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Vector3> x{{1, 0, 0}};
  const auto expect = [](const Constraints& constraints, const char* words) {
    EXPECT_NE(message_of(constraints).find(words), std::string::npos) << message_of(constraints);
  };
  expect({.points = {{{0, 0, 0}, x}, {{kNaN, 0, 0}, x}}}, "constraint point 1 (counted from 0): coordinates");
  expect({.points = {{{0, 0, 0}, {{0, 0, 0}}}}}, "must not be zero");
  expect({.points = {{{0, 0, 0}, {{kNaN, 0, 1}}}}}, "finite");
  expect({.points = {{{0, 0, 0}, {}}}}, "one, or the three");
  expect({.points = {{{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}}}}}, "one, or the three");
  expect({.points = {{{0, 0, 0}, {{1, 0.02, 0}, {0, 1, 0}, {0, 0, 1}}}}}, "right angles");
  for (const double weight : {0.0, -1.0, kNaN, 2e4}) expect({.points = {{{0, 0, 0}, x, weight}}}, "weight");
  expect({.polylines = {{{{0, 0, 0}}}}}, "two points");
  expect({.polylines = {{{{0, 0, 0}, {0, 0, 0}}}}}, "at one place");
  expect({.polylines = {{{{0, 0, 0}, {0, kNaN, 0}}}}}, "constraint polyline 0 (counted from 0): coordinates");
  expect({.faces = {{1, {}, 0}}}, "constraint face 0 (counted from 0): a weight");
  expect({.stresses = {{{0, 0, 0}, {kNaN, 0, 0, 0, 0, 0}}}},
         "constraint stress 0 (counted from 0): a stress tensor");
  EXPECT_EQ(message_of({.points = {{{0, 0, 0}, {{1, 0.01, 0}, {0, 1, 0}, {0, 0, 1}}}}}), "");
}

}  // namespace
}  // namespace crossgrain
