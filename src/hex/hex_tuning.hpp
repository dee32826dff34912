// SPDX-License-Identifier: Apache-2.0
// What steers attempts at hexahedra of a field; docs/notes/hexahedra.md has the measurements. Set by tests
// and bench only.
#pragma once

#include <vector>

#include "repair/repair_tuning.hpp"

namespace crossgrain {

struct HexTuning {
  RepairTuning repair;

  /// Weights besides RepairTuning::tries.
  std::vector<RepairWeights> more_tries = {{0.3, 0.1, 200}, {3, 0.1, 200}};

  /// Attempts end once their work is more (AttemptQueue) and there is a mesh.
  double most_work = 600e6;

  /// Maps are tried no longer once their work is more and there is a lattice: 40 seconds on two cores.
  double map_work = 100e6;

  /// The same where the lattice keeps all of the model. Of nine models whose map came after
  /// the first attempts, it took 14e6 to 51e6 of six, 78e6, 106e6 and 185e6 of the others.
  double map_work_beside_good = 55e6;

  /// Smaller sizes that are tried where the best map is without flips, but whole numbers of hexahedra fold
  /// it.
  int smaller_sizes = 3;

  /// Hexahedra that close up do not fill the model if its surface is farther from theirs, in sizes of
  /// hexahedra: something is cut off, or filled up, that a finer mesh would show.
  double largest_gap = 1.5;

  /// Attempts go on after a mesh whose worst scaled Jacobian is less.
  double least_quality = 0.05;
};

}  // namespace crossgrain
