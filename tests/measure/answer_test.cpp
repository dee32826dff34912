// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "crossgrain/report.hpp"
#include "crossgrain/verdict.hpp"

namespace crossgrain {
namespace {

/// The report of a field without lines that half the resolution confirms.
SolveReport sound() {
  SolveReport report;
  report.resolution = 64;
  report.coarser.emplace().resolution = 32;
  return report;
}

void add_bad_arc(SolveReport::Singularity& singularity) {
  SolveReport::Singularity::Arc arc;
  arc.type = SingularityGraph::ArcType::kChanging;
  arc.verdict = Verdict::kNotMeshable;
  arc.place = {1, 2, 3};
  singularity.arc_list.push_back(arc);
  singularity.arcs = 1;
  singularity.verdict = Verdict::kNotMeshable;
}

TEST(Answer, IsYesOnlyIfHalfTheResolutionHasTheSameLines) {
  SolveReport report = sound();
  EXPECT_EQ(sentence_of(answer_of(report)), "hexahedra fit locally (necessary, not sufficient)");
  report.coarser->arcs = 1;
  EXPECT_EQ(answer_of(report).verdict, Verdict::kUndecided);
  EXPECT_EQ(answer_of(report).reasons[0].kind, ReasonKind::kOtherAtHalf);
  report.coarser.reset();
  EXPECT_EQ(answer_of(report).reasons[0].kind, ReasonKind::kNoComparison);
}

TEST(Answer, IsNoForAnArcOnlyIfHalfTheResolutionHasTheSameLines) {
  SolveReport report = sound();
  add_bad_arc(report.singularity);
  EXPECT_EQ(answer_of(report).verdict, Verdict::kUndecided);
  report.coarser->arcs = 1;
  report.coarser->verdict = Verdict::kNotMeshable;
  EXPECT_EQ(answer_of(report).verdict, Verdict::kNotMeshable);
  EXPECT_TRUE(
      sentence_of(answer_of(report))
          .starts_with(
              "hexahedra cannot follow this field at 1 2 3: along a singular line three hexahedra would "
              "become five; "));
}

TEST(Answer, IsNoForAKnifeEdgeWhateverTheCells) {
  SolveReport report = sound();
  report.coarser.reset();
  report.singularity.crease_list.push_back({1, 30, 30, 2, 1, Verdict::kNotMeshable, {4, 5, 6}, {3, 8}});
  const Answer answer = answer_of(report);
  EXPECT_EQ(answer.verdict, Verdict::kNotMeshable);
  EXPECT_EQ(answer.reasons.front().kind, ReasonKind::kKnifeEdge) << "faults come first";
  EXPECT_EQ(answer.reasons.size(), 2u);
  EXPECT_EQ(sentence_of(answer),
            "hexahedra cannot follow this field at 4 5 6: the edge of 30 degrees between faces 3 and 8 is "
            "too sharp for a "
            "hexahedron; 'crossgrain hex' changes the field, and may mesh the part; next: give the edge a "
            "fillet or a chamfer");
}

TEST(Answer, OfAFieldSaysNothingOfAMeshThatWasMade) {
  SolveReport report = sound();
  report.singularity.crease_list.push_back({1, 30, 30, 2, 1, Verdict::kNotMeshable, {4, 5, 6}});
  report.hexahedra.emplace();
  EXPECT_EQ(sentence_of(answer_of(report)).find("may still"), std::string::npos);
}

TEST(Answer, IsNoVerdictOnThePart) {
  for (const Verdict verdict : {Verdict::kMeshable, Verdict::kNotMeshable, Verdict::kUndecided})
    EXPECT_EQ(std::string(words_of(verdict)).find("meshed"), std::string::npos);
}

TEST(Answer, NamesTheResolutionThatResolvesTheWalls) {
  SolveReport report = sound();
  report.walls.unresolved_share = 0.5;
  report.walls.deciding_cells = 1;
  const Answer answer = answer_of(report);
  EXPECT_EQ(answer.reasons.front().remedy, Remedy::kUseResolution);
  EXPECT_EQ(answer.reasons.front().remedy_number, 162);
  EXPECT_EQ(sentence_of(answer),
            "undecided, because walls under 50 % of the surface are thinner than 2.5 cells; next: use "
            "a resolution of 162");
}

TEST(Answer, IsUndecidedIfMostLinesAreTooShort) {
  SolveReport report = sound();
  report.singularity.arcs = report.coarser->arcs = 10;
  report.singularity.short_arcs = 5;
  EXPECT_EQ(answer_of(report).verdict, Verdict::kMeshable);
  report.singularity.short_arcs = 6;
  EXPECT_EQ(answer_of(report).verdict, Verdict::kUndecided);
  report.singularity.arcs = report.coarser->arcs = 1;
  report.singularity.short_arcs = 1;
  EXPECT_EQ(answer_of(report).verdict, Verdict::kMeshable) << "a few are never too many";
}

TEST(Answer, IsUndecidedIfFramesDoNotFollowTheCreases) {
  SolveReport report = sound();
  report.singularity.crease_list.push_back({1, 90, 90, 2, 0.95, Verdict::kMeshable, {}});
  EXPECT_EQ(answer_of(report).verdict, Verdict::kMeshable);
  report.singularity.crease_list.push_back({1, 90, 90, 2, 0.5, Verdict::kMeshable, {}});
  EXPECT_EQ(answer_of(report).reasons[0].kind, ReasonKind::kCreases);
}

TEST(Answer, OnTetsIsAboutTheTets) {
  SolveReport report;
  add_bad_arc(report.singularity);
  report.onto.emplace();
  EXPECT_EQ(answer_of(report).verdict, Verdict::kMeshable);
  report.onto->unfollowed_share = 0.5;
  report.onto->edge_length = 1;
  report.onto->crease_deg.mean = 30;
  EXPECT_EQ(
      sentence_of(answer_of(report)),
      "undecided, because the field is more than 25 degrees off 50 % of the surface; next: take tets with "
      "edges of 0.5");
}

TEST(Answer, OnTetsThatOverlapIsUndecided) {
  SolveReport report;
  report.warnings.emplace_back(WarningKind::kOverlappingTets, "faces with both tets on the same side");
  report.onto.emplace();
  EXPECT_EQ(sentence_of(answer_of(report)), "undecided, because tets overlap; next: mesh the part again");
}

TEST(Answer, OfAStoppedSolveIsUndecided) {
  SolveReport report = sound();
  report.unfinished.emplace();
  EXPECT_EQ(answer_of(report).verdict, Verdict::kUndecided);
}

TEST(NameOfAReason, IsItsOwn) {
  std::set<std::string> names;
  for (int kind = 0; kind <= static_cast<int>(ReasonKind::kUnfinished); ++kind)
    EXPECT_TRUE(names.insert(name_of(static_cast<ReasonKind>(kind))).second);
}

}  // namespace
}  // namespace crossgrain
