// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/page.hpp"

#include <gtest/gtest.h>

#include "crossgrain/error.hpp"
#include "crossgrain/solve.hpp"
#include "field/field_data.hpp"
#include "files/temporary_folder.hpp"
#include "results/result_files.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

FrameField solved(bool for_page) {
  SolveOptions options;
  options.resolution = 16;
  options.for_page = for_page;
  return solve(make_bracket(16), options);
}

TEST(Page, NeedsFormsThatASolveKeepsOnlyWhereItIsAskedTo) {
  EXPECT_TRUE(solved(false).data().kept_forms.cells.empty());
  EXPECT_FALSE(solved(true).data().kept_forms.cells.empty());
}

TEST(Page, IsWrittenTogetherWithTheFieldAndGoesWithTheNextOne) {
  const TemporaryFolder folder;
  const FrameField field = solved(true);
  OutputOptions options;
  options.companion = page_of(field);
  write_field(field, folder.path(), {}, options);
  const std::string page = content_of(folder.path() / kPageFile);
  EXPECT_TRUE(page.starts_with("<!"));
  EXPECT_NE(page.find("\"alignment_deg\""), std::string::npos) << "the report is in it";
  write_field(field, folder.path());
  EXPECT_FALSE(std::filesystem::exists(folder.path() / kPageFile));
}

TEST(CompanionFile, HasANameOfItsOwn) {
  const TemporaryFolder folder;
  const FrameField field = solved(false);
  const auto prepare = [](const Monitor&) -> CompanionFile::Writer {
    return [](const SolveReport&, const ByteSink& write) { write("text"); };
  };
  for (const char* name : {"", "field.vtu", "report.json", "a/b", ".."}) {
    OutputOptions options;
    options.companion = {name, prepare};
    EXPECT_THROW(write_field(field, folder.path(), {}, options), Error) << name;
  }
  OutputOptions options;
  options.companion = {"notes.txt", prepare};
  write_field(field, folder.path(), {}, options);
  EXPECT_EQ(content_of(folder.path() / "notes.txt"), "text");
}

TEST(Page, OfAFieldInMemoryStandsAlone) {
  const TemporaryFolder folder;
  const FrameField field = solved(false);
  write_page(field, folder.path() / "field.html");
  EXPECT_TRUE(is_own_file(folder.path() / "field.html"));
  EXPECT_TRUE(is_unchanged_alone(folder.path() / "field.html"));
  EXPECT_EQ(folder.names(), std::vector<std::string>{"field.html"});
  std::string expected;
  page_of(field).prepare({})(field.report(), [&](std::string_view bytes) { expected += bytes; });
  EXPECT_TRUE(content_of(folder.path() / "field.html").starts_with(expected));
}

TEST(Page, LeavesNothingWhereItIsCancelled) {
  const TemporaryFolder folder;
  Monitor monitor;
  monitor.cancel();
  EXPECT_THROW(write_page(solved(false), folder.path() / "field.html", monitor), Error);
  EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

}  // namespace
}  // namespace crossgrain
