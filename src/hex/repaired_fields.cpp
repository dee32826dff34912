// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <utility>

#include "base/parallel.hpp"
#include "base/required_memory.hpp"
#include "base/stopwatch.hpp"
#include "hex/attempt_kinds.hpp"
#include "hex/candidate_fitting.hpp"
#include "hex/field_mapping.hpp"
#include "hex/hex_memory.hpp"
#include "solve/field_repairs.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tet_field.hpp"

namespace crossgrain {
namespace {

/// The share of the work of all attempts that each try of a repair may take for random changes.
constexpr double kRepairShare = 0.04;

/// Faults wander (RepairTuning::wanderings) in tries with no more than so many, if none has a map.
constexpr std::size_t kWanderingFaults = 6;

double work_of(const std::vector<RepairTry>& tries) {
  double work = 0;
  for (const RepairTry& one : tries) work += static_cast<double>(one.tets.work);
  return work;
}

class RepairedFields : public AttemptKind {
 public:
  explicit RepairedFields(const HexTuning& tuning) : tuning_(tuning) {}

  const char* name() const override { return "repair"; }

  std::optional<Turn> next(const AttemptQueue& queue) const override {
    if (!queue.start() || !may_have_more(queue)) return std::nullopt;
    return Turn{queue.rounds() - 1, Turn::Step::kRepair};
  }

  std::string plan(const AttemptQueue&) const override { return "other singular lines"; }

  /// Whether a later stage has tries is known once it is begun.
  bool prepare(AttemptQueue& queue) override {
    if (rounds_ != queue.rounds()) return true;
    Stopwatch stopwatch;
    work_ = 0;
    find_next();
    seconds_ = stopwatch.restart();
    return !next_.empty();
  }

  std::vector<HexCandidate> make(AttemptQueue& queue) override {
    const StartingField& start = *queue.start();
    Stopwatch stopwatch;
    if (rounds_ != queue.rounds()) {
      rounds_ = queue.rounds();
      end();
      if (start.field.data().is_repaired()) return {candidate_of(start.field, start)};
      begin(queue);
      find_next();
      seconds_ = stopwatch.restart();
    }
    const std::vector<const RepairTry*> tries = std::exchange(next_, {});
    const double seconds = seconds_;
    if (tries.empty()) return {};
    std::vector<HexCandidate> candidates = take(tries, queue);
    candidates.front().seconds.repair += seconds;
    candidates.front().attempt.work += work_;
    const auto filled = std::find_if(candidates.begin(), candidates.end(),
                                     [](const HexCandidate& one) { return one.is_filled(); });
    if (filled != candidates.end()) {
      end();
      candidates.erase(filled + 1, candidates.end());
      fit_if_complete(candidates.back());
    }
    return candidates;
  }

 private:
  /// Which tries are taken. Each stage follows when the one before has none left.
  enum class Stage { kSound, kWandered, kAny, kEnd };

  void end() {
    stage_ = Stage::kEnd;
    left_.clear();
  }

  /// Whether the round may have another attempt.
  bool may_have_more(const AttemptQueue& queue) const {
    if (rounds_ != queue.rounds()) return true;
    return has_later_stage() ||
           std::any_of(left_.begin(), left_.end(), [&](const RepairTry* one) { return !is_taken(*one); });
  }

  bool is_taken(const RepairTry& one) const {
    return std::find(taken_.begin(), taken_.end(), one.tets.matchings) != taken_.end();
  }

  /// Whether a stage after this one may have tries.
  bool has_later_stage() const {
    if (stage_ != Stage::kSound) return stage_ == Stage::kWandered && taken_.empty();
    return taken_.empty() || std::any_of(tries_.begin(), tries_.end(), [&](const RepairTry& one) {
             return one.tets.faults == 0 ? !is_taken(one) : one.tets.faults <= kWanderingFaults;
           });
  }

  void begin(AttemptQueue& queue) {
    const StartingField& start = *queue.start();
    RepairTuning tuning = tuning_.repair;
    tuning.tries.insert(tuning.tries.end(), tuning_.more_tries.begin(), tuning_.more_tries.end());
    tuning.most_work = static_cast<std::size_t>(queue.most_work() * kRepairShare * start.work_share);
    left_.clear();
    taken_.clear();
    repairs_of_field_.emplace(start.field, RepairOptions(), std::move(tuning), queue.monitor());
    tries_ = repairs_of_field_->tries();
    work_ = work_of(tries_);
    begin_stage(Stage::kSound);
  }

