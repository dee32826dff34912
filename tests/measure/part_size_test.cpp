// SPDX-License-Identifier: Apache-2.0
#include "measure/part_size.hpp"

#include <gtest/gtest.h>

#include <string>

#include "crossgrain/error.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

double thickness_of(const TriangleMesh& mesh) {
  const Surface surface = prepare_surface(mesh);
  return usual_thickness(TriangleBvh(surface));
}

/// The message about a size of hexahedra in a box of these sides; empty if it suits.
std::string refusal_of(double size, const Vector3& sides, const std::string& unit = "") {
  TriangleMesh box = make_box(sides);
  box.unit = unit;
  const PartSize part = part_size(prepare_surface(box));
  try {
    check_asked_size({size, "hexahedra", 1, 20, part.volume / size / size / size, Remedy::kGiveHexSize},
                     part);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    return sentence_of(error.message());
  }
  return "";
}

void expect_words(const std::string& text, const std::string& words) {
  EXPECT_NE(text.find(words), std::string::npos) << text;
}

TEST(UsualThickness, OfACubeIsItsEdge) {
  EXPECT_NEAR(thickness_of(make_box({2, 2, 2})), 2, 1e-9);
}

TEST(UsualThickness, OfAPlateIsItsThicknessAndOfARodItsWidth) {
  EXPECT_NEAR(thickness_of(make_box({20, 15, 0.5})), 0.5, 1e-9);
  EXPECT_NEAR(thickness_of(make_box({20, 1, 1})), 1, 1e-9);
}

TEST(UsualThickness, OfABallIsItsDiameter) {
  // Facets cut in by less than 1 % of the radius.
  EXPECT_NEAR(thickness_of(make_sphere(1.5, 3)), 3, 0.03);
}

TEST(UsualThickness, DoesNotDependOnHowTrianglesAreSpread) {
  // Nearly all triangles are on the rim of the hole, which has a twentieth of the area.
  EXPECT_NEAR(thickness_of(make_box_with_hole(2000, 0.05)), 0.6, 1e-6);
}

TEST(AskedSize, ThatSuitsIsNotRefused) {
  EXPECT_EQ(refusal_of(0.1, {2, 1, 1.5}), "");
  EXPECT_EQ(refusal_of(2, {2, 1, 1.5}), "");  // one along the longest side
}

TEST(AskedSize, LargerThanThePartIsRefusedWithItsSizeAndASizeThatSuits) {
  const std::string text = refusal_of(3, {0.2, 0.1, 0.15});
  expect_words(text, "hexahedra of 3 are too large for the part, which is 0.2 across");
  expect_words(text, "; try hexahedra of 0.01");
}

TEST(AskedSize, InAnotherUnitIsRefusedWithTheUnitThatMayBeMeant) {
  expect_words(refusal_of(3, {0.2, 0.1, 0.15}),
               "; sizes are in the unit of the model (none is named; metres?)");
  expect_words(refusal_of(3, {2, 1, 1.5}), "(none is named; inches?)");
  expect_words(refusal_of(0.003, {200, 100, 150}), "; millimetres, and the size in metres?)");
  EXPECT_EQ(refusal_of(1e9, {2, 1, 1.5}).find('?'), std::string::npos);
  const std::string known = refusal_of(3, {0.2, 0.1, 0.15}, "mm");
  expect_words(known, "hexahedra of 3 mm are too large for the part, which is 0.2 mm across");
  EXPECT_EQ(known.find('?'), std::string::npos);
  expect_words(refusal_of(0.003, {200, 100, 150}, "mm"), "; in metres? That is 3 mm here");
  expect_words(refusal_of(3, {0.2, 0.1, 0.15}, "m"), "; in millimetres? That is 0.003 m here");
}

TEST(AskedSize, BeyondAnyMemoryIsRefusedWithoutNumbersThatAreNone) {
  expect_words(refusal_of(1e-5, {2, 1, 1.5}), "about 3e+15 of them would fill it");
  for (const double size : {1e-300, 5e-324}) {
    const std::string text = refusal_of(size, {2, 1, 1.5});
    expect_words(text, "no memory holds as many as would fill it");
    EXPECT_EQ(text.find("inf"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace crossgrain
