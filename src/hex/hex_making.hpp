// SPDX-License-Identifier: Apache-2.0
// Hexahedra with a tuning: for tests, bench, and whoever adds attempts of further kinds.
#pragma once

#include "crossgrain/hexahedra.hpp"
#include "hex/attempt_queue.hpp"
#include "hex/hex_tuning.hpp"

namespace crossgrain {

/// Throws Error(kUsage) for options out of range.
void check_options(const HexOptions& options);

/// Returns a field to start from, with the size of hexahedra that the options ask for.
StartingField starting_field(TetFrameField field, const HexOptions& options);

/// Adds the kinds of attempts that go on with a field. The tuning must outlive the queue.
void add_kinds_on_fields(const HexOptions& options, const HexTuning& tuning, AttemptQueue& queue);

/// Returns the best of a queue that has a mesh, with the report of all attempts.
Hexahedra best_hexahedra(const AttemptQueue& queue);

/// As the public function of that name.
Hexahedra hexahedra(const TetFrameField& field, const HexOptions& options, const HexTuning& tuning,
                    const Monitor& monitor);

}  // namespace crossgrain
