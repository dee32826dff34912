// SPDX-License-Identifier: Apache-2.0
// A solve by several processes.
#pragma once

#include <optional>

#include "crossgrain/solve.hpp"
#include "field/nested_solve.hpp"

namespace crossgrain {

/// Returns in the first process what `solve` returns, or `solve_from` if there is an earlier field, to the
/// bit; nothing in the others. All call it with the same arguments. Throws like those, in any process.
std::optional<FrameField> solve_together(LevelSharing& sharing, const FrameField* earlier,
                                         const TriangleMesh& mesh, const SolveOptions& options,
                                         const Monitor& monitor);

}  // namespace crossgrain
