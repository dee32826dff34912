// SPDX-License-Identifier: Apache-2.0
#include "hex/attempt_queue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/stopwatch.hpp"
#include "crossgrain/error.hpp"
#include "fit/feature_fit.hpp"
#include "hex/hex_report.hpp"

namespace crossgrain {

std::size_t AttemptKind::round(const AttemptQueue& queue) const {
  return queue.rounds() == 0 ? 0 : queue.rounds() - 1;
}

AttemptQueue::AttemptQueue(double most_work, double least_quality, const Monitor& monitor)
    : most_work_(most_work),
      least_quality_(least_quality),
      may_be_stopped_(monitor.may_be_stopped()),
      monitor_(monitor, [this](Progress& progress) { tell_more(progress); }) {}

void AttemptQueue::tell_more(Progress& progress) const {
  progress.attempt = is_preparing_ && at_meshes_ > 0 ? at_meshes_ : at_meshes_ + 1;
  if (follows_field_ || is_preparing_) {
    progress.tets = round_ + 1;
    progress.most_tets = std::max(most_rounds_, round_ + 1);
  }
  if (!has_mesh()) return;
  progress.hexahedra = best_->made->mesh.hexahedra.size();
  progress.outcome = best_->made->outcome();
}

bool AttemptQueue::is_done() const {
  if (!best_) return false;
  if (best_->lattice) return false;  // ended by the work of maps
  if (is_good(*best_, least_quality_)) return true;
  return ends_at_approximate_ && best_->is_filled() && best_->made->quality.least >= least_quality_;
}

double AttemptQueue::allowed_work() const {
  if (!lattice_ || !lattice_->made->are_complete()) return most_work_;
  if (!is_good(*lattice_, kPoorestShape)) return std::min(most_work_, beside_lattice_[0]);
  const auto maps = std::ranges::count_if(
      attempts_, [](const HexAttempt& attempt) { return attempt.number > 0 && !attempt.is_of_lattice(); });
  return maps >= kMostMapsBesideGood ? 0 : std::min(most_work_, beside_lattice_[1]);
}

void AttemptQueue::run() {
  AttemptKind* next = ready();
  while (next != nullptr) {
    round_ = next->round(*this);
    most_rounds_ = most_rounds();
    plan_ = next->plan(*this);
    follows_field_ = next->follows_field();
    make(*next);
    next = is_done() || is_stopped_ ? nullptr : ready();
    tell_ends(next);
  }
}

/// What is due and will be made, also if only to fail. Until then progress is that of the last attempt, whose
/// end is told with what follows.
AttemptKind* AttemptQueue::ready() {
  most_rounds_ = most_rounds();
  is_preparing_ = true;
  AttemptKind* kind = due();
  try {
    while (kind != nullptr && !kind->prepare(*this)) kind = due();
  } catch (const Error&) {
    failure_ = std::current_exception();
  }
  is_preparing_ = false;
  return kind;
}

std::size_t AttemptQueue::most_rounds() const {
  std::size_t most = rounds_;
  for (const auto& kind : kinds_) most += kind->rounds_left(*this);
  return std::max(most, round_ + 1);
}

std::string AttemptQueue::why_over() const {
  if (is_done()) return "";
  if (is_stopped_) return "the search was stopped";
  if (best_ && best_->lattice)
    return attempts_.back().is_of_lattice() ? "" : "maps have had their share of the work";
  return is_exhausted() ? "the work of a search is done" : "nothing else is left to try";
}

void AttemptQueue::tell_ends(const AttemptKind* next) {
  if (on_end_ && !ends_.empty()) {
    if (next != nullptr)
      ends_.back().next = next->plan(*this);
    else
      ends_.back().over = why_over();
    for (std::size_t k = 0; k < ends_.size(); ++k) {
      HexAttemptEnd& end = ends_[k];
      if (k + 1 < ends_.size()) end.next = plan_;
      if (follows_field_) {
        end.tets = round_ + 1;
        end.most_tets = most_rounds();
      }
      on_end_(end);
    }
  }
  ends_.clear();
}

AttemptKind* AttemptQueue::due() const {
  AttemptKind* first = nullptr;
  std::optional<Turn> least;
  for (const auto& kind : kinds_) {
    if (is_exhausted() && !kind->is_last_resort()) continue;
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
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    for (HexCandidate& candidate : kind.make(*this)) add(kind, std::move(candidate));
  } catch (const Error& error) {
    if (!has_mesh()) throw;
    if (error.kind() == ErrorKind::kInterrupted && !is_ended_by_stop()) throw;
    add_failure(kind, error, stopwatch.restart());
  }
  for (std::size_t k = before; k < attempts_.size(); ++k)
    if (!attempts_[k].is_of_lattice()) work_ += attempts_[k].work;
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
  if (error.kind() == ErrorKind::kLimit && !limit_) limit_ = error;
  add_end(failed, {error.text(), ""});
}

void AttemptQueue::add_end(HexAttempt& attempt, EndWords words) {
  attempt.number = ++at_meshes_;
  HexAttemptEnd& end = ends_.emplace_back();
  end.attempt = attempt.number;
  end.outcome = attempt.outcome;
  end.hexahedra = attempt.hexahedra;
  end.text = std::move(words.text);
  end.fault = std::move(words.fault);
  end.seconds = attempt.seconds;
}

void AttemptQueue::add(const AttemptKind& kind, HexCandidate candidate) {
  HexAttempt& attempt = candidate.attempt;
  attempt.kind = kind.name();
  if (candidate.made) attempt.outcome = candidate.made->outcome();
  const HexSeconds& seconds = candidate.seconds;
  seconds_.repair += seconds.repair;
  seconds_.map += seconds.map;
  seconds_.extraction += seconds.extraction;
  seconds_.smoothing += seconds.smoothing;
  if (attempt.seconds == 0) attempt.seconds = seconds.sum();
  candidate.number = attempts_.size();
  if (kind.makes_meshes()) {
    add_end(attempt, end_of(candidate, least_quality_));
  }
  attempts_.push_back(attempt);
  if (candidate.made || candidate.followed)
    keep_if_better(std::make_shared<const HexCandidate>(std::move(candidate)));
}

void AttemptQueue::keep_if_better(const std::shared_ptr<const HexCandidate>& candidate) {
  if (is_done()) return;
  if (candidate->lattice) {
    lattice_ = candidate;
  } else {
    const std::size_t round = candidate->attempt.round;
    if (of_rounds_.size() <= round) of_rounds_.resize(round + 1);
    if (of_rounds_[round] && !is_better_in_round(*candidate, *of_rounds_[round], least_quality_)) return;
    of_rounds_[round] = candidate;
  }
  best_.reset();
  for (const auto& one : of_rounds_)
    if (one && (!best_ || is_better(*one, *best_, least_quality_))) best_ = one;
  if (lattice_ && (!best_ || is_better(*lattice_, *best_, least_quality_))) best_ = lattice_;
}

void AttemptQueue::start_on(StartingField field) {
  start_ = std::move(field);
  // Of earlier rounds only maps that rounding folds are gone on with.
  for (auto& earlier : of_rounds_)
    if (earlier && earlier != best_ && !earlier->attempt.is_folded_by_rounding()) earlier.reset();
  ++rounds_;
}

}  // namespace crossgrain
