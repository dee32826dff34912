// SPDX-License-Identifier: Apache-2.0
// The fields of a level that are still compared: those of several starts on small levels, of one later.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "field/energy.hpp"
#include "field/field_state.hpp"
#include "field/stages.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

/// Returns for each leaf the frame of its parent; without parents, frames are those of the leaves already.
std::vector<StoredQuaternion> inherited(const std::vector<StoredQuaternion>& frames,
                                        std::span<const CellIndex> parent);

class Candidates {
 public:
  using Frames = std::vector<StoredQuaternion>;

  std::size_t size() const { return fields_.size(); }
  SettledFrames& operator[](std::size_t candidate) { return fields_[candidate]; }
  SettledFrames& front() { return fields_.front(); }
  const SettledFrames& front() const { return fields_.front(); }

  /// Frames of the candidate of lowest energy on the last level.
  Frames& best_frames() { return fields_[best_].frames; }

  void begin_with(Frames frames);

  /// Begins with `starts` fields of random frames, at least one.
  void begin_at_random(std::size_t leaves, int starts, std::uint64_t seed);

  /// Begins with the frames that the candidates of the level before have in the parents.
  void inherit(const Candidates& before, std::span<const CellIndex> parent);

  /// What the candidate of lowest energy has.
  struct Best {
    LevelEnergy energy;
    bool settled = false;
  };

  /// Finds it; with `end_race`, drops the others. Precondition: there is a candidate.
  Best find_best(const GridLevel& level, const Solid& solid, const Adjacency& adjacency,
                 double boundary_weight, SharpTurns sharp_turns, bool end_race);

 private:
  std::vector<SettledFrames> fields_;
  std::size_t best_ = 0;
};

}  // namespace crossgrain
