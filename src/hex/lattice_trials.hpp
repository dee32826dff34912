// SPDX-License-Identifier: Apache-2.0
// The best hexahedra of a search through lattices alone.
#pragma once

#include <functional>

#include "crossgrain/hexahedra.hpp"
#include "crossgrain/monitor.hpp"
#include "hex/lattice_search.hpp"
#include "hex/model_fitting.hpp"

namespace crossgrain {

struct LatticeListeners {
  /// Hears size and number of the first lattice's hexahedra before they are made.
  std::function<void(double size, double hexahedra)> on_expected;
  std::function<void(const HexAttemptEnd& end)> on_end;  ///< hears of the end of each
};

/// Returns the best of a LatticeSearch, with an attempt for each lattice in the report.
///
/// Throws Error(kInput) if no cell is inside the model, Error(kLimit), and Error(kInterrupted) by the
/// monitor; but a limit and a stop return the best so far if there is one.
LatticeHexahedra lattice_hexahedra(const FittingModel& model, double size, const Monitor& monitor,
                                   const LatticeListeners& listeners = {});

}  // namespace crossgrain
