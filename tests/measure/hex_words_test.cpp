// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "crossgrain/hex_report.hpp"

namespace crossgrain {
namespace {

/// 1000 cubes of 2 that fill a model.
HexReport whole() {
  HexReport report;
  report.outcome = HexOutcome::kAllHex;
  report.size = report.used_size = 2;
  report.hexahedra = 1000;
  report.volume = report.model_volume = 8000;
  report.quality.least = report.quality.mean = 1;
  return report;
}

TEST(SentenceOfHexahedra, BeginsWithAnswerNumberAndSize) {
  EXPECT_EQ(sentence_of(whole()), "all-hex: 1000 of 2");
}

TEST(SentenceOfHexahedra, TellsSmallerOnesThanAskedForAndWhy) {
  HexReport report = whole();
  report.used_size = 0.686;
  report.hexahedra = 24000;
  EXPECT_EQ(sentence_of(report),
            "all-hex: 24000 of 0.686, not about 1000 of 2: larger ones would be turned inside out");
}

TEST(SentenceOfHexahedra, TellsOtherNumbersThanExpectedAndWhy) {
  HexReport report = whole();
  report.hexahedra = 125;
  EXPECT_EQ(sentence_of(report),
            "all-hex: 125 of 4 in the mean, not about 1000 of 2: the field leaves room for fewer");
  report.hexahedra = 8000;
  EXPECT_EQ(sentence_of(report),
            "all-hex: 8000 of 1 in the mean, not about 1000 of 2: each wall and gap has one across");
}

TEST(SentenceOfHexahedra, TellsPoorShapesWithTwoDigits) {
  HexReport report = whole();
  report.quality.least = 0.049;
  EXPECT_EQ(sentence_of(report), "all-hex: 1000 of 2; badly shaped: worst scaled Jacobian 0.049");
  report.quality.least = 0.0041234;
  EXPECT_EQ(sentence_of(report), "all-hex: 1000 of 2; badly shaped: worst scaled Jacobian 0.0041");
}

TEST(SentenceOfHexahedra, EndsWithReasonAndRemedy) {
  HexReport report;
  report.reason = "face 9 tapers to nothing between faces 17 and 12 at 1 2 3";
  report.remedy = Remedy::kUseEdgeLength;
  report.remedy_number = 5.9;
  EXPECT_EQ(sentence_of(report), "none: " + report.reason + "; take tets with edges of 5.9");
  EXPECT_EQ(sentence_of(report, "try --tet-size 5.9"), "none: " + report.reason + "; try --tet-size 5.9");
  report.remedy = Remedy::kNone;
  EXPECT_EQ(sentence_of(report), "none: " + report.reason);
}

TEST(ShapesOfHexahedra, HaveTwoDigits) {
  HexReport::Quality quality;
  quality.least = 0.71234;
  quality.mean = 0.93456;
  quality.worst_place = {3.2, 0.1, 4};
  EXPECT_EQ(shapes_of(quality), "scaled Jacobian 0.71 at 3.2 0.1 4, 0.93 in the mean");
  quality.least = 0.00123;
  EXPECT_EQ(shapes_of(quality), "scaled Jacobian 0.0012 at 3.2 0.1 4, 0.93 in the mean");
}

}  // namespace
}  // namespace crossgrain
