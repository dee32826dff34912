// SPDX-License-Identifier: Apache-2.0
#include "hex/attempt_queue.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "crossgrain/error.hpp"
#include "hex/attempt_kinds.hpp"
#include "hex/lattice_search.hpp"

namespace crossgrain {
namespace {

/// A candidate of one hexahedron that fills the model, or misses a share of its volume.
HexCandidate candidate_that_misses(double share) {
  HexCandidate candidate;
  candidate.made.emplace();
  candidate.made->mesh.hexahedra = {{0, 1, 2, 3, 4, 5, 6, 7}};
  candidate.made->fills = share == 0;
  candidate.made->quality.least = 1;
  candidate.made->volume_missed = share;
  candidate.made->left_out = static_cast<std::size_t>(100 * share);
  candidate.attempt.work = 10;
  return candidate;
}

/// A kind whose attempts give candidates of a list, each due at its turn; an empty one fails.
class Dummy : public AttemptKind {
 public:
  struct Planned {
    Turn turn;
    std::vector<double> shares;
  };

  Dummy(std::string name, std::vector<Planned> planned)
      : name_(std::move(name)), planned_(std::move(planned)) {}

  const char* name() const override { return name_.c_str(); }
  std::string plan(const AttemptQueue&) const override { return name_ + " " + std::to_string(at_ + 1); }

  std::size_t round(const AttemptQueue&) const override { return planned_[at_].turn.round; }

  /// All rounds that it plans.
  std::size_t rounds_left(const AttemptQueue&) const override {
    return planned_.empty() ? 0 : planned_.back().turn.round + 1;
  }

  std::optional<Turn> next(const AttemptQueue&) const override {
    if (at_ == planned_.size()) return std::nullopt;
    return planned_[at_].turn;
  }

  std::vector<HexCandidate> make(AttemptQueue&) override {
    const std::size_t round = planned_[at_].turn.round;
    const std::vector<double>& shares = planned_[at_++].shares;
    if (shares.empty()) throw Error(ErrorKind::kLimit, "no memory for this one");
    std::vector<HexCandidate> candidates;
    for (const double share : shares) {
      candidates.push_back(candidate_that_misses(share));
      candidates.back().attempt.round = round;
    }
    return candidates;
  }

 private:
  std::string name_;
  std::vector<Planned> planned_;
  std::size_t at_ = 0;
};

using Step = Turn::Step;

/// A kind whose only attempt is ended by a signal.
class Signalled : public AttemptKind {
 public:
  Signalled(std::size_t round, std::function<void()> signal) : round_(round), signal_(std::move(signal)) {}

  const char* name() const override { return "signalled"; }
  std::string plan(const AttemptQueue&) const override { return "to be stopped"; }
  std::optional<Turn> next(const AttemptQueue&) const override {
    if (is_over_) return std::nullopt;
    return Turn{round_, Step::kRepair};
  }

  std::vector<HexCandidate> make(AttemptQueue& queue) override {
    is_over_ = true;
    signal_();
    queue.monitor().check_stop();
    return {};
  }

 private:
  std::size_t round_;
  std::function<void()> signal_;
  bool is_over_ = false;
};

std::unique_ptr<Dummy> dummy(std::vector<Dummy::Planned> planned) {
  return std::make_unique<Dummy>("a", std::move(planned));
}

/// A lattice, once there is anything else.
class LatticeDummy : public AttemptKind {
 public:
  explicit LatticeDummy(bool is_faithful) : is_faithful_(is_faithful) {}

  const char* name() const override { return kLatticeKind; }
  std::string plan(const AttemptQueue&) const override { return "a lattice"; }
  bool follows_field() const override { return false; }
  std::optional<Turn> next(const AttemptQueue& queue) const override {
    return is_over_ || !queue.best() ? std::nullopt : std::optional(Turn{});
  }

