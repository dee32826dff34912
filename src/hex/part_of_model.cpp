// SPDX-License-Identifier: Apache-2.0
#include "hex/part_of_model.hpp"

#include "hex/field_mapping.hpp"

namespace crossgrain {

std::optional<Turn> PartOfModel::next(const AttemptQueue& queue) const {
  const auto& best = queue.best_of_rounds();
  if (rounds_ == queue.rounds() || best.size() < queue.rounds() || !best.back() || best.back()->made)
    return std::nullopt;
  return Turn{queue.rounds() - 1, Turn::Step::kPart};
}

std::vector<HexCandidate> PartOfModel::make(AttemptQueue& queue) {
  rounds_ = queue.rounds();
  HexCandidate base = *queue.best_of_rounds().back();
  base.attempt.work = 0;
  base.seconds = {};
  return {mapped_candidate(base, base.asked_size, tuning_, little_effort())};
}

}  // namespace crossgrain
