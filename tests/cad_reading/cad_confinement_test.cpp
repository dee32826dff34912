// SPDX-License-Identifier: Apache-2.0
// What code from a damaged CAD file could do in the process that reads it. Another program under the same
// confinement tries it.
#ifdef CROSSGRAIN_CONFINED_ACTS

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cerrno>

#include "files/temporary_folder.hpp"
#include "mesh_files/surface_files.hpp"
#include "process/helper_process.hpp"

namespace crossgrain {
namespace {

/// Acts in a folder of their own with a file to read and another.
class CadConfinement : public testing::TestWithParam<const char*> {
 protected:
  std::string answer(const std::string& how) const {
    const HelperRun run{
        CROSSGRAIN_CONFINED_ACTS, {how, GetParam(), file_.string(), other_.string()}, {}, 30, 1000};
    const HelperOutcome outcome = run_helper(run, Monitor());
    EXPECT_EQ(outcome.end, HelperOutcome::End::kExited);
    EXPECT_EQ(outcome.number, 0);
    return outcome.answer;
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.write("part.step", "a part"),
                        other_ = folder_.write("letter", "dear");
};

using WhatReadingNeeds = CadConfinement;
using WhatReadingDoesNotNeed = CadConfinement;
using OtherFiles = CadConfinement;

TEST_P(WhatReadingNeeds, IsPossible) {
  EXPECT_TRUE(answer("confined").ends_with(" done"));
}

TEST_P(WhatReadingDoesNotNeed, FailsAndLeavesTheFilesAsTheyAre) {
  const std::string confined = answer("confined");
  EXPECT_EQ(content_of(file_), "a part");
  EXPECT_EQ(content_of(other_), "dear");
  EXPECT_FALSE(std::filesystem::exists(other_.string() + ".new"));
  if (!confined.starts_with('1')) GTEST_SKIP() << "no seccomp here";
  EXPECT_EQ(confined.substr(3), fmt::to_string(EPERM));
  EXPECT_EQ(answer("free"), "done") << "the act is possible without confinement";
}

TEST_P(OtherFiles, CannotBeRead) {
  const std::string confined = answer("confined");
  if (confined[1] != '1') GTEST_SKIP() << "no Landlock here";
  EXPECT_EQ(confined.substr(3), fmt::to_string(EACCES));
  EXPECT_EQ(answer("free"), "done");
}

std::string name_of_act(const testing::TestParamInfo<const char*>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(CadConfinement, WhatReadingNeeds, testing::Values("read"), name_of_act);
INSTANTIATE_TEST_SUITE_P(CadConfinement, WhatReadingDoesNotNeed,
                         testing::Values("write", "write-other", "create", "create-empty", "remove", "rename",
                                         "chmod", "connect", "execute", "fork", "signal",
                                         "executable-memory"),
                         name_of_act);
INSTANTIATE_TEST_SUITE_P(CadConfinement, OtherFiles, testing::Values("read-other"), name_of_act);

}  // namespace
}  // namespace crossgrain

#endif