  std::vector<HexCandidate> make(AttemptQueue& queue) override {
    is_over_ = true;
    queue.monitor().report({Phase::kSmooth, 0, 0, 0, 0});
    HexCandidate candidate = candidate_that_misses(0);
    candidate.made->is_faithful = is_faithful_;
    candidate.lattice = std::make_shared<LatticeHexahedra>();
    return {candidate};
  }

 private:
  bool is_faithful_;
  bool is_over_ = false;
};

constexpr double kPlenty = 1e9;

std::vector<std::string> kinds_of(const AttemptQueue& queue) {
  std::vector<std::string> kinds;
  for (const HexAttempt& attempt : queue.attempts()) kinds.push_back(attempt.kind);
  return kinds;
}

TEST(AttemptQueue, TakesAFurtherKindByOneLine) {
  const Monitor monitor;
  AttemptQueue queue(kPlenty, 0, monitor);
  queue.add(std::make_unique<Dummy>("lattice", std::vector<Dummy::Planned>{{{0, Step::kTets}, {0}}}));
  queue.run();
  ASSERT_NE(queue.best(), nullptr);
  EXPECT_TRUE(queue.best()->is_filled());
  EXPECT_EQ(queue.attempts().front().kind, "lattice");
  EXPECT_EQ(queue.attempts().front().outcome, HexOutcome::kAllHex);
}

/// Maps of which only the last but one fills the model, and a lattice.
struct BesideALattice {
  std::vector<Progress> heard;
  std::vector<HexAttemptEnd> ends;
  const Monitor monitor{[this](const Progress& progress) { heard.push_back(progress); }};
  AttemptQueue queue{kPlenty, 0.05, monitor};