  /// A fault may be too small to matter: of those in which all arcs have a length the best with faults is
  /// taken too. Arcs without one may get a length when vertices move.
  void begin_stage(Stage stage) {
    stage_ = stage;
    left_.clear();
    const auto has_lengths = [](const RepairTry& one) { return one.zero_lengths == 0; };
    if (stage == Stage::kSound) {
      for (const RepairTry& one : tries_)
        if (one.tets.faults == 0 && has_lengths(one)) left_.push_back(&one);
      const auto best = std::find_if(tries_.begin(), tries_.end(), has_lengths);
      if (best != tries_.end()) left_.push_back(&*best);
    } else if (stage == Stage::kWandered) {
      wandered_ = repairs_of_field_->wandered(tries_, kWanderingFaults);
      // The work of a try goes on counting when its faults wander.
      work_ += std::max(0.0, work_of(wandered_) - work_of(tries_));
      for (const std::vector<RepairTry>* some : {&wandered_, &tries_})
        for (const RepairTry& one : *some)
          if (one.tets.faults == 0) left_.push_back(&one);
    } else if (stage == Stage::kAny && taken_.empty()) {
      left_.push_back(&tries_.front());
    }
  }

  /// The next tries of this stage or a later one.
  void find_next() {
    next_ = next_tries();
    while (next_.empty() && stage_ != Stage::kEnd) {
      begin_stage(static_cast<Stage>(static_cast<int>(stage_) + 1));
      next_ = next_tries();
    }
  }

  /// The next tries of the stage whose matchings were not taken before.
  std::vector<const RepairTry*> next_tries() {
    constexpr std::size_t kAtOnce = 2;
    std::vector<const RepairTry*> next;
    while (!left_.empty() && next.size() < kAtOnce) {
      const RepairTry* const one = left_.front();
      left_.erase(left_.begin());
      if (is_taken(*one)) continue;
      taken_.push_back(one->tets.matchings);
      next.push_back(one);
    }
    return next;
  }

  /// One after the other where memory is too little for all at the same time.
  std::vector<HexCandidate> take(const std::vector<const RepairTry*>& tries, const AttemptQueue& queue) {
    const StartingField& start = *queue.start();
    std::vector<HexCandidate> candidates(tries.size());
    const auto take_one = [&](std::size_t k) {
      Stopwatch stopwatch;
      tell_watched(Phase::kRepair, kUnknownShare);
      TetFrameField field = repairs_of_field_->field_of(*tries[k]);
      const double seconds = stopwatch.restart();
      candidates[k] = candidate_of(std::move(field), start);
      candidates[k].seconds.repair = seconds;
    };
    const auto tets = static_cast<double>(start.field.domain().mesh().tets.size());
    const double bytes = kBytesOfMappedTet * tets + kBytesOfHexahedron * queue.expected_hexahedra();
    if (has_memory_for(static_cast<double>(tries.size()) * bytes)) {
      parallel_for(tries.size(), take_one, /*grain=*/1);
    } else {
      for (std::size_t k = 0; k < tries.size(); ++k) take_one(k);
    }
    for (HexCandidate& candidate : candidates) candidate.attempt.repair = repairs_++;
    return candidates;
  }

  /// A repaired field, with a map if all its arcs have a length.
  HexCandidate candidate_of(TetFrameField field, const StartingField& start) const {
    HexCandidate followed = followed_candidate(std::move(field), start.size, rounds_ - 1);
    if (followed.attempt.arcs_without_length > 0) return followed;
    HexCandidate mapped = mapped_candidate(followed, start.size, tuning_);
    mapped.attempt.work += followed.attempt.work;
    mapped.seconds.map += followed.seconds.map;
    return mapped;
  }

  const HexTuning& tuning_;
  std::size_t rounds_ = 0;  ///< that were begun
  std::size_t repairs_ = 0;
  Stage stage_ = Stage::kEnd;
  double work_ = 0, seconds_ = 0;  ///< of the repairs for the next attempts
  std::optional<FieldRepairs> repairs_of_field_;
  std::vector<RepairTry> tries_, wandered_;
  std::vector<const RepairTry*> left_;  ///< of the stage
  std::vector<const RepairTry*> next_;
  std::vector<std::vector<CubeRotation>> taken_;
};

}  // namespace

std::unique_ptr<AttemptKind> repaired_fields(const HexTuning& tuning) {
  return std::make_unique<RepairedFields>(tuning);
}

}  // namespace crossgrain
