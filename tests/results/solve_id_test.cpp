// SPDX-License-Identifier: Apache-2.0
#include "results/solve_id.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "crossgrain/error.hpp"
#include "crossgrain/thread_limit.hpp"
#include "files/folder_completion.hpp"
#include "files/temporary_folder.hpp"
#include "results/one_solve.hpp"
#include "results/report_file.hpp"
#include "results/sample_field.hpp"

namespace crossgrain {
namespace {

namespace fs = std::filesystem;

TEST(SolveId, IsTheSameForTheSameFieldWithAnyNumberOfThreads) {
  const FieldData data = sample_data(Degree::kFour);
  const std::string solve = solve_id(data, {});
  EXPECT_TRUE(is_solve_id(solve)) << solve;
  const ThreadLimit one(1);
  EXPECT_EQ(solve_id(sample_data(Degree::kFour), {}), solve);
}

TEST(SolveId, ChangesWithEveryFrameAndOption) {
  const std::string solve = solve_id(sample_data(Degree::kFour), {});
  FieldData data = sample_data(Degree::kFour);
  data.frames.back().w = -data.frames.back().w;
  EXPECT_NE(solve_id(data, {}), solve);
  EXPECT_NE(solve_id(sample_data(Degree::kThree), {}), solve);
  OutputOptions options;
  options.level = 3;
  EXPECT_NE(solve_id(sample_data(Degree::kFour), options), solve);
}

TEST(SolveOfResult, IsNamedByAllFilesAndByTheReport) {
  const TemporaryFolder folder;
  const SolveReport report = write_field(field_of(sample_data(Degree::kFour)), folder.path());
  EXPECT_TRUE(is_solve_id(report.solve));
  EXPECT_EQ(solve_of_result(folder.path()), report.solve);
  EXPECT_EQ(read_field(folder.path()).report().solve, report.solve);
}

TEST(SolveOfResult, IsNoneOfAMixedFolderWhichNamesTwoFiles) {
  const TemporaryFolder folder, other;
  write_field(field_of(sample_data(Degree::kFour)), folder.path());
  write_field(field_of(sample_data(Degree::kThree)), other.path());
  fs::copy_file(other.path() / "field.vtu", folder.path() / "field.vtu",
                fs::copy_options::overwrite_existing);
  try {
    read_field(folder.path());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    for (const char* name : {"field.vtu", "report.json"})
      EXPECT_NE(std::string(error.what()).find((folder.path() / name).string()), std::string::npos);
  }
}

TEST(SolveOfResult, IsThatOfTheNewFilesWhereTheirRenamesWereInterrupted) {
  const TemporaryFolder folder, other;
  write_field(field_of(sample_data(Degree::kFour)), folder.path());
  const std::string solve = write_field(field_of(sample_data(Degree::kThree)), other.path()).solve;
  fs::create_directory(folder.path() / kCompleteFiles);
  for (const char* name : {"field.vtu", "report.json", "singularities.vtu"})
    fs::copy_file(other.path() / name, folder.path() / kCompleteFiles / name);
  EXPECT_EQ(read_field(folder.path()).report().solve, solve);
  EXPECT_FALSE(fs::exists(folder.path() / kCompleteFiles));
}

TEST(ReadOneSolve, ReadsAgainWhereTheResultIsReplacedMeanwhile) {
  const TemporaryFolder folder;
  write_field(field_of(sample_data(Degree::kFour)), folder.path());
  int times = 0;
  const auto read = [&] {
    if (++times == 1) {
      write_field(field_of(sample_data(Degree::kThree)), folder.path());
      throw Error(ErrorKind::kInput, "a file went");
    }
    return times;
  };
  EXPECT_EQ(read_one_solve(folder.path(), read), 2);
}

TEST(SolveOfResult, InAReportFromElsewhereMustBeOne) {
  const TemporaryFolder folder;
  const std::string solve = write_field(field_of(sample_data(Degree::kFour)), folder.path()).solve;
  std::string report = content_of(folder.path() / "report.json");
  report.replace(report.find(solve), solve.size(), "--><script>12345");
  folder.write("report.json", report);
  EXPECT_THROW(read_report(folder.path() / "report.json"), Error);
}

}  // namespace
}  // namespace crossgrain