  explicit BesideALattice(bool is_faithful) {
    queue.hear_ends([this](const HexAttemptEnd& end) { ends.push_back(end); });
    queue.limit_maps_beside_lattice(/*work=*/40, /*if_good=*/20);
    const auto fails = [](std::size_t round) { return Dummy::Planned{{round, Step::kTets}, {0.5}}; };
    queue.add(dummy({fails(1), fails(1), fails(1), {{1, Step::kTets}, {0}}, fails(1)}));
    queue.add(std::make_unique<LatticeDummy>(is_faithful));
    queue.run();
  }
};

TEST(AttemptQueue, TriesMapsForLessWorkBesideALatticeThatKeepsAll) {
  const BesideALattice good(true);
  EXPECT_EQ(kinds_of(good.queue), (std::vector<std::string>{"a", kLatticeKind, "a"}));
  EXPECT_TRUE(good.queue.best()->lattice);
}

TEST(AttemptQueue, TakesAGoodMapInPlaceOfALattice) {
  const BesideALattice poor(false);
  EXPECT_EQ(kinds_of(poor.queue), (std::vector<std::string>{"a", kLatticeKind, "a", "a", "a"}));
  EXPECT_FALSE(poor.queue.best()->lattice);
  EXPECT_EQ(poor.queue.best_attempt(), 4u);
}

TEST(AttemptQueue, TellsNoTetsOfALattice) {
  const BesideALattice good(true);
  ASSERT_EQ(good.heard.size(), 1U);
  EXPECT_EQ(good.heard[0].attempt, 2U);
  EXPECT_EQ(good.heard[0].most_tets, 0U);
  ASSERT_EQ(good.ends.size(), 3U);
  EXPECT_EQ(good.ends[0].next, "a lattice");
  EXPECT_GT(good.ends[0].most_tets, 0U);
  EXPECT_EQ(good.ends[1].most_tets, 0U);
}

TEST(AttemptQueue, MakesWhatIsDueFirstWhicheverKindItIs) {
  const Monitor monitor;
  AttemptQueue queue(kPlenty, 0, monitor);
  queue.add(std::make_unique<Dummy>(
      "a", std::vector<Dummy::Planned>{{{0, Step::kRepair}, {0.5}}, {{2, Step::kTets}, {0.5}}}));
  queue.add(std::make_unique<Dummy>(
      "b", std::vector<Dummy::Planned>{{{0, Step::kTets}, {0.5}}, {{0, Step::kRepair}, {0.5}}}));
  queue.run();
  // Of two that are due at the same time, the kind that was added first.
  EXPECT_EQ(kinds_of(queue), (std::vector<std::string>{"b", "a", "b", "a"}));
}

TEST(AttemptQueue, EndsWithTheFirstGoodCandidate) {
  const Monitor monitor;
  AttemptQueue queue(kPlenty, 0, monitor);
  queue.add(std::make_unique<Dummy>(
      "a", std::vector<Dummy::Planned>{
               {{0, Step::kRepair}, {0.5}}, {{0, Step::kRepair}, {0}}, {{0, Step::kRepair}, {0}}}));
  queue.run();
  EXPECT_EQ(queue.attempts().size(), 2u);
  EXPECT_EQ(queue.best_attempt(), 1u);
}

TEST(AttemptQueue, KeepsTheCandidateOfARoundThatLeavesOutTheFewest) {
  const Monitor monitor;
  AttemptQueue queue(kPlenty, 0, monitor);
  queue.add(std::make_unique<Dummy>("a", std::vector<Dummy::Planned>{{{0, Step::kRepair}, {0.5, 0.2, 0.3}}}));
  queue.run();
  EXPECT_EQ(queue.best()->made->left_out, 20u);
  EXPECT_EQ(queue.best_attempt(), 1u);
  EXPECT_EQ(queue.attempts().size(), 3u);
}

TEST(AttemptQueue, TakesAGoodMeshAfterAPoorOneOfTheSameRound) {
  HexCandidate poor = candidate_that_misses(0), good = poor;
  poor.made->quality.least = 0.01;
  EXPECT_TRUE(is_better_in_round(good, poor, 0.05));
  EXPECT_FALSE(is_better_in_round(poor, good, 0.05));
}

TEST(AttemptQueue, KeepsTheRoundThatMissesTheLeastVolume) {
  const Monitor monitor;
  AttemptQueue queue(kPlenty, 0, monitor);
  queue.add(std::make_unique<Dummy>(
      "a", std::vector<Dummy::Planned>{
               {{0, Step::kRepair}, {0.5}}, {{1, Step::kRepair}, {0.2}}, {{2, Step::kRepair}, {0.3}}}));
  queue.run();
  EXPECT_EQ(queue.best()->made->volume_missed, 0.2);
  EXPECT_EQ(queue.best()->attempt.round, 1u);
}

TEST(AttemptQueue, EndsOnceItsWorkIsDone) {
  const Monitor monitor;
  AttemptQueue queue(/*most_work=*/20, 0, monitor);
  queue.add(std::make_unique<Dummy>(
      "a", std::vector<Dummy::Planned>(5, Dummy::Planned{{0, Step::kRepair}, {0.5}})));
  queue.run();
  EXPECT_EQ(queue.attempts().size(), 2u);
}

TEST(AttemptQueue, ReportsAFailureAndGoesOn) {
  const Monitor monitor;
  AttemptQueue queue(kPlenty, 0, monitor);
  queue.add(std::make_unique<Dummy>(
      "a", std::vector<Dummy::Planned>{
               {{0, Step::kRepair}, {0.5}}, {{0, Step::kRepair}, {}}, {{0, Step::kRepair}, {0}}}));
  queue.run();
  EXPECT_EQ(queue.attempts()[1].failure, "no memory for this one");
  ASSERT_TRUE(queue.limit());
  EXPECT_EQ(queue.limit()->text(), "no memory for this one");
  EXPECT_TRUE(queue.best()->is_filled());
}

TEST(AttemptQueue, ThrowsAFailureBeforeThereIsAMesh) {
  const Monitor monitor;
  AttemptQueue queue(kPlenty, 0, monitor);
  queue.add(std::make_unique<Dummy>("a", std::vector<Dummy::Planned>{{{0, Step::kRepair}, {}}}));
  EXPECT_THROW(queue.run(), Error);
}

TEST(AttemptQueue, EndsWhenTheMonitorIsStopped) {
  Monitor monitor;
  AttemptQueue queue(kPlenty, 0, monitor);
  queue.add(std::make_unique<Dummy>("a", std::vector<Dummy::Planned>{{{0, Step::kRepair}, {0}}}));
  monitor.stop();
  EXPECT_THROW(queue.run(), Error);
  EXPECT_TRUE(queue.attempts().empty());
}

TEST(AttemptQueue, EndsWithTheBestMeshWhenItIsStoppedWhereThatIsAllowed) {
  Monitor monitor;
  monitor.allow_stops();
  AttemptQueue queue(kPlenty, 0, monitor);
  queue.add(dummy({{{0, Step::kRepair}, {0.5}}, {{2, Step::kRepair}, {0}}}));
  queue.add(std::make_unique<Signalled>(1, [&] { monitor.stop(); }));
  queue.run();
  EXPECT_TRUE(queue.is_stopped());
  EXPECT_EQ(queue.best()->made->volume_missed, 0.5);
  EXPECT_EQ(kinds_of(queue), (std::vector<std::string>{"a", "signalled"}));
}

TEST(AttemptQueue, ThrowsWhenItIsStoppedBeforeThereIsAMesh) {
  Monitor monitor;
  monitor.allow_stops();
  AttemptQueue queue(kPlenty, 0, monitor);
  queue.add(std::make_unique<Signalled>(0, [&] { monitor.stop(); }));
  EXPECT_THROW(queue.run(), Error);
}

TEST(AttemptQueue, ThrowsWhenItIsCancelledThoughThereIsAMesh) {
  Monitor monitor;
  monitor.allow_stops();
  AttemptQueue queue(kPlenty, 0, monitor);
  queue.add(dummy({{{0, Step::kRepair}, {0.5}}}));
  queue.add(std::make_unique<Signalled>(1, [&] {
    monitor.stop();
    monitor.cancel();
  }));
  EXPECT_THROW(queue.run(), Error);
}

TEST(AttemptQueue, TellsHowEachAttemptEndedAndWhatIsTriedNext) {
  std::vector<HexAttemptEnd> ends;
  const Monitor monitor;
  AttemptQueue queue(kPlenty, 0, monitor);
  queue.add(dummy({{{0, Step::kRepair}, {0.5}}, {{0, Step::kRepair}, {}}, {{0, Step::kRepair}, {0}}}));
  queue.hear_ends([&](const HexAttemptEnd& end) { ends.push_back(end); });
  queue.run();
  ASSERT_EQ(ends.size(), 3u);
  EXPECT_EQ(ends[0].text, "no mesh");
  EXPECT_EQ(ends[0].fault, "") << "nothing is known of it";
  EXPECT_EQ(ends[0].next, "a 2");
  EXPECT_EQ(ends[1].text, "no memory for this one");
  EXPECT_EQ(ends[1].next, "a 3");
  EXPECT_EQ(ends[2].text, "1 hexahedron fills the model");
  EXPECT_EQ(ends[2].next + ends[2].over, "");
  EXPECT_EQ(ends[2].attempt, 3u);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(queue.attempts()[k].number, k + 1);
}

/// A kind whose only attempt turns out to be none.
class Unready : public Signalled {
 public:
  explicit Unready(std::size_t round) : Signalled(round, [] {}) {}
  bool prepare(AttemptQueue& queue) override { return !make(queue).empty(); }
};

TEST(AttemptQueue, AnnouncesNothingThatIsNeverMade) {
  std::vector<HexAttemptEnd> ends;
  const Monitor monitor;
  AttemptQueue queue(kPlenty, 0, monitor);
  queue.add(dummy({{{0, Step::kRepair}, {0.5}}, {{2, Step::kRepair}, {0.5}}}));
  queue.add(std::make_unique<Unready>(1));
  queue.add(std::make_unique<Unready>(3));
  queue.hear_ends([&](const HexAttemptEnd& end) { ends.push_back(end); });
  queue.run();
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[0].next, "a 2");
  EXPECT_EQ(ends[1].next, "");
  EXPECT_EQ(ends[1].over, "nothing else is left to try");
}

TEST(AttemptQueue, TellsWhatIsTriedAtTheSameTime) {
  std::vector<HexAttemptEnd> ends;
  const Monitor monitor;
  AttemptQueue queue(kPlenty, 0, monitor);
  queue.add(dummy({{{0, Step::kRepair}, {0.5, 0.4}}}));
  queue.hear_ends([&](const HexAttemptEnd& end) { ends.push_back(end); });
  queue.run();
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[0].next, "a 1");
}

