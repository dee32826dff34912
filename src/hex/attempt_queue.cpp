// SPDX-License-Identifier: Apache-2.0
#include "hex/attempt_queue.hpp"

#include <utility>

#include "base/stopwatch.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain {

AttemptQueue::AttemptQueue(double most_work, double least_quality, const Monitor& monitor)
    : most_work_(most_work),
      least_quality_(least_quality),
      monitor_(monitor, [this](Progress& progress) { tell_more(progress); }) {}

void AttemptQueue::tell_more(Progress& progress) const {
  progress.attempt = attempts_.size() + 1;
  if (!has_mesh()) return;
  progress.hexahedra = best_->made->mesh.hexahedra.size();
  progress.is_whole = best_->made->are_complete();
}

void AttemptQueue::run() {
  while (!is_done()) {
    AttemptKind* const next = due();
    if (next == nullptr) return;
    make(*next);
  }
}

AttemptKind* AttemptQueue::due() const {
  const bool is_exhausted = work_ >= most_work_ && best_;
  if (is_exhausted && has_mesh()) return nullptr;
  AttemptKind* first = nullptr;
  std::optional<Turn> least;
  for (const auto& kind : kinds_) {
    if (is_exhausted && !kind->is_last_resort()) continue;
    const std::optional<Turn> turn = kind->next(*this);
    if (!turn || (least && !(*turn < *least))) continue;
    first = kind.get();
    least = turn;
  }
  return first;
}

void AttemptQueue::make(AttemptKind& kind) {
  monitor_.check_stop();
  Stopwatch stopwatch;
  const std::size_t before = attempts_.size();
  try {
    for (HexCandidate& candidate : kind.make(*this)) add(kind, std::move(candidate));
  } catch (const Error& error) {
    if (!has_mesh() || error.kind() == ErrorKind::kInterrupted) throw;
    HexAttempt& failed = attempts_.emplace_back();
    failed.kind = kind.name();
    failed.failure = error.text();
    failed.seconds = stopwatch.restart();
  }
  for (std::size_t k = before; k < attempts_.size(); ++k) work_ += attempts_[k].work;
}

void AttemptQueue::add(const AttemptKind& kind, HexCandidate candidate) {
  HexAttempt& attempt = candidate.attempt;
  attempt.kind = kind.name();
  if (candidate.made && !candidate.made->mesh.hexahedra.empty())
    attempt.outcome = candidate.made->are_complete() ? HexOutcome::kAllHex : HexOutcome::kPartial;
  const HexSeconds& seconds = candidate.seconds;
  seconds_.repair += seconds.repair;
  seconds_.map += seconds.map;
  seconds_.extraction += seconds.extraction;
  seconds_.smoothing += seconds.smoothing;
  if (attempt.seconds == 0) attempt.seconds = seconds.sum();
  candidate.number = attempts_.size();
  attempts_.push_back(attempt);
  if (candidate.made || candidate.followed)
    keep_if_better(std::make_shared<const HexCandidate>(std::move(candidate)));
}

void AttemptQueue::keep_if_better(const std::shared_ptr<const HexCandidate>& candidate) {
  if (is_done()) return;
  const std::size_t round = candidate->attempt.round;
  if (of_rounds_.size() <= round) of_rounds_.resize(round + 1);
  if (of_rounds_[round] && !is_better_in_round(*candidate, *of_rounds_[round], least_quality_)) return;
  of_rounds_[round] = candidate;
  best_.reset();
  for (const auto& one : of_rounds_)
    if (one && (!best_ || is_better(*one, *best_, least_quality_))) best_ = one;
}

void AttemptQueue::start_on(StartingField field) {
  start_ = std::move(field);
  // Of earlier rounds only maps that rounding folds are gone on with.
  for (auto& earlier : of_rounds_)
    if (earlier && earlier != best_ && !earlier->attempt.is_folded_by_rounding()) earlier.reset();
  ++rounds_;
}

}  // namespace crossgrain
