// SPDX-License-Identifier: Apache-2.0
// Singular lines as rods, their nodes as balls.
#pragma once

#include <optional>

#include "crossgrain/singularity_graph.hpp"
#include "picture/drawing.hpp"
#include "picture/legend.hpp"

namespace crossgrain {

/// `radius` of rods, model units; `ink` of nodes of which there is nothing to say.
DrawnRods singular_lines(const SingularityGraph& graph, double radius, const Colour& ink);

/// Where singular lines cross a plane.
std::vector<Ball> crossings_of(const DrawnRods& lines, const Vector3& normal, double offset);

/// What their colours mean, of those that there are; none where there are none.
std::optional<LegendBlock> legend_of(const SingularityGraph& graph, const Colour& ink);

}  // namespace crossgrain
