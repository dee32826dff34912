// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/quaternion.hpp"
#include "hex/attempt_queue.hpp"
#include "hex/hex_tuning.hpp"
#include "solve/field_repairs.hpp"

namespace crossgrain {

/// Attempts at the repairs of the field that a round starts from, each mapped if all its arcs have a length:
/// repairs without faults first, the best first; then what faults become when they wander; two at the same
/// time, until one fills the model. A field that is repaired already is the only attempt.
class RepairedFields : public AttemptKind {
 public:
  /// The tuning must outlive the object.
  explicit RepairedFields(const HexTuning& tuning) : tuning_(tuning) {}

  const char* name() const override { return "repair"; }
  std::optional<Turn> next(const AttemptQueue& queue) const override;
  std::vector<HexCandidate> make(AttemptQueue& queue) override;

 private:
  /// Which tries are taken. Each stage follows when the one before has none left.
  enum class Stage { kSound, kWandered, kAny, kEnd };

  void begin(AttemptQueue& queue);
  void begin_stage(Stage stage, double& work);
  std::vector<HexCandidate> take(std::vector<const RepairTry*> tries, const StartingField& start);
  std::vector<const RepairTry*> next_tries();

  const HexTuning& tuning_;
  std::size_t rounds_ = 0;  ///< that were begun
  std::size_t repairs_ = 0;
  Stage stage_ = Stage::kEnd;
  std::optional<FieldRepairs> repairs_of_field_;
  std::vector<RepairTry> tries_, wandered_;
  std::vector<const RepairTry*> left_;  ///< of the stage
  std::vector<std::vector<CubeRotation>> taken_;
};

}  // namespace crossgrain
