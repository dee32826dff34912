// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "hex/attempt_kinds.hpp"
#include "hex/field_mapping.hpp"

namespace crossgrain {
namespace {

class PartOfModel : public AttemptKind {
 public:
  explicit PartOfModel(const HexTuning& tuning) : tuning_(tuning) {}

  const char* name() const override { return kPartOfModel; }
  bool is_last_resort() const override { return true; }

  std::optional<Turn> next(const AttemptQueue& queue) const override {
    if (queue.is_exhausted() && queue.has_mesh()) return std::nullopt;
    const auto& best = queue.best_of_rounds();
    if (rounds_ == queue.rounds() || best.size() < queue.rounds() || !best.back() || best.back()->made)
      return std::nullopt;
    return Turn{queue.rounds() - 1, Turn::Step::kPart};
  }

  std::string plan(const AttemptQueue&) const override { return "to mesh only a part of the model"; }

  std::vector<HexCandidate> make(AttemptQueue& queue) override {
    rounds_ = queue.rounds();
    const HexCandidate& base = *queue.best_of_rounds().back();
    return {mapped_candidate(base, base.asked_size, tuning_, MappingEffort::kLittle)};
  }

 private:
  const HexTuning& tuning_;
  std::size_t rounds_ = 0;  ///< that have their part, or need none
};

}  // namespace

std::unique_ptr<AttemptKind> part_of_model(const HexTuning& tuning) {
  return std::make_unique<PartOfModel>(tuning);
}

}  // namespace crossgrain
