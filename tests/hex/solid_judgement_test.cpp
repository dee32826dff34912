// SPDX-License-Identifier: Apache-2.0
// Hexahedra of models of several solids.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "crossgrain/hexahedra.hpp"
#include "crossgrain/solve.hpp"
#include "hex/solid_judgement.hpp"
#include "solve/tet_domain_data.hpp"
#include "tets/several_tet_meshes.hpp"

namespace crossgrain {
namespace {

Hexahedra made_of(TetMesh mesh, double size = 1, bool unite_solids = false) {
  HexOptions options;
  options.size = size;
  SolveOptions solving;
  solving.unite_solids = unite_solids;
  return hexahedra(
      solve_onto(TetDomain(std::move(mesh)).prepared_for_map({.unite_solids = unite_solids}), solving),
      options);
}

TetMesh box(std::array<std::uint32_t, 3> cells) {
  return TetBox{cells}.mesh();
}

bool warns_of_interfaces(const std::vector<Warning>& warnings) {
  return std::ranges::any_of(
      warnings, [](const Warning& warning) { return warning.kind == WarningKind::kCrossedInterfaces; });
}

/// A box of two regions that meet in a plane across its longest side, turned by a slope.
TetMesh two_regions(double slope) {
  TetMesh mesh = with_regions(box({4, 2, 2}), [](const Vector3& p) { return p[0] < 2 ? 1 : 2; });
  for (Vector3& p : mesh.vertices)
    if (p[0] > 0 && p[0] < 4) p[0] += slope * (p[1] - 1);
  return mesh;
}

TEST(SolidJudgement, OfBodiesThatTouchWithoutCommonVerticesIsFlawed) {
  const HexReport report = made_of(together({box({3, 3, 2}), moved(box({2, 2, 2}), {0.4, 0.6, 2})})).report();
  EXPECT_EQ(report.outcome, HexOutcome::kPartial);
  EXPECT_EQ(report.reason.find("solids 1 and 2 touch, but are meshed apart, without common vertices, at "),
            0u)
      << report.reason;
  EXPECT_EQ(report.remedy, Remedy::kGlueSolids);
  EXPECT_EQ(report.places.size(), 1u);
  EXPECT_EQ(report.bodies, 2u);
}

TEST(SolidJudgement, OfBodiesThatOverlapIsFlawedWhichNothingElseSaysInOtherWords) {
  const Hexahedra made = made_of(together({box({3, 3, 2}), moved(box({1, 1, 2}), {1, 1, 1})}));
  const HexReport& report = made.report();
  for (const Warning& warning : made.field.report().warnings)
    EXPECT_EQ(warning.text.find("overlap"), std::string::npos) << warning.text;
  EXPECT_EQ(report.outcome, HexOutcome::kPartial);
  EXPECT_EQ(report.reason.find("solids 1 and 2 overlap, and both are meshed whole, one in the other, at "),
            0u)
      << report.reason;
  EXPECT_EQ(report.remedy, Remedy::kSeparateSolids);
}

TEST(SolidJudgement, OfBodiesApartIsASuccessThatTellsTheirNumber) {
  const HexReport report = made_of(together({box({2, 2, 2}), moved(box({2, 2, 1}), {3, 0, 0})})).report();
  EXPECT_EQ(report.outcome, HexOutcome::kAllHex);
  EXPECT_EQ(sentence_of(report), "all-hex: 12 hexahedra in 2 bodies, mean edge 1");
}

TEST(SolidJudgement, MeasuresFacesBetweenSolidsThatAreKept) {
  const HexReport report = made_of(two_regions(0)).report();
  EXPECT_EQ(report.interface_faces, 4u);
  EXPECT_LT(report.largest_interface_distance, 1e-9);
}

TEST(SolidJudgement, WarnsByHowMuchHexahedraLeaveTheFacesBetweenSolids) {
  const Hexahedra made = made_of(two_regions(0.4), 1, /*unite_solids=*/true);
  const double off = 0.4 / std::hypot(1, 0.4);
  EXPECT_NEAR(made.report().largest_interface_distance, off, 1e-6);
  EXPECT_FALSE(warns_of_interfaces(made.field.report().warnings));  // nobody asks for these faces
  HexReport report = made.report();
  SolveReport whole = made.field.report();
  whole.onto->united = false;
  const TetMesh tets = two_regions(0.4);
  std::vector<std::uint32_t> all(tets.tets.size());
  std::iota(all.begin(), all.end(), 0u);
  const TetDomain domain(tets);
  judge_solids(made.mesh, {all, domain.data().solid}, domain, {}, report, whole);
  const std::vector<Warning>& warnings = whole.warnings;
  ASSERT_TRUE(warns_of_interfaces(warnings));
  EXPECT_NE(warnings.back().text.find("4 of 4 faces between them are off, by up to 0.37 (0.37 of the size)"),
            std::string::npos)
      << warnings.back().text;
  EXPECT_EQ(report.outcome, HexOutcome::kAllHex);
  judge_interfaces(made.field.report(), report);
  EXPECT_EQ(report.outcome, HexOutcome::kAllHex) << "they are united";
  judge_interfaces(whole, report);
  EXPECT_EQ(report.outcome, HexOutcome::kApproximate);
  EXPECT_EQ(report.reason,
            "the faces between its solids are steps of hexahedra, up to 0.37 off, 0.37 of the size");
}

TEST(SolidJudgement, NamesBodiesWithoutHexahedraWhereTetsHaveNoRegions) {
  const Hexahedra made = made_of(box({3, 3, 2}));
  TetMesh tets = together({box({3, 3, 2}), moved(box({1, 1, 1}), {5, 0, 0})});
  const std::size_t of_first = TetMesh(box({3, 3, 2})).tets.size();
  tets.regions.clear();
  std::vector<std::uint32_t> centres(of_first);
  std::iota(centres.begin(), centres.end(), 0u);
  HexReport report = made.report();
  report.outcome = HexOutcome::kPartial;
  SolveReport whole = made.field.report();
  const TetDomain domain(tets);
  judge_solids(made.mesh, {centres, domain.data().solid}, domain, {}, report, whole);
  ASSERT_FALSE(whole.warnings.empty());
  EXPECT_EQ(whole.warnings.back().kind, WarningKind::kEmptySolids);
  EXPECT_EQ(whole.warnings.back().text.find("body 2 has no hexahedra, around 5."), 0u)
      << whole.warnings.back().text;
  report.outcome = HexOutcome::kAllHex;
  judge_solids(made.mesh, {centres, domain.data().solid}, domain, {}, report, whole);
  EXPECT_EQ(report.outcome, HexOutcome::kPartial);
}

TEST(SolidJudgement, LooksForHexahedraInTheTetsThatTheMapHasSplit) {
  const Hexahedra made = made_of(two_regions(0));
  // All centres lie in tets that the model has not.
  const TetSolid split =
      solid_of(with_regions(box({4, 2, 12}), [](const Vector3& p) { return p[0] < 2 ? 1 : 2; }));
  const TetDomain domain(two_regions(0));
  std::vector<std::uint32_t> centres(split.mesh.tets.size() - domain.mesh().tets.size());
  std::iota(centres.begin(), centres.end(), static_cast<std::uint32_t>(domain.mesh().tets.size()));
  HexReport report = made.report();
  SolveReport whole = made.field.report();
  judge_solids(made.mesh, {centres, split}, domain, {}, report, whole);
  EXPECT_EQ(report.outcome, HexOutcome::kAllHex);
}

TEST(SolidJudgement, OfASolidWithoutHexahedraIsFlawed) {
  const auto region_of = [](const Vector3& p) { return p[0] < 1 && p[1] < 1 && p[2] < 1 ? 2 : 1; };
  const HexReport report = made_of(with_regions(box({6, 6, 6}), region_of), 3).report();
  EXPECT_EQ(report.outcome, HexOutcome::kPartial);
  EXPECT_EQ(report.reason.find("solid 2 has no hexahedra, around 0."), 0u) << report.reason;
  ASSERT_EQ(report.places.size(), 1u);
  for (const double x : report.places[0]) EXPECT_LT(x, 1);
  EXPECT_EQ(report.remedy, Remedy::kUseHexSize);
  EXPECT_EQ(made_of(with_regions(box({6, 6, 6}), region_of), 1).report().outcome, HexOutcome::kAllHex);
}

}  // namespace
}  // namespace crossgrain
