// SPDX-License-Identifier: Apache-2.0
#include "base/system_memory.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <vector>

namespace crossgrain {
namespace {

/// A folder that looks like one where control groups are mounted.
class ControlGroups : public ::testing::Test {
 protected:
  ControlGroups()
      : root_(std::filesystem::path(::testing::TempDir()) / ("groups." + std::to_string(getpid()))) {}
  ~ControlGroups() override { std::filesystem::remove_all(root_); }

  void limit(const std::string& file, const std::string& text) const {
    const std::filesystem::path path = root_ / file;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text << '\n';
  }
  std::size_t limit_of(const std::string& membership) const {
    return control_group_limit_bytes(membership, root_);
  }

 private:
  std::filesystem::path root_;
};

TEST_F(ControlGroups, OfVersion2LimitByTheLeastOfAllAround) {
  limit("a/memory.max", "3000000000");
  limit("a/b/memory.max", "max");
  limit("a/b/c/memory.max", "5000000000");
  EXPECT_EQ(limit_of("0::/a/b/c\n"), 3000000000u);
}

TEST_F(ControlGroups, OfVersion1LimitThroughTheMemoryController) {
  limit("memory/a/memory.limit_in_bytes", "2000000000");
  limit("a/memory.max", "1");
  EXPECT_EQ(limit_of("12:cpu,cpuacct:/a\n4:memory:/a\n"), 2000000000u);
}

TEST_F(ControlGroups, ThatAContainerSeesAsItsRootLimitIt) {
  limit("memory.max", "4000000000");
  EXPECT_EQ(limit_of("0::/docker/0123\n"), 4000000000u);
}

TEST_F(ControlGroups, WithoutALimitDoNotLimit) {
  limit("a/memory.max", "max");
  EXPECT_EQ(limit_of("0::/a\n"), 0u);
  EXPECT_EQ(limit_of(""), 0u);
  EXPECT_EQ(limit_of("nonsense\n:\n"), 0u);
}

TEST(SystemMemory, LimitsTheProcessToNoMoreThanTheMachineHas) {
  EXPECT_GT(memory_limit_bytes(), 0u);
  EXPECT_LE(memory_limit_bytes(), physical_memory_bytes());
}

TEST(SystemMemory, IsAllowedAsTheOptionSaysOrElseNineTenthsOfTheLimit) {
  EXPECT_EQ(allowed_memory_bytes(12345), 12345u);
  EXPECT_NEAR(static_cast<double>(allowed_memory_bytes(0)), 0.9 * static_cast<double>(memory_limit_bytes()),
              1);
}

TEST(SystemMemory, HeldNowIsNoMoreThanAtThePeakAndGrowsWithUse) {
  constexpr std::size_t kMuch = std::size_t{64} << 20, kBatch = std::size_t{1} << 20;
  const std::size_t before = current_memory_bytes();
  const std::vector<char> used(kMuch, 1);
  EXPECT_GE(current_memory_bytes(), before + kMuch / 2);
  // The system counts pages in batches, so that what is held now may be known better than the peak.
  EXPECT_LE(current_memory_bytes(), peak_memory_bytes() + kBatch);
}

}  // namespace
}  // namespace crossgrain
