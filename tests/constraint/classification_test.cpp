// SPDX-License-Identifier: Apache-2.0
#include "constraint/classification.hpp"

#include "constraint/random_cells.hpp"
#include "harmonics/sphere_quadrature.hpp"

namespace crossgrain {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

Vector3 tilted(double angle_degrees) {
  return {std::sin(angle_degrees * kDegree), 0, std::cos(angle_degrees * kDegree)};
}

// The class of facets however they are turned; fails where it depends on that.
ConstraintClass class_of(const std::vector<testing::Facet>& facets) {
  testing::RandomSamples random(1);
  const ConstraintClass found = classify(testing::form_of<3>(facets));
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(classify(testing::form_of<3>(testing::turned(facets, random.rotation()))), found);
  }
  return found;
}

// A strip of a cylinder, up to `half_degrees` to both sides of z.
std::vector<testing::Facet> strip(double half_degrees) {
  std::vector<testing::Facet> facets;
  for (int i = 0; i < 50; ++i) facets.push_back({tilted(half_degrees * (2 * (i + 0.5) / 50 - 1)), 0.02});
  return facets;
}

TEST(Classification, OfNothingIsFree) {
  EXPECT_EQ(classify(QuadraticForm<3>{}), ConstraintClass::kFree);
}

TEST(Classification, OfOneNormalIsAPlane) {
  EXPECT_EQ(class_of({{{0, 0, 1}, 1}}), ConstraintClass::kPlane);
}

TEST(Classification, OfACurvedPatchIsAPlaneUpToTwentyDegreesOfSpread) {
  for (const double half : {1.0, 5.0, 10.0, 15.0, 20.0})
    EXPECT_EQ(class_of(strip(half)), ConstraintClass::kPlane);
}

TEST(Classification, OfAShallowCreaseIsAPlane) {
  EXPECT_EQ(class_of({{tilted(0), 1}, {tilted(20), 1}}), ConstraintClass::kPlane);
}

TEST(Classification, OfARightEdgeIsAFrame) {
  EXPECT_EQ(class_of({{tilted(0), 1}, {tilted(90), 0.3}}), ConstraintClass::kFrame);
  EXPECT_EQ(class_of({{tilted(0), 1}, {tilted(82), 1}}), ConstraintClass::kFrame);
}

TEST(Classification, OfACornerIsAFrame) {
  EXPECT_EQ(class_of({{{1, 0, 0}, 1}, {{0, 1, 0}, 0.4}, {{0, 0, 1}, 0.2}}), ConstraintClass::kFrame);
}

TEST(Classification, OfAnEdgeOfSixtyDegreesIsACompromise) {
  EXPECT_EQ(class_of({{tilted(0), 1}, {tilted(60), 1}}), ConstraintClass::kFrameCompromised);
}

TEST(Classification, OfAnEdgeOfFortyFiveDegreesIsConflicted) {
  EXPECT_EQ(class_of({{tilted(0), 1}, {tilted(45), 1}}), ConstraintClass::kConflicted);
}

TEST(Classification, OfARodIsItsAxis) {
  std::vector<testing::Facet> rod;
  for (const auto& [direction, weight] : circle_quadrature<8>()) rod.push_back({direction, weight});
  EXPECT_EQ(class_of(rod), ConstraintClass::kAxis);
  rod.push_back({{0, 0, 1}, 0.5});
  EXPECT_EQ(class_of(rod), ConstraintClass::kAxis);
}

TEST(Classification, OfARegularPyramidIsItsAxis) {
  auto pyramid = testing::cone_facets(5, 54 * kDegree);
  pyramid.push_back({{0, 0, -1}, 5});
  EXPECT_EQ(class_of(pyramid), ConstraintClass::kAxis);
}

TEST(Classification, OfASmallSphereIsFree) {
  std::vector<testing::Facet> sphere;
  for (const auto& [direction, weight] : sphere_quadrature<6>()) sphere.push_back({direction, weight});
  EXPECT_EQ(class_of(sphere), ConstraintClass::kFree);
}

TEST(Classification, DoesNotDependOnTheWeightOfTheWhole) {
  const auto form = testing::form_of<3>(strip(15));
  for (const double factor : {1e-12, 1e12}) EXPECT_EQ(classify(scaled(form, factor)), classify(form));
}

TEST(Classification, CountsAsCompatibleWhatOneFrameFits) {
  EXPECT_TRUE(compatible(ConstraintClass::kPlane));
  EXPECT_TRUE(compatible(ConstraintClass::kFrame));
  for (const ConstraintClass other : {ConstraintClass::kFree, ConstraintClass::kAxis,
                                      ConstraintClass::kFrameCompromised, ConstraintClass::kConflicted}) {
    EXPECT_FALSE(compatible(other));
  }
}

}  // namespace
}  // namespace crossgrain
