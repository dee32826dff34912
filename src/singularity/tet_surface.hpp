// SPDX-License-Identifier: Apache-2.0
// What a field on tets makes of the surface.
#pragma once

#include <span>

#include "base/quaternion.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// The summary of a graph of these tets, with creases and corners (`add_surface`). `frames` has one entry per
/// tet.
SolveReport::Singularity tet_summary(const TetSolid& solid, std::span<const Quaternion> frames,
                                     const SingularityGraph& graph);

}  // namespace crossgrain
