// SPDX-License-Identifier: Apache-2.0
#include "hex/smaller_hexahedra.hpp"

#include <cmath>

#include "hex/field_mapping.hpp"
#include "hex/hex_making.hpp"
#include "hex/mapped_field.hpp"

namespace crossgrain {
namespace {

/// So many more rounds come before smaller hexahedra.
constexpr std::size_t kRoundsBefore = 1;

bool may_go_on(const HexCandidate& candidate, double least_quality) {
  return candidate.made && candidate.attempt.is_folded_by_rounding() && !is_good(candidate, least_quality);
}

}  // namespace

/// The first round with something to go on with.
std::size_t SmallerHexahedra::next_round(const AttemptQueue& queue) const {
  const auto& best = queue.best_of_rounds();
  std::size_t round = rounds_;
  while (round < best.size() && !(best[round] && may_go_on(*best[round], queue.least_quality()))) ++round;
  return round;
}

std::optional<Turn> SmallerHexahedra::next(const AttemptQueue& queue) const {
  if (tuning_.smaller_sizes == 0) return std::nullopt;
  if (best_) return turn_;
  const std::size_t round = next_round(queue);
  if (round >= queue.best_of_rounds().size()) return std::nullopt;
  return Turn{round + kRoundsBefore, Turn::Step::kSmaller};
}

std::vector<HexCandidate> SmallerHexahedra::make(AttemptQueue& queue) {
  if (!best_) {
    turn_ = next(queue);
    rounds_ = next_round(queue);
    best_ = *queue.best_of_rounds()[rounds_];
    // Vertices of the repaired tets have moved, those of the box by rounding too.
    size_ = starting_field(best_->mappable->field, options_).size;
    sizes_ = 0;
  }
  queue.monitor().report(
      {Phase::kHexahedra, 0, best_->mappable->followed.solid().mesh.vertices.size(), 0, NAN});
  HexCandidate base = *best_;
  base.attempt.work = 0;
  base.seconds = {};
  size_ *= tuning_.smaller_share;
  const bool is_last = ++sizes_ == tuning_.smaller_sizes;
  HexCandidate candidate = mapped_candidate(base, size_, tuning_);
  if (is_better_in_round(candidate, *best_, queue.least_quality())) best_ = candidate;
  if (is_last || !may_go_on(*best_, queue.least_quality())) {
    best_.reset();
    ++rounds_;
  }
  return {std::move(candidate)};
}

}  // namespace crossgrain
