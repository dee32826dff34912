// SPDX-License-Identifier: Apache-2.0
// Prints the numbers of a table of docs/notes/hexahedra.md: what each of several weights makes of a repair,
// and whether a map can follow it.
//
//   repair_tries MESH...      meshes as for `crossgrain solve`; prepared for a map, solved, and repaired with
//   one try each
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "base/vector3.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/solve.hpp"
#include "map/poisson_map.hpp"
#include "map/untangling.hpp"
#include "matching/repaired_graph.hpp"
#include "reduction/arc_lengths.hpp"
#include "reduction/demanded_splits.hpp"
#include "solve/field_repairs.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tet_field.hpp"

namespace crossgrain {
namespace {

constexpr double kCells = 10;  // along the longest side
constexpr std::array kTries{RepairWeights{1, 1, 200},     RepairWeights{3, 5, 200},
                            RepairWeights{3, 2, 200},     RepairWeights{10, 0.5, 200},
                            RepairWeights{1, 0.3, 200},   RepairWeights{0, 0.05, 200},
                            RepairWeights{0.3, 0.1, 200}, RepairWeights{3, 0.1, 200}};

void add_row(const std::string& name, const TetFrameField& given, const RepairWeights& weights) {
  const TetFrameField field =
      FieldRepairs(given, {}, {.tries = {weights}, .finalists = 1, .wanderings = 2}, {}).best();
  const TetDomainData& data = field.domain().data();
  const TetComplex complex(data.solid, data.features);
  const MatchedField matched(complex, field.data().tet_frames, matchings_of(data.solid, field.data()));
  const CutSolid cut(matched);
  const std::vector<LinearForm> lengths = arc_lengths(MapUnknowns(cut), field.singularities());
  const auto zeros =
      std::count_if(lengths.begin(), lengths.end(), [](const LinearForm& l) { return l.is_zero(); });
  const OwnedField split = split_for_map(matched);
  const CutSolid split_cut(*split.field);
  const MapUnknowns unknowns(split_cut);
  const MapEnergy energy(unknowns, longest_side(data.box) / kCells);
  const PoissonMap poisson(energy);
  const Eigen::VectorXd columns = poisson.columns_for(poisson.relaxed());
  const MapFlips seamless = flips_of(energy, energy.basis() * columns);
  const MapFlips left = untangled(poisson, columns, IntegerColumns::kHeld).flips;
  const SolveReport::Onto::Repair& repair = *field.report().onto->repair;
  fmt::print("| {} | {:g}, {:g} | {} | {} | {} | {:.3g} | {} → {} | {:.4f} |\n", name, weights.end,
             weights.crease, repair.faults, lengths.size(), zeros, repair.bent_length, seamless.tets,
             left.tets, left.share_of_volume);
  std::fflush(stdout);
}

}  // namespace
}  // namespace crossgrain

int main(int argc, char** argv) {
  using namespace crossgrain;
  fmt::print(
      "| mesh | end, crease | faults | arcs | of length zero | bent | flips, untangled | share of volume |\n"
      "|---|---|---|---|---|---|---|---|\n");
  for (int k = 1; k < argc; ++k) {
    const TetFrameField field = solve_onto(TetDomain(read_tets(argv[k])).prepared_for_map());
    for (const RepairWeights& weights : kTries)
      add_row(std::filesystem::path(argv[k]).stem().string(), field, weights);
  }
}
