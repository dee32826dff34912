// SPDX-License-Identifier: Apache-2.0
// Each remedy names only options that the command at hand has.
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <regex>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "messages.hpp"
#include "progress_lines.hpp"
#include "summary.hpp"

namespace crossgrain::app {
namespace {

/// The options that a text names, and the commands whose they may be: another one that it names, or this.
struct NamedOption {
  std::string name, command;
};

std::vector<NamedOption> options_in(const std::string& text, const std::string& command) {
  std::vector<NamedOption> found;
  static const std::regex kOption("('crossgrain ([a-z]+) )?(--?[a-z][a-z-]*)");
  for (std::sregex_iterator at(text.begin(), text.end(), kOption), end; at != end; ++at) {
    if (at->position(3) > 0 && text[static_cast<std::size_t>(at->position(3)) - 1] != ' ') continue;
    found.push_back({at->str(3), at->length(2) > 0 ? at->str(2) : command});
  }
  return found;
}

bool has_option(CLI::App& app, const std::string& command, const std::string& option) {
  return app.get_subcommand(command)->get_option_no_throw(option) != nullptr;
}

TEST(WordsOfARemedy, NameOptionsThatTheCommandHas) {
  CommandLine line;
  CommandLineOfProcesses processes;
  for (int k = 0; k <= static_cast<int>(Remedy::kReportModel); ++k) {
    const auto remedy = static_cast<Remedy>(k);
    for (const auto& [command, name] :
         {std::pair(Command::kSolve, "solve"), {Command::kHex, "hex"}, {Command::kTets, "tets"}})
      for (const auto& [option, of] : options_in(words_of(remedy, 6, command), name))
        EXPECT_TRUE(has_option(line.app, of, option)) << words_of(remedy, 6, command) << " in " << name;
    for (const auto& [option, of] : options_in(words_of(remedy, 6, Command::kProcesses), "solve"))
      EXPECT_TRUE(has_option(of == "solve" ? processes.app : line.app, of, option)) << words_of(remedy);
  }
}

TEST(WordsOfARemedy, OfOtherCommandsNameOptionsOfOneOfThem) {
  CommandLine line;
  for (int k = 0; k <= static_cast<int>(Remedy::kReportModel); ++k)
    for (const auto& [option, of] : options_in(words_of(static_cast<Remedy>(k), 6, Command::kOther), "")) {
      bool found = false;
      for (const char* command : {"solve", "render", "streamlines", "sample", "view"})
        found |= has_option(line.app, command, option);
      EXPECT_TRUE(found) << option;
    }
}

TEST(WarningsOfSolids, TellBeforeTheWorkHowHexahedraEnd) {
  const Warning touching(WarningKind::kTouchingSolids, "solids 1 and 2 touch", Remedy::kGlueSolids);
  SolveArguments arguments;
  arguments.model = "part.step";
  EXPECT_EQ(line_of(touching, arguments), "solids 1 and 2 touch; glue them with --glue");
  arguments.hexahedra.emplace();
  EXPECT_EQ(line_of(touching, arguments),
            "solids 1 and 2 touch; glue them with --glue; else the mesh is partial (exit code 6)");
  EXPECT_EQ(line_of(Warning(WarningKind::kTouchingSolids, "they meet in a point"), arguments),
            "they meet in a point");
}

TEST(WhatToExpect, GivesTheReasonForTetsOfAnotherSize) {
  HexExpectation expected{12561, 3.05, 97.2, {17.1, 0, 0}};
  const std::string begin = "about 97 hexahedra of 3.05, along a field on 12561 tets of 17.1 (--tet-size)";
  EXPECT_EQ(sentence_of(expected), begin);
  expected.tet_size = {17.1, 4.27, 53717};
  EXPECT_EQ(sentence_of(expected), begin + ", since 4.27 makes 53717");
  expected.tet_size.dropped_tets = 12561;
  EXPECT_EQ(sentence_of(expected), begin + ", as many as of 4.27: the model's surface sets their number");
}

TEST(LinesOfAttempts, DoNotRepeatAFaultThatIsAtAnotherPlace) {
  testing::internal::CaptureStderr();
  {
    ProgressLines lines(ProgressForm::kLines, false);
    HexAttemptEnd end;
    const std::string fault = "hexahedra would be flat";
    for (const char* place : {" at 1 2 3", " at -1 2 3", " at -1 2 3"}) {
      ++end.attempt;
      end.fault = fault;
      end.text = fault + place;
      lines.end_attempt(end);
    }
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "attempt 1: no mesh: hexahedra would be flat at 1 2 3\nattempt 2: the same at -1 2 3\n"
            "attempt 3: ends as attempt 2 did\n");
}

TEST(WordsOfARemedy, HaveItsNumber) {
  EXPECT_EQ(words_of(Remedy::kUseEdgeLength, 5.9, Command::kHex), "try --tet-size 5.9");
  EXPECT_EQ(words_of(Remedy::kUseEdgeLength, 120, Command::kHex), "try --tet-size 120");
  EXPECT_EQ(words_of(Remedy::kUseResolution, 162, Command::kSolve), "use --resolution 162");
}

}  // namespace
}  // namespace crossgrain::app
