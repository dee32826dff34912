// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <string>

#include "hex/attempt_kinds.hpp"
#include "hex/candidate_fitting.hpp"
#include "hex/field_mapping.hpp"
#include "hex/hex_making.hpp"
#include "hex/model_fit.hpp"

namespace crossgrain {
namespace {

/// So many more rounds come before smaller hexahedra.
constexpr std::size_t kRoundsBefore = 1;

bool may_go_on(const HexCandidate& candidate, double least_quality) {
  return candidate.made && candidate.attempt.is_folded_by_rounding() && !is_good(candidate, least_quality);
}

class SmallerHexahedra : public AttemptKind {
 public:
  SmallerHexahedra(const HexOptions& options, const HexTuning& tuning) : options_(options), tuning_(tuning) {}

  const char* name() const override { return "smaller hexahedra"; }

  std::optional<Turn> next(const AttemptQueue& queue) const override {
    if (tuning_.smaller_sizes == 0) return std::nullopt;
    if (best_) return turn_;
    const std::size_t round = next_round(queue);
    if (round >= queue.best_of_rounds().size()) return std::nullopt;
    return Turn{round + kRoundsBefore, Turn::Step::kSmaller};
  }

  std::string plan(const AttemptQueue& queue) const override {
    const double last = best_ ? size_ : queue.best_of_rounds()[next_round(queue)]->asked_size;
    return fmt::format("hexahedra of {:.3g}", kSmallerSize * last);
  }

  std::size_t round(const AttemptQueue& queue) const override { return best_ ? rounds_ : next_round(queue); }

  std::vector<HexCandidate> make(AttemptQueue& queue) override {
    if (!best_) {
      turn_ = next(queue);
      rounds_ = next_round(queue);
      best_ = *queue.best_of_rounds()[rounds_];
      // Vertices of the repaired tets have moved, those of the box by rounding too.
      size_ = starting_field(best_->followed->field(), options_).size;
      sizes_ = 0;
    }
    size_ *= kSmallerSize;
    const bool is_last = ++sizes_ == tuning_.smaller_sizes;
    HexCandidate candidate = mapped_candidate(*best_, size_, tuning_);
    fit_if_complete(candidate);
    if (is_better_in_round(candidate, *best_, queue.least_quality())) best_ = candidate;
    if (is_last || !may_go_on(*best_, queue.least_quality())) {
      best_.reset();
      ++rounds_;
    }
    return {std::move(candidate)};
  }

 private:
  /// The first round with something to go on with.
  std::size_t next_round(const AttemptQueue& queue) const {
    const auto& best = queue.best_of_rounds();
    std::size_t round = rounds_;
    while (round < best.size() && !(best[round] && may_go_on(*best[round], queue.least_quality()))) ++round;
    return round;
  }

  const HexOptions options_;
  const HexTuning& tuning_;
  std::size_t rounds_ = 0;            ///< that were gone on with, or need not be
  std::optional<Turn> turn_;          ///< of the round that is gone on with
  std::optional<HexCandidate> best_;  ///< of that round
  double size_ = 0;                   ///< the last one tried in that round
  int sizes_ = 0;                     ///< that were tried there
};

}  // namespace

std::unique_ptr<AttemptKind> smaller_hexahedra(const HexOptions& options, const HexTuning& tuning) {
  return std::make_unique<SmallerHexahedra>(options, tuning);
}

}  // namespace crossgrain
