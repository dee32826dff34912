// SPDX-License-Identifier: Apache-2.0
#include "hex/attempt_queue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/stopwatch.hpp"
#include "crossgrain/error.hpp"
#include "hex/hex_report.hpp"

namespace crossgrain {

AttemptQueue::AttemptQueue(double most_work, double least_quality, const Monitor& monitor)
    : most_work_(most_work),
      least_quality_(least_quality),
      may_be_stopped_(monitor.may_be_stopped()),
      monitor_(monitor, [this](Progress& progress) { tell_more(progress); }) {}

void AttemptQueue::tell_more(Progress& progress) const {
  progress.attempt = at_meshes_ + 1;
  progress.attempts = std::max(expected_, progress.attempt);
  if (!has_mesh()) return;
  progress.hexahedra = best_->made->mesh.hexahedra.size();
  progress.is_whole = best_->made->are_complete();
}

void AttemptQueue::run() {
  AttemptKind* next = due();
  while (next != nullptr) {
    expected_ = at_meshes_ + most_attempts();
    make(*next);
    next = is_done() || is_stopped_ ? nullptr : due();
    tell_ends(next);
  }
}

std::size_t AttemptQueue::most_attempts() const {
  std::size_t most = 0;
  for (const auto& kind : kinds_) most += kind->left(*this);
  return most;
}

void AttemptQueue::tell_ends(const AttemptKind* next) {
  if (on_end_ && !ends_.empty()) {
    if (next != nullptr) ends_.back().next = next->plan(*this);
    for (std::size_t k = 0; k < ends_.size(); ++k) {
      HexAttemptEnd& end = ends_[k];
      if (k + 1 < ends_.size()) end.next = fmt::format("attempt {}, made at the same time", end.attempt + 1);
      end.attempts = at_meshes_ + (next != nullptr ? most_attempts() : 0);
      on_end_(end);
    }
  }
  ends_.clear();
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
  Stopwatch stopwatch;
  const std::size_t before = attempts_.size();
  try {
    monitor_.check_stop();
    for (HexCandidate& candidate : kind.make(*this)) add(kind, std::move(candidate));
  } catch (const Error& error) {
    if (!has_mesh()) throw;
    if (error.kind() == ErrorKind::kInterrupted && !is_ended_by_stop()) throw;
    add_failure(kind, error, stopwatch.restart());
  }
  for (std::size_t k = before; k < attempts_.size(); ++k) work_ += attempts_[k].work;
}

/// Whether a stop ends the search with the mesh that there is.
bool AttemptQueue::is_ended_by_stop() {
  is_stopped_ =
      may_be_stopped_ && monitor_.stopped() && !monitor_.cancelled() && !best_->made->mesh.hexahedra.empty();
  return is_stopped_;
}

void AttemptQueue::add_failure(const AttemptKind& kind, const Error& error, double seconds) {
  HexAttempt& failed = attempts_.emplace_back();
  failed.kind = kind.name();
  failed.failure = error.text();
  failed.seconds = seconds;
  add_end(failed, error.text());
}

void AttemptQueue::add_end(const HexAttempt& attempt, std::string text) {
  HexAttemptEnd& end = ends_.emplace_back();
  end.attempt = ++at_meshes_;
  end.outcome = attempt.outcome;
  end.hexahedra = attempt.hexahedra;
  end.text = std::move(text);
  end.seconds = attempt.seconds;
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
  if (kind.makes_meshes()) add_end(attempt, end_of(candidate, least_quality_));
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
