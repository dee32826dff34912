// SPDX-License-Identifier: Apache-2.0
#include "picture/singular_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace crossgrain {
namespace {

using Arc = SingularityGraph::Arc;
using Node = SingularityGraph::Node;

enum ArcKind : std::size_t { kThree, kFive, kSix, kOther, kImpossible, kArcKinds };
enum NodeKind : std::size_t { kPossibleNode, kUndecidedNode, kImpossibleNode, kEnd, kNodeKinds };

struct Look {
  const char* text;
  Colour colour;
  double thickness;  ///< as a multiple of the usual radius
};

// Blue and orange are distinguishable with any colour vision; faults are also thicker.
constexpr std::array<Look, kArcKinds> kArcs{{{"index +1/4: three hexahedra", colour_of(0x1272c4), 1},
                                             {"index −1/4: five hexahedra", colour_of(0xf09a1a), 1},
                                             {"index −1/2: six hexahedra", colour_of(0x12916f), 1},
                                             {"other", colour_of(0x7d8794), 1},
                                             {"impossible for hexahedra", kImpossibleLook.colour, 1.35}}};
constexpr std::array<Look, kNodeKinds> kNodes{
    {{"node inside", {}, 1.9},
     {"node, undecided", kUndecidedLook.colour, kUndecidedLook.size},
     {"node, impossible for hexahedra", kImpossibleLook.colour, kImpossibleLook.size},
     {"end on the surface", {}, 1.35}}};

ArcKind kind_of(const Arc& arc) {
  if (arc.verdict == Verdict::kNotMeshable) return kImpossible;
  if (arc.index == 0.25) return kThree;
  if (arc.index == -0.25) return kFive;
  return arc.index == -0.5 ? kSix : kOther;
}

NodeKind kind_of(const Node& node) {
  if (node.verdict == Verdict::kNotMeshable) return kImpossibleNode;
  if (node.verdict == Verdict::kUndecided) return kUndecidedNode;
  return node.on_boundary ? kEnd : kPossibleNode;
}

/// Radius of an arc: short ones are thinner, down to about half, so that the balls at their ends do not hide
/// them.
double radius_of(const Arc& arc, double usual) {
  constexpr double kShareOfLength = 0.09, kThinnest = 0.5;
  return kArcs[kind_of(arc)].thickness * std::clamp(kShareOfLength * arc.length, kThinnest * usual, usual);
}

/// Radius of a node, from the thinnest arc that ends there.
double radius_of(const Node& node, const SingularityGraph& graph, double usual) {
  double thinnest = usual;
  for (const std::uint32_t arc : node.arcs)
    thinnest =
        std::min(thinnest, radius_of(graph.arcs[arc], usual) / kArcs[kind_of(graph.arcs[arc])].thickness);
  return kNodes[kind_of(node)].thickness * thinnest;
}

Colour colour_of_node(NodeKind kind, const Colour& ink) {
  return kind == kPossibleNode || kind == kEnd ? ink : kNodes[kind].colour;
}

}  // namespace

DrawnRods singular_lines(const SingularityGraph& graph, double radius, const Colour& ink) {
  DrawnRods drawn;
  for (const Arc& arc : graph.arcs) {
    const Colour& colour = kArcs[kind_of(arc)].colour;
    for (std::size_t i = 1; i < arc.points.size(); ++i)
      drawn.rods.push_back({arc.points[i - 1], arc.points[i], radius_of(arc, radius), colour});
  }
  for (const Node& node : graph.nodes)
    drawn.balls.push_back({node.place, radius_of(node, graph, radius), colour_of_node(kind_of(node), ink)});
  return drawn;
}

std::vector<Ball> crossings_of(const DrawnRods& lines, const Vector3& normal, double offset) {
  std::vector<Ball> balls;
  for (const Rod& rod : lines.rods) {
    const double from = dot(normal, rod.from) - offset, to = dot(normal, rod.to) - offset;
    if ((from > 0) == (to > 0)) continue;
    balls.push_back({rod.from + from / (from - to) * (rod.to - rod.from), 1.25 * rod.radius, rod.colour});
  }
  return balls;
}

std::optional<LegendBlock> legend_of(const SingularityGraph& graph, const char* title, const Colour& ink) {
  std::array<std::size_t, kArcKinds> arcs{};
  std::array<std::size_t, kNodeKinds> nodes{};
  for (const Arc& arc : graph.arcs) ++arcs[kind_of(arc)];
  for (const Node& node : graph.nodes) ++nodes[kind_of(node)];
  LegendBlock block{title};
  const auto add = [&](Sign::Shape shape, const Colour& colour, const char* text, std::size_t count) {
    if (count > 0) block.signs.push_back({shape, colour, fmt::format("{} ({})", text, count)});
  };
  for (std::size_t i = 0; i < kArcKinds; ++i)
    add(Sign::Shape::kLine, kArcs[i].colour, kArcs[i].text, arcs[i]);
  for (std::size_t i = 0; i < kNodeKinds; ++i)
    add(Sign::Shape::kBall, colour_of_node(static_cast<NodeKind>(i), ink), kNodes[i].text, nodes[i]);
  if (block.signs.empty()) return std::nullopt;
  return block;
}

}  // namespace crossgrain
