// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "crossgrain/hexahedra.hpp"
#include "hex/attempt_queue.hpp"
#include "hex/hex_tuning.hpp"

namespace crossgrain {

/// Attempts at smaller hexahedra on the best maps of rounds that are without flips until their numbers are
/// whole. Other tets come first, where there are some: they may have a map at the size that was asked for.
class SmallerHexahedra : public AttemptKind {
 public:
  /// The tuning must outlive the object.
  SmallerHexahedra(const HexOptions& options, const HexTuning& tuning) : options_(options), tuning_(tuning) {}

  const char* name() const override { return "smaller hexahedra"; }
  std::optional<Turn> next(const AttemptQueue& queue) const override;
  std::vector<HexCandidate> make(AttemptQueue& queue) override;

 private:
  std::size_t next_round(const AttemptQueue& queue) const;

  const HexOptions options_;
  const HexTuning& tuning_;
  std::size_t rounds_ = 0;            ///< that were gone on with, or need not be
  std::optional<Turn> turn_;          ///< of the round that is gone on with
  std::optional<HexCandidate> best_;  ///< of that round
  double size_ = 0;                   ///< the last one tried in that round
  int sizes_ = 0;                     ///< that were tried there
};

}  // namespace crossgrain
