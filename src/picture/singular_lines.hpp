// SPDX-License-Identifier: Apache-2.0
// Singular lines as rods, and their nodes as balls.
#pragma once

#include <optional>

#include "crossgrain/singularity_graph.hpp"
#include "picture/drawing.hpp"
#include "picture/legend.hpp"

namespace crossgrain {

/// Rods and balls of a graph: `radius` of the rods, model units; `ink` is the colour of nodes without fault.
DrawnRods singular_lines(const SingularityGraph& graph, double radius, const Colour& ink);

/// Balls at the points where singular lines cross a plane.
std::vector<Ball> crossings_of(const DrawnRods& lines, const Vector3& normal, double offset);

/// Legend of the colours that occur; none if there are no lines.
std::optional<LegendBlock> legend_of(const SingularityGraph& graph, const Colour& ink);

}  // namespace crossgrain
