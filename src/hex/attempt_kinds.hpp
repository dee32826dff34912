// SPDX-License-Identifier: Apache-2.0
// The kinds of attempts that go on with a field. Tunings must outlive them.
#pragma once

#include <memory>

#include "crossgrain/hexahedra.hpp"
#include "hex/attempt_queue.hpp"
#include "hex/hex_tuning.hpp"

namespace crossgrain {

/// HexAttempt::kind of attempts at a part of the model.
inline constexpr const char* kPartOfModel = "part of the model";

/// HexAttempt::kind of lattices.
inline constexpr const char* kLatticeKind = "lattice";

/// Attempts at the repairs of the field that a round starts from, each mapped if all its arcs have a length:
/// repairs without faults first, the best first; then what faults become when they wander; two at the same
/// time, until one fills the model. A field that is repaired already is the only attempt.
std::unique_ptr<AttemptKind> repaired_fields(const HexTuning& tuning);

/// The attempt at a part of the model where no repair of the round has a map: with little effort, on the
/// best of them.
std::unique_ptr<AttemptKind> part_of_model(const HexTuning& tuning);

/// Attempts at smaller hexahedra on the best maps of rounds that are without flips until their numbers are
/// whole. Other tets come first, where there are some: they may have a map at the size that was asked for.
std::unique_ptr<AttemptKind> smaller_hexahedra(const HexOptions& options, const HexTuning& tuning);

/// The attempt at lattices of the model (lattice_hexahedra), which follow no field: once the first maps have
/// led to no good mesh; by HexOptions::preference before or after all maps, or never.
std::unique_ptr<AttemptKind> lattice_attempt(const HexOptions& options);

}  // namespace crossgrain
