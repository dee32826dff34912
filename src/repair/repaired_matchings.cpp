// SPDX-License-Identifier: Apache-2.0
#include "repair/repaired_matchings.hpp"

#include <cstdint>
#include <utility>

#include "repair/frozen_frames.hpp"
#include "repair/matched_field.hpp"
#include "repair/matching_repair.hpp"
#include "repair/repair_cost.hpp"

namespace crossgrain {
namespace {

std::size_t faults_of(const MatchedField& field) {
  std::size_t faults = 0;
  const TetComplex& complex = field.complex();
  for (std::uint32_t e = 0; e < complex.edges().size(); ++e) {
    const TetComplex::Edge& edge = complex.edges()[e];
    if (edge.is_branched) continue;
    faults +=
        edge.is_on_boundary() ? field.boundary_turn(e).hexahedra == 0 : !field.turn_around(e).may_be_meshed();
  }
  for (std::uint32_t v = 0; v < complex.solid().mesh.vertices.size(); ++v)
    faults += field.vertex_state(v) == VertexState::kImpossible;
  return faults;
}

double cost_of(const MatchedField& field, const RepairWeights& weights) {
  const RepairCost cost(field, weights);
  double sum = 0;
  for (std::uint32_t e = 0; e < field.complex().edges().size(); ++e) sum += cost.of_edge(e);
  return sum;
}

}  // namespace

RepairedTets repaired_tets(const TetComplex& complex, std::span<const Quaternion> frames,
                           const RepairOptions& options) {
  const MatchedField given(complex, frames);
  const std::size_t faults_before = faults_of(given);
  RepairedTets best;
  double best_cost = 0;
  for (const RepairWeights& weights : options.tries) {
    RepairedTets result{{}, {frames.begin(), frames.end()}, 0, faults_before, 0};
    MatchedField field = given;
    for (int pass = 0; pass < options.passes; ++pass) {
      MatchingRepair repair(field, weights);
      repair.run(options);
      result.moves += repair.moves();
      if (pass > 0 && repair.moves() == 0) break;
      result.frames =
          smoothed_frames(field, std::move(result.frames), {options.smoothing_sweeps, options.smoothing_rad});
      field = field.with_frames(result.frames);
    }
    result.faults = faults_of(field);
    result.matchings = field.matchings();
    const double cost = cost_of(field, options.tries.front());
    if (!best.matchings.empty() && std::pair(result.faults, cost) >= std::pair(best.faults, best_cost))
      continue;
    best = std::move(result);
    best_cost = cost;
    if (best.faults == 0) break;
  }
  return best;
}

}  // namespace crossgrain
