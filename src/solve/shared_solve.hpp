// SPDX-License-Identifier: Apache-2.0
// A solve by several processes.
#pragma once

#include <optional>

#include "crossgrain/solve.hpp"
#include "field/nested_solve.hpp"
#include "field/solve_tuning.hpp"

namespace crossgrain {

/// Solves like `solve`, or `solve_from` if there is an earlier field, to the same bits. If the last level was
/// shared, each process gets its part of the field; otherwise the first gets the whole, and the others
/// nothing. All call it with the same arguments. Throws like those, in any process.
std::optional<FrameField> solve_together(LevelSharing& sharing, const FrameField* earlier,
                                         const TriangleMesh& mesh, const SolveTuning& options,
                                         const Monitor& monitor);

}  // namespace crossgrain
