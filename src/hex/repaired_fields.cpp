// SPDX-License-Identifier: Apache-2.0
#include "hex/repaired_fields.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "hex/field_mapping.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tet_field.hpp"

namespace crossgrain {
namespace {

double work_of(const std::vector<RepairTry>& tries) {
  double work = 0;
  for (const RepairTry& one : tries) work += static_cast<double>(one.tets.work);
  return work;
}

/// A repaired field, with a map if all its arcs have a length.
HexCandidate candidate_of(TetFrameField field, const StartingField& start, std::size_t round,
                          const HexTuning& tuning) {
  HexCandidate candidate = followed_candidate(std::move(field), start.size, round);
  if (candidate.attempt.arcs_without_length > 0) return candidate;
  return mapped_candidate(candidate, start.size, tuning);
}

}  // namespace

std::optional<Turn> RepairedFields::next(const AttemptQueue& queue) const {
  if (!queue.start() || (rounds_ == queue.rounds() && stage_ == Stage::kEnd)) return std::nullopt;
  return Turn{queue.rounds() - 1, Turn::Step::kRepair};
}

std::vector<HexCandidate> RepairedFields::make(AttemptQueue& queue) {
  const StartingField& start = *queue.start();
  double work = 0;
  Stopwatch stopwatch;
  stopwatch.start();
  if (rounds_ != queue.rounds()) {
    rounds_ = queue.rounds();
    stage_ = Stage::kEnd;
    if (start.field.data().is_repaired()) return {candidate_of(start.field, start, rounds_ - 1, tuning_)};
    begin(queue);
    work = work_of(tries_);
  }
  std::vector<const RepairTry*> tries = next_tries();
  while (tries.empty() && stage_ != Stage::kEnd) {
    begin_stage(static_cast<Stage>(static_cast<int>(stage_) + 1), work);
    tries = next_tries();
  }
  const double seconds = stopwatch.restart();
  if (tries.empty()) return {};
  queue.monitor().report(
      {Phase::kHexahedra, 0, start.field.domain().data().solid.mesh.vertices.size(), 0, NAN});
  std::vector<HexCandidate> candidates = take(std::move(tries), start);
  candidates.front().seconds.repair += seconds;
  candidates.front().attempt.work += work;
  const auto filled = std::find_if(candidates.begin(), candidates.end(),
                                   [](const HexCandidate& one) { return one.is_filled(); });
  if (filled != candidates.end()) {
    stage_ = Stage::kEnd;
    candidates.erase(filled + 1, candidates.end());
  }
  return candidates;
}

void RepairedFields::begin(AttemptQueue& queue) {
  const StartingField& start = *queue.start();
  RepairTuning tuning = tuning_.repair;
  tuning.tries.insert(tuning.tries.end(), tuning_.more_tries.begin(), tuning_.more_tries.end());
  if (tuning.most_work == 0)
    tuning.most_work = static_cast<std::size_t>(queue.most_work() * tuning_.repair_share * start.work_share);
  left_.clear();
  taken_.clear();
  repairs_of_field_.emplace(start.field, RepairOptions(), std::move(tuning), queue.monitor());
  tries_ = repairs_of_field_->tries();
  double none = 0;
  begin_stage(Stage::kSound, none);
}

/// A fault may be too small to matter: of those in which all arcs have a length the best with faults is taken
/// too. Arcs without one may get a length when vertices move.
void RepairedFields::begin_stage(Stage stage, double& work) {
  stage_ = stage;
  left_.clear();
  const auto has_lengths = [](const RepairTry& one) { return one.zero_lengths == 0; };
  if (stage == Stage::kSound) {
    for (const RepairTry& one : tries_)
      if (one.tets.faults == 0 && has_lengths(one)) left_.push_back(&one);
    const auto best = std::find_if(tries_.begin(), tries_.end(), has_lengths);
    if (best != tries_.end()) left_.push_back(&*best);
  } else if (stage == Stage::kWandered) {
    wandered_ = repairs_of_field_->wandered(tries_, tuning_.wandering_faults);
    // The work of a try goes on counting when its faults wander.
    work += std::max(0.0, work_of(wandered_) - work_of(tries_));
    for (const std::vector<RepairTry>* some : {&wandered_, &tries_})
      for (const RepairTry& one : *some)
        if (one.tets.faults == 0) left_.push_back(&one);
  } else if (stage == Stage::kAny && taken_.empty()) {
    left_.push_back(&tries_.front());
  }
}

/// The next tries of the stage whose matchings were not taken before.
std::vector<const RepairTry*> RepairedFields::next_tries() {
  constexpr std::size_t kAtOnce = 2;
  std::vector<const RepairTry*> next;
  while (!left_.empty() && next.size() < kAtOnce) {
    const RepairTry* const one = left_.front();
    left_.erase(left_.begin());
    const std::vector<CubeRotation>& matchings = one->tets.matchings;
    if (std::find(taken_.begin(), taken_.end(), matchings) != taken_.end()) continue;
    taken_.push_back(matchings);
    next.push_back(one);
  }
  return next;
}

std::vector<HexCandidate> RepairedFields::take(std::vector<const RepairTry*> tries,
                                               const StartingField& start) {
  std::vector<HexCandidate> candidates(tries.size());
  parallel_for(
      tries.size(),
      [&](std::size_t k) {
        Stopwatch stopwatch;
        stopwatch.start();
        TetFrameField field = repairs_of_field_->field_of(*tries[k]);
        const double seconds = stopwatch.restart();
        candidates[k] = candidate_of(std::move(field), start, rounds_ - 1, tuning_);
        candidates[k].seconds.repair = seconds;
      },
      /*grain=*/1);
  for (HexCandidate& candidate : candidates) candidate.attempt.repair = repairs_++;
  return candidates;
}

}  // namespace crossgrain
