// SPDX-License-Identifier: Apache-2.0
// The best repair of several tries.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/quaternion.hpp"
#include "matching/matched_field.hpp"
#include "repair/repair_tuning.hpp"
#include "singularity/matching.hpp"

namespace crossgrain {

/// Repaired matchings with frames smoothed for them.
struct RepairedTets {
  std::vector<CubeRotation> matchings;
  std::vector<Quaternion> frames;
  std::size_t moves = 0;  ///< of the try that was taken
  std::size_t work = 0;   ///< RepairTuning::most_work that it took

  /// Edges and vertices at which no hexahedra can meet, with the matchings given and with these.
  std::size_t faults_before = 0, faults = 0;
};

/// Returns the matchings given, with frames smoothed for them; repaired if there are more faults then than
/// `known_faults`.
RepairedTets smoothed_tets(const MatchedField& given, std::size_t known_faults, const RepairTuning& options);

/// A repair with one set of weights.
struct RepairTry {
  RepairWeights weights;
  RepairedTets tets;
  std::size_t zero_lengths = 0;  ///< arcs_of_length_zero

  /// Those of its faults that are vertices, ascending.
  std::vector<std::uint32_t> impossible_vertices = {};
};

/// Returns all tries, each with frames smoothed for it, the best first, as RepairTuning::tries ranks them;
/// faults do not wander. The tries share the threads.
std::vector<RepairTry> repair_tries(const MatchedField& given, const RepairTuning& options);

/// Returns those of the tries that have faults, but no more than `most_faults`, after these have wandered,
/// the best first: RepairTuning::wanderings times, as long as each leaves no more than half of them, or two.
std::vector<RepairTry> wandered_tries(const MatchedField& given, std::vector<RepairTry> tries,
                                      std::size_t most_faults, const RepairTuning& options);

/// Returns the best of the tries (RepairTuning::tries), with frames smoothed for it.
RepairedTets repaired_tets(const MatchedField& given, const RepairTuning& options);

}  // namespace crossgrain
