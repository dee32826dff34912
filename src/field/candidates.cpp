// SPDX-License-Identifier: Apache-2.0
#include "field/candidates.hpp"

#include <algorithm>
#include <utility>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

double all_of(const EnergyParts& parts) {
  return parts.total() + parts.unavoidable;
}

}  // namespace

std::vector<StoredQuaternion> inherited(const std::vector<StoredQuaternion>& frames,
                                        std::span<const CellIndex> parent) {
  if (parent.empty()) return frames;
  auto result = sized_vector<StoredQuaternion>(parent.size());
  parallel_for(parent.size(), [&](std::size_t i) { result[i] = frames[parent[i]]; });
  return result;
}

void Candidates::begin_with(Frames frames) {
  fields_.resize(1);
  fields_.front().frames = std::move(frames);
}

void Candidates::begin_at_random(std::size_t leaves, int starts, std::uint64_t seed) {
  fields_.resize(static_cast<std::size_t>(std::max(1, starts)));
  // Seeds are spread, so that start k of one seed is not start k - 1 of the next.
  for (std::size_t start = 0; start < fields_.size(); ++start)
    fields_[start].frames = random_frames(leaves, seed * 0x9e3779b97f4a7c15 + start);
}

void Candidates::inherit(const Candidates& before, std::span<const CellIndex> parent) {
  fields_.resize(before.size());
  for (std::size_t c = 0; c < fields_.size(); ++c)
    fields_[c].frames = inherited(before.fields_[c].frames, parent);
}

Candidates::Best Candidates::find_best(const GridLevel& level, const Solid& solid, const Adjacency& adjacency,
                                       double boundary_weight, SharpTurns sharp_turns, bool end_race) {
  Best best;
  for (std::size_t c = 0; c < fields_.size(); ++c) {
    LevelEnergy energy =
        level_energy(level, solid, adjacency, fields_[c].frames, boundary_weight, sharp_turns);
    if (c > 0 && !(all_of(energy.parts) < all_of(best.energy.parts))) continue;
    best = {std::move(energy), fields_[c].settled};
    best_ = c;
  }
  if (end_race) {
    if (best_ > 0) fields_[0] = std::move(fields_[std::exchange(best_, 0)]);
    fields_.resize(1);
  }
  return best;
}

}  // namespace crossgrain