/// How the last attempt of a search ends that has a mesh which misses half of the volume.
HexAttemptEnd last_end(double most_work, bool is_stopped = false) {
  HexAttemptEnd last;
  Monitor monitor;
  monitor.allow_stops();
  AttemptQueue queue(most_work, 0, monitor);
  queue.add(dummy({{{0, Step::kRepair}, {0.5}}, {{0, Step::kRepair}, {0.5}}}));
  if (is_stopped) queue.add(std::make_unique<Signalled>(1, [&] { monitor.stop(); }));
  queue.hear_ends([&](const HexAttemptEnd& end) { last = end; });
  queue.run();
  return last;
}

TEST(AttemptQueue, TellsWhyNothingFollowsUnlessTheMeshIsGood) {
  EXPECT_EQ(last_end(kPlenty).over, "nothing else is left to try");
  EXPECT_EQ(last_end(kPlenty, /*is_stopped=*/true).over, "the search was stopped");
  const HexAttemptEnd exhausted = last_end(/*most_work=*/5);
  EXPECT_EQ(exhausted.attempt, 1u);
  EXPECT_EQ(exhausted.over, "the work of a search is done");
  EXPECT_EQ(exhausted.next, "");
}

TEST(AttemptQueue, CallsAMeshThatFillsTheModelPartialIfAHexahedronIsInverted) {
  HexCandidate inverted = candidate_that_misses(0), partial = candidate_that_misses(0.01);
  inverted.made->quality.inverted = 1;
  EXPECT_EQ(inverted.made->outcome(), HexOutcome::kPartial);
  EXPECT_EQ(partial.made->outcome(), HexOutcome::kPartial);
  inverted.made->volume_missed = 0.02;
  EXPECT_TRUE(is_better(inverted, partial, 0));
  partial.made->mesh.hexahedra.clear();
  EXPECT_EQ(partial.made->outcome(), HexOutcome::kNone);
}

TEST(AttemptQueue, TellsAttemptAndBestSoFarInItsProgress) {
  std::vector<Progress> heard;
  const Monitor monitor([&](const Progress& progress) { heard.push_back(progress); });
  AttemptQueue queue(kPlenty, 0, monitor);
  queue.add(dummy({{{0, Step::kRepair}, {0.5}}, {{1, Step::kRepair}, {0.5}}}));
  queue.monitor().report({Phase::kRepair, 0, 5, 0, 0});
  queue.run();
  queue.monitor().report({Phase::kHexahedra, 0, 5, 0, 0});
  ASSERT_EQ(heard.size(), 2u);
  EXPECT_EQ(heard[0].attempt, 1u);
  EXPECT_EQ(heard[0].tets, 1u);
  EXPECT_EQ(heard[1].most_tets, 2u);
  EXPECT_EQ(heard[0].hexahedra, 0u);
  EXPECT_EQ(heard[1].attempt, 3u);
  EXPECT_EQ(heard[1].tets, 2u);
  EXPECT_EQ(heard[1].hexahedra, 1u);
  EXPECT_EQ(heard[1].outcome, HexOutcome::kPartial);
}

}  // namespace
}  // namespace crossgrain
