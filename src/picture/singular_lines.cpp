// SPDX-License-Identifier: Apache-2.0
#include "picture/singular_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "picture/mark_shapes.hpp"

namespace crossgrain {
namespace {

using Arc = SingularityGraph::Arc;
using Node = SingularityGraph::Node;

struct LineLook {
  Colour colour;
  double thickness;  ///< as a multiple of the usual radius
};

// Blue and orange are distinguishable with any colour vision; faults are also thicker.
constexpr LineLook kThree{colour_of(0x1272c4), 1}, kFive{colour_of(0xf09a1a), 1},
    kSix{colour_of(0x12916f), 1}, kImpossible{kImpossibleLook.colour, 1.35},
    kUndecided{kUndecidedLook.colour, 1};

/// Colour of turning points: gold, which stands out from the crimson of their lines.
constexpr Colour kTurning = colour_of(0xffd23e);

// Sizes of marks, as multiples of the radius of lines.
constexpr double kNodeRadius = 2.6, kDiscRadius = 2.3, kDiscThickness = 0.9, kTurningRadius = 2.5,
                 kTurningLength = 6.5, kCapRadius = 1.25, kCapRim = 1.75, kCapThickness = 0.3, kDiscCap = 1.5;

/// Smallest radius of an end on the surface, as a share of the usual one: it lies in the surface, so that the
/// wall does not limit it.
constexpr double kLeastEnd = 0.55;

const LineLook& look_of(LineKind kind) {
  switch (kind) {
    case LineKind::kThree:
      return kThree;
    case LineKind::kFive:
      return kFive;
    case LineKind::kSix:
      return kSix;
    case LineKind::kImpossible:
      return kImpossible;
    case LineKind::kUndecided:
      break;
  }
  return kUndecided;
}

/// Usual radius of a line of a length: short ones are thinner, down to half, so that the marks at their ends
/// do not hide them.
double usual_for(double length, double usual) {
  constexpr double kShareOfLength = 0.09, kThinnest = 0.5;
  return std::clamp(kShareOfLength * length, kThinnest * usual, usual);
}

const FaultLook* fault_of(Verdict verdict) {
  for (const FaultLook& look : kFaultLooks)
    if (look.verdict == verdict) return &look;
  return nullptr;
}

/// Adds a disc with a cap in the colour of the line, which in a thin wall is not long enough to show it.
void add_end(const LineMark& mark, double radius, const Colour& rim, std::vector<Facet>& facets) {
  add_disc(mark.place, mark.direction, kDiscRadius * radius, kDiscThickness * radius, rim, facets);
  add_disc(mark.place, mark.direction, kDiscCap * radius, (kDiscThickness + kCapThickness) * radius,
           look_of(mark.kind).colour, facets);
}

void add_mark(const LineMark& mark, double usual, const Colour& ink, DrawnRods& drawn) {
  const double radius = line_radius(usual_for(mark.length, usual), mark.wall);
  const FaultLook* fault = fault_of(mark.verdict);
  const Colour& colour = fault ? fault->colour : ink;
  switch (mark.shape) {
    case MarkShape::kNode:
      drawn.balls.push_back({mark.place, std::max(fault ? fault->size : 0, kNodeRadius) * radius, colour});
      break;
    case MarkShape::kEnd:
      add_end(mark, std::max(radius, kLeastEnd * usual), colour, drawn.facets);
      break;
    case MarkShape::kTurningPoint:
      add_double_pyramid(mark.place, mark.direction, kTurningRadius * radius, kTurningLength * radius,
                         kTurning, drawn.facets);
      break;
  }
}

}  // namespace

DrawnRods singular_lines(const DrawnLines& lines, double radius, const Colour& ink) {
  DrawnRods drawn;
  for (const DrawnLine& line : lines.lines) {
    const LineLook& look = look_of(line.kind);
    const double usual = look.thickness * usual_for(line.length, radius);
    for (std::size_t i = 1; i < line.points.size(); ++i)
      drawn.rods.push_back({line.points[i - 1], line.points[i], line_radius(usual, line.walls[i - 1]),
                            look.colour, line_radius(usual, line.walls[i])});
  }
  for (const LineMark& mark : lines.marks) add_mark(mark, radius, ink, drawn);
  return drawn;
}

std::vector<Facet> crossings_of(const DrawnRods& lines, const Vector3& normal, double offset,
                                const Colour& ink) {
  std::vector<Facet> facets;
  for (const Rod& rod : lines.rods) {
    const double from = dot(normal, rod.from) - offset, to = dot(normal, rod.to) - offset;
    if ((from > 0) == (to > 0)) continue;
    const double share = from / (from - to);
    const double radius = rod.radius + share * (rod.end_radius - rod.radius);
    const Vector3 place = rod.from + share * (rod.to - rod.from);
    add_disc(place, normal, kCapRim * radius, kCapThickness * radius, ink, facets);
    add_disc(place, normal, kCapRadius * radius, 2 * kCapThickness * radius, rod.colour, facets);
  }
  return facets;
}

std::optional<LegendBlock> legend_of(const ShownField& field, const char* title, const Colour& ink) {
  const SingularityGraph& graph = field.lines();
  LegendBlock block{title};
  const auto add = [&](Sign::Shape shape, const Colour& colour, const char* text, std::size_t count) {
    if (count > 0) block.signs.push_back({shape, colour, fmt::format("{} ({})", text, count)});
  };
  const auto arcs = [&](const auto& is_meant) {
    return static_cast<std::size_t>(std::ranges::count_if(graph.arcs, is_meant));
  };
  const auto nodes = [&](const auto& is_meant) {
    return static_cast<std::size_t>(std::ranges::count_if(graph.nodes, is_meant));
  };
  using enum Sign::Shape;
  add(kLine, kThree.colour, "index +1/4: three hexahedra",
      arcs([](const Arc& a) { return a.index == 0.25; }));
  add(kLine, kFive.colour, "index −1/4: five hexahedra", arcs([](const Arc& a) { return a.index == -0.25; }));
  add(kLine, kSix.colour, "index −1/2: six hexahedra", arcs([](const Arc& a) { return a.index == -0.5; }));
  for (const FaultLook& look : kFaultLooks)
    add(kLine, look.colour, look.words, arcs([&](const Arc& a) { return a.verdict == look.verdict; }));
  std::size_t turns = 0;
  for (const Arc& arc : graph.arcs) turns += arc.turning_points.size();
  add(kDiamond, kTurning, "turning point: changes its sense", turns);
  const auto is_node = [](const Node& n) { return n.degree() > 1; };
  add(kBall, ink, "node: lines meet", nodes(is_node));
  for (const FaultLook& look : kFaultLooks)
    add(kBall, look.colour, fmt::format("node, {}", look.words).c_str(),
        nodes([&](const Node& n) { return is_node(n) && n.verdict == look.verdict; }));
  add(kDisc, ink, "end on the surface", nodes([](const Node& n) { return n.on_boundary; }));
  for (const FaultLook& look : kFaultLooks)
    add(kDisc, look.colour, fmt::format("end, {}", look.words).c_str(),
        nodes([&](const Node& n) { return n.on_boundary && !is_node(n) && n.verdict == look.verdict; }));
  const SolveReport::Singularity& counts = field.counts();
  add(kNothing, ink, "too short to tell, not drawn", counts.unresolved_loops + counts.unresolved_stubs);
  if (block.signs.empty()) return std::nullopt;
  return block;
}

}  // namespace crossgrain
