// SPDX-License-Identifier: Apache-2.0
#include "results/report_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/names.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/writing.hpp"
#include "files/temporary_folder.hpp"

namespace crossgrain {
namespace {

template <class Enum>
std::vector<Enum> all_values() {
  std::vector<Enum> values;
  for (auto value = Enum{}; *name_of(value) != '\0';) {
    values.push_back(value);
    value = static_cast<Enum>(values.size());
  }
  return values;
}

template <class Enum>
std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const Enum value : all_values<Enum>()) names.emplace_back(name_of(value));
  return names;
}

/// A report in which each value of each enumeration stands somewhere.
SolveReport report_of_all_values() {
  SolveReport report;
  for (const auto kind : all_values<WarningKind>())
    report.warnings.push_back({kind, {"a.vtk", "line 12", "one"}});
  for (const auto remedy : all_values<Remedy>())
    report.warnings.push_back({WarningKind::kThinWalls, "two", remedy});
  for (const auto kind : all_values<FindingKind>()) report.input.findings.emplace_back().kind = kind;
  for (const auto done : all_values<FindingOutcome>()) report.input.findings.emplace_back().done = done;
  auto& graph = report.singularity;
  for (const auto type : all_values<SingularityGraph::ArcType>()) graph.arc_list.emplace_back().type = type;
  for (const auto verdict : all_values<Verdict>()) {
    graph.arc_list.emplace_back().verdict = verdict;
    graph.node_list.emplace_back().verdict = verdict;
  }
  report.onto.emplace().boundary = TetBoundary::kSmoothOnly;
  return report;
}

class NamesInReports : public ::testing::Test {
 protected:
  SolveReport read(const std::string& text) const { return read_report(folder_.write("report.json", text)); }

  /// The error of reading a report with `old` replaced where it is first.
  Error error_with(const std::string& old, const std::string& replacement) const {
    std::string text = report_json(report_of_all_values());
    const std::size_t place = text.find(old);
    EXPECT_NE(place, text.npos) << old;
    text.replace(place, old.size(), replacement);
    try {
      read(text);
    } catch (const Error& error) {
      return error;
    }
    ADD_FAILURE() << "no error about " << replacement;
    return {ErrorKind::kUsage, ""};
  }

  TemporaryFolder folder_;
};

TEST_F(NamesInReports, ReadBackAsTheValuesThatWereWritten) {
  const SolveReport written = report_of_all_values(), got = read(report_json(written));
  EXPECT_EQ(got.warnings, written.warnings);
  EXPECT_TRUE(std::ranges::equal(got.input.findings, written.input.findings,
                                 [](auto& a, auto& b) { return a.kind == b.kind && a.done == b.done; }));
  EXPECT_TRUE(
      std::ranges::equal(got.singularity.arc_list, written.singularity.arc_list,
                         [](auto& a, auto& b) { return a.type == b.type && a.verdict == b.verdict; }));
  EXPECT_TRUE(std::ranges::equal(got.singularity.node_list, written.singularity.node_list,
                                 [](auto& a, auto& b) { return a.verdict == b.verdict; }));
  EXPECT_EQ(got.onto->boundary, TetBoundary::kSmoothOnly);
}

TEST(NameOfAFinding, IsThatOfSchema4) {
  EXPECT_EQ(all_names<FindingKind>(),
            (std::vector<std::string>{"triangle soup", "holes", "cracks", "non-manifold edges",
                                      "degenerate triangles", "duplicated triangles", "internal sheets",
                                      "flipped facets", "inside-out parts", "one-sided sheets", "open sheets",
                                      "stray facets", "self-intersections", "overlapping components",
                                      "touching components"}));
  EXPECT_EQ(all_names<FindingOutcome>(),
            (std::vector<std::string>{"joined", "hole_bridged", "filled", "bridged", "unchanged", "left_out",
                                      "followed", "reoriented", "left_out_if_open", "all_inside", "merged",
                                      "united"}));
}

TEST_F(NamesInReports, OfOutcomesStandBesideTheirWords) {
  std::set<std::string> all_words;
  for (const auto done : all_values<FindingOutcome>()) {
    const std::string words = words_of(done);
    EXPECT_TRUE(!words.empty() && all_words.insert(words).second) << words;
    SolveReport report;
    report.input.findings.emplace_back().done = done;
    EXPECT_NE(report_json(report).find("\"done_text\": \"" + words + '"'), std::string::npos) << words;
  }
  EXPECT_STREQ(words_of(static_cast<FindingOutcome>(all_words.size())), "");
}

TEST(NameOfAnArcOrNode, IsThatOfSchema4) {
  EXPECT_EQ(all_names<SingularityGraph::ArcType>(),
            (std::vector<std::string>{"regular", "changing", "no_axis"}));
  EXPECT_EQ(all_names<Verdict>(), (std::vector<std::string>{"meshable", "not_meshable", "undecided"}));
}

TEST(NameOfATetBoundary, IsThatOfSchema4) {
  EXPECT_EQ(all_names<TetBoundary>(), (std::vector<std::string>{"all", "smooth-only"}));
}

TEST_F(NamesInReports, AreRefusedWhereTheyAreUnknown) {
  for (const auto& [key, name] : {std::pair<std::string, std::string>{"kind", "thin_walls"},
                                  {"remedy", "raise_resolution"},
                                  {"kind", "holes"},
                                  {"done", "left_out"},
                                  {"type", "changing"},
                                  {"verdict", "not_meshable"},
                                  {"boundary", "smooth-only"}}) {
    const Error error = error_with("\"" + key + "\": \"" + name + "\"", "\"" + key + "\": \"" + name + "s\"");
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_TRUE(error.file().ends_with("report.json")) << error.file();
    EXPECT_EQ(error.text(), "'" + key + "' has the unknown value '" + name + "s'");
    EXPECT_EQ(error.remedy(), Remedy::kSolveAgain);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

TEST_F(NamesInReports, AreRefusedWhereTheyAreNoText) {
  EXPECT_EQ(error_with("\"kind\": \"holes\"", "\"kind\": 1").text(), "'kind' is missing or of another type");
}

TEST_F(NamesInReports, OfAnEarlierSchemaAreNotLookedAt) {
  const std::string now = std::to_string(kReportSchema);
  EXPECT_EQ(error_with("\"schema\": " + now, "\"schema\": 3").text(),
            "has schema 3 and this program reads " + now);
}

TEST(PlacesInLists, AreRefusedWhereTheyAreInNone) {
  const TemporaryFolder folder;
  SolveReport report;
  report.hexahedra.emplace().attempts.resize(2);
  report.hexahedra->best_attempt = 1;
  const std::string text = report_json(report);
  const auto read = [&](const std::string& name, const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find('"' + name + "\": " + from), name.size() + from.size() + 4,
                    '"' + name + "\": " + to);
    return read_report(folder.write("report.json", changed));
  };
  EXPECT_EQ(read("best_attempt", "1", "0").hexahedra->best_attempt, 0u);
  for (const auto& [name, from] : {std::pair{"best_attempt", "1"}, {"best_fit", "0"}}) {
    try {
      read(name, from, "1000000");
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput);
      EXPECT_EQ(error.text().find("'" + std::string(name) + "' is 1000000 in a list of "), 0u)
          << error.text();
    }
  }
}

}  // namespace
}  // namespace crossgrain
