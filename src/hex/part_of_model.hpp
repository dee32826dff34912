// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "hex/attempt_queue.hpp"
#include "hex/hex_tuning.hpp"

namespace crossgrain {

/// The attempt at a part of the model where no repair of the round has a map: with little effort, on the
/// best of them.
class PartOfModel : public AttemptKind {
 public:
  /// The tuning must outlive the object.
  explicit PartOfModel(const HexTuning& tuning) : tuning_(tuning) {}

  const char* name() const override { return "part of the model"; }
  bool is_last_resort() const override { return true; }
  std::optional<Turn> next(const AttemptQueue& queue) const override;
  std::vector<HexCandidate> make(AttemptQueue& queue) override;

 private:
  const HexTuning& tuning_;
  std::size_t rounds_ = 0;  ///< that have their part, or need none
};

}  // namespace crossgrain
