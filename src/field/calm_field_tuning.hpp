// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain {

/// How sweeps end on fields that hardly turn, as in plates and rods: what is left of the energy may be
/// rounding, or a twist over the whole part that fades slowly. Angles stand for the energy of a field that
/// turns by so much evenly along the longest side of the bounding box, 5/3 angle^2 volume / side^2. The
/// sweeps in docs/notes/solver.md chose the defaults.
struct CalmFieldTuning {
  /// Sweeps end when one lowers the energy by less than `sweep_tolerance` of that of this angle.
  double least_turn_deg = 0.1;

  /// So many sweeps may follow those that run out below the energy of kCalmTurnDeg (field/stages.cpp).
  int more_sweeps = 1000;
};

}  // namespace crossgrain
