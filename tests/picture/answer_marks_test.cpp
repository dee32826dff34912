// SPDX-License-Identifier: Apache-2.0
#include "picture/answer_marks.hpp"

#include <gtest/gtest.h>

#include "picture/singular_lines.hpp"

namespace crossgrain {
namespace {

SolveReport::Singularity with_corners(const std::vector<Verdict>& verdicts) {
  SolveReport::Singularity lines;
  for (const Verdict verdict : verdicts) {
    SolveReport::Singularity::Corner corner;
    corner.verdict = verdict;
    corner.place = {static_cast<double>(lines.corner_list.size()), 0, 0};
    lines.corner_list.push_back(corner);
  }
  return lines;
}

std::vector<std::string> texts_of(const LegendBlock& block) {
  std::vector<std::string> texts{block.title};
  for (const Sign& sign : block.signs) texts.push_back(sign.text);
  return texts;
}

TEST(AnswerLegend, HasTheWordsThatTheSentenceBeginsWith) {
  SolveReport report;
  for (const Verdict verdict : {Verdict::kMeshable, Verdict::kNotMeshable, Verdict::kUndecided}) {
    report.answer.verdict = verdict;
    const std::string words = answer_legend(report, true).title.substr(std::string("Answer: ").size());
    EXPECT_EQ(sentence_of(report.answer).substr(0, words.size()), words);
    EXPECT_EQ(words, words_of(verdict));
  }
}

TEST(AnswerLegend, CountsCreasesAndCornersThatAreNotMeshableOrUndecided) {
  SolveReport report;
  report.answer.verdict = Verdict::kNotMeshable;
  report.singularity =
      with_corners({Verdict::kUndecided, Verdict::kMeshable, Verdict::kNotMeshable, Verdict::kNotMeshable});
  report.singularity.crease_list.resize(3);
  report.singularity.crease_list[1].verdict = Verdict::kNotMeshable;
  EXPECT_EQ(texts_of(answer_legend(report, true)),
            (std::vector<std::string>{"Answer: hexahedra cannot follow this field",
                                      "crease, impossible for hexahedra (1)",
                                      "corner, impossible for hexahedra (2)", "corner, undecided (1)"}));
  EXPECT_EQ(texts_of(answer_legend(report, false)).size(), 1u);
}

TEST(AnswerLegend, SaysTheFirstReasonAndHowManyThereAre) {
  SolveReport report;
  report.answer.reasons.resize(3);
  report.answer.reasons[0].text = "walls have fewer than 2.5 cells";
  EXPECT_EQ(answer_legend(report, true).notes,
            (std::vector<std::string>{"walls have fewer than 2.5 cells", "and 2 other reasons"}));
}

std::vector<Facet> marks_of(const SolveReport& report) {
  std::vector<Facet> facets;
  answer_marks(report, 0.5, facets);
  return facets;
}

constexpr std::size_t kFacetsOfCube = 12;

TEST(AnswerMarks, AreCubesInTheColoursOfTheLegend) {
  SolveReport report;
  report.singularity = with_corners({Verdict::kMeshable, Verdict::kUndecided, Verdict::kNotMeshable});
  const std::vector<Facet> facets = marks_of(report);
  const LegendBlock legend = answer_legend(report, true);
  ASSERT_EQ(facets.size(), 2 * kFacetsOfCube);
  const std::array<double, 2> places{2, 1};  // what is certain comes first
  for (std::size_t k = 0; k < facets.size(); ++k) {
    EXPECT_EQ(facets[k].colour, legend.signs[k / kFacetsOfCube].colour);
    EXPECT_EQ(legend.signs[k / kFacetsOfCube].shape, Sign::Shape::kCube);
    const auto& [a, b, c] = facets[k].corners;
    const Vector3 centre{places[k / kFacetsOfCube], 0, 0};
    EXPECT_GT(dot(cross(b - a, c - a), a - centre), 0) << "seen from outside";
    EXPECT_LT(norm(a - centre), 2);
  }
}

TEST(AnswerMarks, AreThoseOfTheTetsIfThereAreTets) {
  SolveReport report;
  report.singularity = with_corners({Verdict::kNotMeshable, Verdict::kNotMeshable});
  report.onto.emplace().singularity = with_corners({Verdict::kMeshable, Verdict::kUndecided});
  const std::vector<Facet> facets = marks_of(report);
  ASSERT_EQ(facets.size(), kFacetsOfCube);
  EXPECT_EQ(facets[0].colour, kUndecidedLook.colour);
}

}  // namespace
}  // namespace crossgrain
