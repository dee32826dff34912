// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "crossgrain/hex_report.hpp"

namespace crossgrain {
namespace {

/// 1000 cubes of 2 that fill a model.
HexReport whole() {
  HexReport report;
  report.outcome = HexOutcome::kAllHex;
  report.size = report.used_size = report.mean_edge = 2;
  report.hexahedra = 1000;
  report.volume = report.model_volume = 8000;
  report.quality.least = report.quality.mean = 1;
  return report;
}

TEST(SentenceOfHexahedra, BeginsWithAnswerNumberAndSize) {
  EXPECT_EQ(sentence_of(whole()), "all-hex: 1000 hexahedra, mean edge 2");
}

TEST(SentenceOfHexahedra, TellsSmallerOnesThanAskedForAndWhy) {
  HexReport report = whole();
  report.used_size = report.mean_edge = 0.686;
  report.hexahedra = 24000;
  EXPECT_EQ(sentence_of(report),
            "all-hex: 24000 hexahedra, mean edge 0.686, not about 1000 of 2: larger ones would be turned "
            "inside out");
}

TEST(SentenceOfHexahedra, TellsThatLargerOnesFilledTheModelBadlyShaped) {
  HexReport report = whole();
  report.used_size = report.mean_edge = 1.4;
  report.hexahedra = 3000;
  HexAttempt larger;
  larger.outcome = HexOutcome::kAllHex;
  larger.size = 2;
  larger.hexahedra = 1285;
  report.attempts = {larger};
  EXPECT_EQ(sentence_of(report),
            "all-hex: 3000 hexahedra, mean edge 1.4, not about 1000 of 2: larger ones would be badly shaped");
  report.attempts[0].hexahedra = 100;
  EXPECT_EQ(sentence_of(report),
            "all-hex: 3000 hexahedra, mean edge 1.4, not about 1000 of 2: larger ones would be far fewer "
            "than expected");
}

TEST(SentenceOfHexahedra, TellsThatSmallerHexahedraMayHelpWhereNothingElseIsKnown) {
  HexReport report = whole();
  report.outcome = HexOutcome::kPartial;
  report.reason = "hexahedra would be turned inside out at 1 2 3, near face 4";
  report.places = {{1, 2, 3}};
  report.attempts.resize(1);
  const std::string begin = "partial: 1000 hexahedra, mean edge 2; " + report.reason + "; ";
  EXPECT_EQ(sentence_of(report), begin + "smaller hexahedra may help");
  EXPECT_EQ(sentence_of(report, "try --tet-size 2"), begin + "try --tet-size 2");
  report = whole();
  report.attempts.resize(1);
  EXPECT_EQ(sentence_of(report), "all-hex: 1000 hexahedra, mean edge 2") << "nothing is missing";
}

TEST(SentenceOfHexahedra, TellsOfALatticeThatItIsOneAndWhyThereIsNoMap) {
  HexReport report = whole();
  report.used_size = report.mean_edge = 1.4;
  report.hexahedra = 3000;
  report.attempts.resize(1);
  report.attempts[0].kind = "lattice";
  report.attempts[0].number = 1;
  report.map_fault = "hexahedra would be turned inside out at 1 2 3";
  EXPECT_EQ(
      sentence_of(report),
      "all-hex by a lattice: 3000 hexahedra, mean edge 1.4, not 2 as asked for: larger ones of a lattice "
      "do not keep the model");
  EXPECT_EQ(way_of(report),
            "attempt 1 of 1: lattice; no map, since hexahedra would be turned inside out at 1 2 3");
}

TEST(SentenceOfHexahedra, TellsWhetherLargerHexahedraOfALatticeLackSomethingOrAreBadlyShaped) {
  HexReport report = whole();
  report.used_size = report.mean_edge = 1.4;
  report.hexahedra = 3000;
  report.attempts.resize(2);
  for (HexAttempt& attempt : report.attempts) attempt.kind = "lattice";
  report.attempts[0].size = 2;
  report.attempts[0].outcome = HexOutcome::kApproximate;
  report.attempts[1].size = 1.4;
  report.attempts[1].outcome = HexOutcome::kAllHex;
  report.best_attempt = 1;
  EXPECT_NE(sentence_of(report).find(": larger ones of a lattice do not keep the model"), std::string::npos);
  report.attempts[0].outcome = HexOutcome::kAllHex;
  EXPECT_NE(sentence_of(report).find(": larger ones of a lattice are badly shaped"), std::string::npos);
}

TEST(SentenceOfHexahedra, AdvisesNoSmallerHexahedraWhereFacesBetweenSolidsAreSteps) {
  HexReport report = whole();
  report.outcome = HexOutcome::kApproximate;
  report.attempts.resize(1);
  report.reason = "it lacks something";
  EXPECT_NE(sentence_of(report).find("smaller hexahedra may help"), std::string::npos);
  report.reason = "the faces between its solids are steps of hexahedra, up to 1 off, 0.5 of the size";
  EXPECT_EQ(sentence_of(report).find("smaller"), std::string::npos) << "steps are as large as hexahedra";
}

TEST(SentenceOfHexahedra, TellsOtherNumbersThanExpectedAndWhy) {
  HexReport report = whole();
  report.hexahedra = 125;
  report.mean_edge = 4;
  EXPECT_EQ(sentence_of(report),
            "all-hex: 125 hexahedra, mean edge 4, not about 1000 of 2: the field leaves room for fewer");
  report.hexahedra = 8000;
  report.mean_edge = 1;
  EXPECT_EQ(sentence_of(report),
            "all-hex: 8000 hexahedra, mean edge 1, not about 1000 of 2: each wall and gap has one across");
}

TEST(SentenceOfHexahedra, TellsPoorShapesOfAPartWithTwoDigits) {
  HexReport report = whole();
  report.outcome = HexOutcome::kPartial;
  report.quality.least = 0.0041234;
  EXPECT_EQ(sentence_of(report),
            "partial: 1000 hexahedra, mean edge 2; badly shaped: worst scaled Jacobian 0.0041");
  report.reason = "badly shaped (worst scaled Jacobian 0.0041 at 1 2 3)";
  EXPECT_EQ(sentence_of(report), "partial: 1000 hexahedra, mean edge 2; " + report.reason) << "said once";
}

TEST(SentenceOfHexahedra, TellsWhatAPartLacksAndWhere) {
  HexReport report = whole();
  report.outcome = HexOutcome::kPartial;
  report.left_out = 1;
  report.left_out_place = {1, 2, 3};
  report.quality.inverted = 4;
  report.reason = "hexahedra would be turned inside out";
  EXPECT_EQ(sentence_of(report),
            "partial: 1000 hexahedra, mean edge 2, 1 cell left out near 1 2 3, 4 inverted; " + report.reason);
  report.left_out = report.quality.inverted = 0;
  EXPECT_EQ(sentence_of(report), "partial: 1000 hexahedra, mean edge 2; " + report.reason);
}

TEST(SentenceOfHexahedra, TellsWhatIsWrongWithAnApproximateMeshAndWhatHelps) {
  HexReport report = whole();
  report.outcome = HexOutcome::kApproximate;
  report.reason = "its volume is 22 % below the model's";
  report.remedy = Remedy::kUseHexSize;
  report.remedy_number = 0.15;
  report.remedy_hexahedra = 2.4e6;
  EXPECT_EQ(sentence_of(report, "try --size 0.15"),
            "approximate: 1000 hexahedra, mean edge 2; its volume is 22 % below the model's; try --size 0.15 "
            "(about 2.4 million)");
  EXPECT_EQ(sentence_of(report),
            "approximate: 1000 hexahedra, mean edge 2; its volume is 22 % below the model's; use hexahedra "
            "of 0.15 (about 2.4 "
            "million)");
}

TEST(SentenceOfHexahedra, TellsFirstThatTheSearchWasStopped) {
  HexReport report = whole();
  report.is_stopped = true;
  report.remedy = Remedy::kLetFinish;
  EXPECT_EQ(sentence_of(report),
            "all-hex, the search was stopped: 1000 hexahedra, mean edge 2; let it finish");
  report.outcome = HexOutcome::kPartial;
  report.reason = "hexahedra would be turned inside out";
  EXPECT_EQ(sentence_of(report),
            "partial, the search was stopped: 1000 hexahedra, mean edge 2; hexahedra would be turned inside "
            "out; let it finish");
}

TEST(WayOfHexahedra, TellsTheAttemptThatMadeThemOfAllThatWereMade) {
  HexReport report = whole();
  EXPECT_EQ(way_of(report), "");
  report.attempts.resize(4);
  report.attempts[0].tet_size = 3;
  const char* const kinds[] = {"tets", "repair", "part of the model", "tets"};
  for (std::size_t k = 0; k < 4; ++k) {
    report.attempts[k].kind = kinds[k];
    report.attempts[k].number = k;
    report.attempts[k].tets = k < 3 ? 500 : 0;  // the last failed
  }
  report.best_attempt = 1;
  EXPECT_EQ(way_of(report), "attempt 1 of 3: field on 500 tets of at most 3, repaired");
  report.best_attempt = 2;
  EXPECT_EQ(way_of(report), "attempt 2 of 3: field on 500 tets of at most 3, repaired, part of the model");
  report.best_attempt = report.attempts.size();
  EXPECT_EQ(way_of(report), "");
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

TEST(DistancesOfHexahedra, TellTheMeshFromTheModel) {
  HexReport report = whole();
  report.largest_distance = 0.17;
  report.largest_distance_place = {1, 2, 3};
  report.largest_distance_of_model = 2.07;
  report.largest_distance_of_model_place = {4, 0, 2};
  EXPECT_EQ(distances_of(report),
            "mesh up to 0.17 off the surface; surface up to 2.07 from the mesh, at 4 0 2");
  report.largest_distance = 3;
  EXPECT_EQ(distances_of(report), "surface up to 2.07 from the mesh; mesh up to 3 off the surface, at 1 2 3");
  report.largest_distance = report.largest_distance_of_model = 1e-12;
  EXPECT_EQ(distances_of(report), "nowhere off the surface");
  report.largest_distance_of_model = 2.07;
  EXPECT_EQ(distances_of(report), "mesh on the surface; surface up to 2.07 from the mesh, at 4 0 2");
  report.features.emplace();
  report.features->of_mesh.largest_in_all = 2;  // in sizes of 2
  report.features->of_mesh.place_in_all = {7, 7, 7};
  EXPECT_EQ(distances_of(report), "surface up to 2.07 from the mesh; mesh up to 4 off the surface, at 7 7 7")
      << "within a quad";
}

TEST(ShapesOfHexahedra, HaveTwoDigits) {
  HexReport::Quality quality;
  quality.least = 0.71234;
  quality.mean = 0.93456;
  quality.worst_place = {3.2, 0.1, 4};
  EXPECT_EQ(shapes_of(quality), "scaled Jacobian 0.71 at 3.2 0.1 4, 0.93 in the mean");
  quality.least = 0.00123;
  EXPECT_EQ(shapes_of(quality), "scaled Jacobian 0.0012, which is poor, at 3.2 0.1 4, 0.93 in the mean");
}

}  // namespace
}  // namespace crossgrain
