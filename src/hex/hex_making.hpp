// SPDX-License-Identifier: Apache-2.0
// Hexahedra by a queue of attempts, for whoever adds attempts of further kinds.
#pragma once

#include <functional>

#include "crossgrain/hexahedra.hpp"
#include "hex/attempt_queue.hpp"
#include "hex/hex_tuning.hpp"

namespace crossgrain {

/// Throws Error(kUsage) for options out of range.
void check_options(const HexOptions& options);

/// Returns the size of hexahedra that the options ask for in a model, and about how many will fill it.
double asked_size(const TetDomain& domain, const HexOptions& options);
double expected_hexahedra(const TetDomain& domain, double size);

/// Returns a field to start from, with the size of hexahedra that the options ask for.
StartingField starting_field(TetFrameField field, const HexOptions& options);

/// Returns the best of all attempts, with the report of all. `begin` starts on a field, or adds attempts that
/// do. Throws Error(kUsage) before for options out of range.
Hexahedra best_of_attempts(const std::function<void(AttemptQueue&)>& begin, const HexOptions& options,
                           const HexTuning& tuning, const Monitor& monitor);

}  // namespace crossgrain
