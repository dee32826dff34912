// SPDX-License-Identifier: Apache-2.0
// Singular lines as rods, and their nodes as balls.
#pragma once

#include <array>
#include <optional>

#include "crossgrain/singularity_graph.hpp"
#include "picture/drawing.hpp"
#include "picture/legend.hpp"

namespace crossgrain {

/// How parts without hexahedra look: crimson if that is certain, violet if it is undecided.
struct FaultLook {
  Verdict verdict;
  const char* words;
  Colour colour;
  double size;  ///< radius of balls, as a multiple of that of singular lines
};
inline constexpr FaultLook kImpossibleLook{Verdict::kNotMeshable, "impossible for hexahedra",
                                           colour_of(0xd3125f), 2.3};
inline constexpr FaultLook kUndecidedLook{Verdict::kUndecided, "undecided", colour_of(0x8b5cc7), 2.1};
inline constexpr std::array kFaultLooks{kImpossibleLook, kUndecidedLook};

/// Rods and balls of a graph: `radius` of the rods, model units; `ink` is the colour of nodes without fault.
DrawnRods singular_lines(const SingularityGraph& graph, double radius, const Colour& ink);

/// Balls at the points where singular lines cross a plane.
std::vector<Ball> crossings_of(const DrawnRods& lines, const Vector3& normal, double offset);

/// Legend of the colours that occur, under a title; none if there are no lines.
std::optional<LegendBlock> legend_of(const SingularityGraph& graph, const char* title, const Colour& ink);

}  // namespace crossgrain
