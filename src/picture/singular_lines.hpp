// SPDX-License-Identifier: Apache-2.0
// Singular lines as rods, and marks where they meet, end and turn.
#pragma once

#include <array>
#include <optional>

#include "display/drawn_lines.hpp"
#include "picture/drawing.hpp"
#include "picture/legend.hpp"

namespace crossgrain {

/// How parts without hexahedra look: crimson if that is certain, violet if it is undecided.
struct FaultLook {
  Verdict verdict;
  const char* words;
  Colour colour;
  double size;  ///< of marks, as a multiple of the radius of singular lines
};
inline constexpr FaultLook kImpossibleLook{Verdict::kNotMeshable, "impossible for hexahedra",
                                           colour_of(0xd3125f), 2.3};
inline constexpr FaultLook kUndecidedLook{Verdict::kUndecided, "undecided", colour_of(0x8b5cc7), 2.1};
inline constexpr std::array kFaultLooks{kImpossibleLook, kUndecidedLook};

/// Rods and marks of lines: `radius` of the rods where neither the wall nor the length of a line limits it,
/// model units; `ink` is the colour of nodes without fault.
DrawnRods singular_lines(const DrawnLines& lines, double radius, const Colour& ink);

/// Caps on the ends of singular lines in a plane that cuts them, with a rim of `ink`.
std::vector<Facet> crossings_of(const DrawnRods& lines, const Vector3& normal, double offset,
                                const Colour& ink);

/// Legend of the colours and marks that occur, with their numbers as `crossgrain check` counts them: lines of
/// an index, nodes and ends include those that are impossible or undecided, which have signs of their own
/// too. None if there are no lines.
std::optional<LegendBlock> legend_of(const ShownField& field, const char* title, const Colour& ink);

}  // namespace crossgrain
