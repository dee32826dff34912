// SPDX-License-Identifier: Apache-2.0
// What steers a repair; docs/notes/repair.md has the sweeps. Set by tests and bench only.
#pragma once

#include <cstddef>
#include <vector>

namespace crossgrain {

/// What a repair avoids, relative to the length of singular edges inside.
struct RepairWeights {
  double end = 3;       ///< each end of a singular edge on the surface where an arc may not end
  double crease = 5;    ///< each quarter turn by which the map differs from the geometry, along its length
  double corner = 200;  ///< each vertex at which no hexahedra can meet, in mean edge lengths
};

/// How matchings are repaired. Weights and tolerances are dimensionless.
struct RepairTuning {
  /// Tried each from the field as it is. The result is the one with the fewest faults, of these the one
  /// with the fewest arcs that no map can give a length (an arc from a face of the surface to another point
  /// of it), and of these the one that costs least by the first weights.
  std::vector<RepairWeights> tries = {{1, 1, 200},    {3, 5, 200},   {3, 2, 200},
                                      {10, 0.5, 200}, {1, 0.3, 200}, {0, 0.05, 200}};

  /// Random changes near each vertex that is left, settled and kept if they lower the cost: so many in vain
  /// end the search there.
  int disturbances = 30;

  /// The best tries with faults go on with random changes near faults, settled and kept if they raise the
  /// cost by no more than a random length: faults wander along creases until they meet. Each wandering ends
  /// with the least cost on its way.
  int finalists = 2;
  int wanderings = 4;  ///< as long as there are faults
  int wandering_steps = 3000;

  /// The end of random changes of a try, its wanderings included: after so many costs of edges and vertices
  /// were found; 0 for no limit.
  std::size_t most_work = 0;
};

}  // namespace crossgrain
