// SPDX-License-Identifier: Apache-2.0
#include "hex/lattice_trials.hpp"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "crossgrain/error.hpp"
#include "hex/hex_report.hpp"

namespace crossgrain {
namespace {

/// Lattices one after the other, with the best so far.
class LatticeTrials {
 public:
  LatticeTrials(const FittingModel& model, double size, const Monitor& monitor,
                const LatticeListeners& listeners)
      : monitor_(monitor),
        of_attempt_(monitor, [this](Progress& progress) { tell_more(progress); }),
        listeners_(listeners),
        search_(model, size, of_attempt_) {}

  LatticeHexahedra run() {
    try {
      bool has_next = search_.prepare();
      if (has_next) expected_ = search_.expected();
      if (has_next && listeners_.on_expected) listeners_.on_expected(search_.size(), expected_);
      while (has_next) {
        LatticeSearch::Trial trial = search_.make();
        attempts_.push_back(trial.attempt);
        if (trial.better) best_ = std::move(trial.better), best_attempt_ = attempts_.size() - 1;
        has_next = prepare_after(trial);
      }
    } catch (const Error& error) {
      end_early(error);
    }
    if (!best_)
      throw Error(ErrorKind::kInput, {"", "", "no cell of a lattice is inside the model", Remedy::kUseHexSize,
                                      next_smaller_size(attempts_.back().size)});
    best_->report.attempts = std::move(attempts_);
    best_->report.best_attempt = best_attempt_;
    best_->report.expected = expected_;
    choose_remedy_of_lattices(best_->report, best_->has_joined);
    return *std::move(best_);
  }

 private:
  void tell_more(Progress& progress) const {
    progress.attempt = attempts_.size() + 1;
    if (!best_) return;
    progress.hexahedra = best_->mesh.hexahedra.size();
    progress.outcome = best_->report.outcome;
  }

  /// Tells of the end of a trial with what follows, even if that fails.
  bool prepare_after(LatticeSearch::Trial& trial) {
    HexAttemptEnd end;
    end.attempt = trial.attempt.number;
    end.outcome = trial.attempt.outcome;
    end.hexahedra = trial.attempt.hexahedra;
    end.text = std::move(trial.text);
    end.seconds = trial.attempt.seconds;
    const auto tell = [&] {
      if (listeners_.on_end) listeners_.on_end(end);
    };
    bool has_next = false;
    try {
      has_next = search_.prepare();
    } catch (const Error&) {
      tell();
      throw;
    }
    if (has_next) end.next = search_.plan();
    tell();
    return has_next;
  }

  /// Keeps the best so far after a stop or at a limit; throws the error that is being handled otherwise.
  void end_early(const Error& error) {
    const bool is_stop = error.kind() == ErrorKind::kInterrupted && monitor_.may_be_stopped() &&
                         monitor_.stopped() && !monitor_.cancelled();
    if (!best_ || !(is_stop || error.kind() == ErrorKind::kLimit)) throw;
    if (is_stop)
      best_->report.is_stopped = true;
    else
      best_->warnings.push_back(ended_at(error));
  }

  const Monitor& monitor_;
  const Monitor of_attempt_;
  const LatticeListeners& listeners_;
  std::vector<HexAttempt> attempts_;
  std::optional<LatticeHexahedra> best_;
  std::size_t best_attempt_ = 0;
  double expected_ = 0;  ///< as it was told
  LatticeSearch search_;
};

}  // namespace

LatticeHexahedra lattice_hexahedra(const FittingModel& model, double size, const Monitor& monitor,
                                   const LatticeListeners& listeners) {
  return LatticeTrials(model, size, monitor, listeners).run();
}

}  // namespace crossgrain
