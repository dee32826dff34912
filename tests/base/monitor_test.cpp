// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/monitor.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

TEST(Monitor, ChecksInSilenceUntilItIsCancelled) {
  const Monitor monitor;
  EXPECT_FALSE(monitor.cancelled());
  EXPECT_NO_THROW(monitor.check());
}

TEST(Monitor, ThrowsInterruptedOnceCancelled) {
  Monitor monitor;
  monitor.cancel();
  EXPECT_TRUE(monitor.cancelled());
  try {
    monitor.check();
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInterrupted);
  }
}

TEST(Monitor, StaysCancelled) {
  Monitor monitor;
  monitor.cancel();
  EXPECT_THROW(monitor.check(), Error);
  EXPECT_THROW(monitor.check(), Error);
}

TEST(Monitor, IsCancelledFromAnotherThread) {
  Monitor monitor;
  std::thread([&] { monitor.cancel(); }).join();
  EXPECT_THROW(monitor.check(), Error);
}

TEST(Monitor, ThatIsStoppedThrowsOnlyWhereAStopEndsTheWork) {
  Monitor monitor;
  EXPECT_NO_THROW(monitor.check_stop());
  monitor.stop();
  EXPECT_TRUE(monitor.stopped());
  EXPECT_FALSE(monitor.cancelled());
  EXPECT_THROW(monitor.check_stop(), Error);
  EXPECT_NO_THROW(monitor.check());
}

TEST(Monitor, ThatIsCancelledThrowsWhereAStopWouldToo) {
  Monitor monitor;
  monitor.cancel();
  EXPECT_THROW(monitor.check_stop(), Error);
}

TEST(Monitor, HandsReportsToItsListener) {
  std::vector<Progress> reports;
  const Monitor monitor([&](const Progress& progress) { reports.push_back(progress); });
  monitor.report({Phase::kSolve, 5, 1234, 7, 0.5});
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(reports[0].phase, Phase::kSolve);
  EXPECT_EQ(reports[0].depth, 5);
  EXPECT_EQ(reports[0].cells, 1234u);
  EXPECT_EQ(reports[0].sweep, 7);
  EXPECT_EQ(reports[0].energy, 0.5);
}

TEST(Monitor, OfAPartIsStoppedWithTheWholeButHasNothingToReturnForIt) {
  Monitor whole;
  whole.allow_stops();
  const Monitor part(whole, [](Progress&) {});
  EXPECT_FALSE(part.may_be_stopped());
  whole.stop();
  EXPECT_TRUE(part.stopped());
}

TEST(Phase, HasANameForDisplay) {
  EXPECT_STREQ(name_of(Phase::kRead), "read");
  EXPECT_STREQ(name_of(Phase::kGrid), "grid");
  EXPECT_STREQ(name_of(Phase::kSolve), "solve");
  EXPECT_STREQ(name_of(Phase::kAnalysis), "analysis");
  EXPECT_STREQ(name_of(Phase::kTets), "tets");
  EXPECT_STREQ(name_of(Phase::kWrite), "write");
  EXPECT_STREQ(name_of(Phase::kMakeTets), "make tets");
  EXPECT_STREQ(name_of(Phase::kRepair), "repair");
  EXPECT_STREQ(name_of(Phase::kMap), "map");
  EXPECT_STREQ(name_of(Phase::kHexahedra), "hexahedra");
  EXPECT_STREQ(name_of(Phase::kSmooth), "smooth");
  EXPECT_STREQ(name_of(static_cast<Phase>(11)), "");
}

TEST(Monitor, WithoutListenerTakesReportsToo) {
  EXPECT_NO_THROW(Monitor().report({Phase::kGrid, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace crossgrain
