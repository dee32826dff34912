// SPDX-License-Identifier: Apache-2.0
#include "display/drawn_lines.hpp"

#include <algorithm>
#include <cstddef>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "display/cell_sizes.hpp"
#include "display/line_ends.hpp"
#include "display/line_walls.hpp"
#include "display/solid_rays.hpp"

namespace crossgrain {
namespace {

using Arc = SingularityGraph::Arc;
using Node = SingularityGraph::Node;

/// Largest distance by which the end of several lines is moved to the surface, in cells. They must still
/// meet, so that each one cannot go on straight.
constexpr double kMostMoved = 1.5;

class LinesOfField {
 public:
  explicit LinesOfField(const ShownField& field)
      : graph_(field.lines()), rays_(field.searchable()), sizes_(field) {}

  DrawnLines lines() const {
    DrawnLines drawn;
    drawn.lines.resize(graph_.arcs.size());
    parallel_for(graph_.arcs.size(), [&](std::size_t a) { drawn.lines[a] = line_of(graph_.arcs[a]); });
    for (std::size_t a = 0; a < graph_.arcs.size(); ++a) {
      for (const std::uint32_t k : graph_.arcs[a].turning_points)
        drawn.marks.push_back(turning_mark(graph_.arcs[a].points[k], drawn.lines[a]));
    }
    for (std::uint32_t n = 0; n < graph_.nodes.size(); ++n) add_marks_of(n, drawn);
    return drawn;
  }

 private:
  DrawnLine line_of(const Arc& arc) const {
    DrawnLine line{kind_of(arc), arc.points, {}, 0};
    if (arc.nodes) {
      const StraightEnd first = end_of(arc, (*arc.nodes)[0]), last = end_of(reversed(arc), (*arc.nodes)[1]);
      line.points = first.points;
      for (std::size_t k = first.next; k + last.next < arc.points.size(); ++k)
        line.points.push_back(arc.points[k]);
      line.points.insert(line.points.end(), last.points.rbegin(), last.points.rend());
    }
    line.walls = walls_along(line.points, rays_);
    for (std::size_t k = 1; k < line.points.size(); ++k)
      line.length += norm(line.points[k] - line.points[k - 1]);
    return line;
  }

  /// An arc in the other direction, as far as its ends need it.
  static Arc reversed(const Arc& arc) {
    Arc out;
    out.points.assign(arc.points.rbegin(), arc.points.rend());
    out.axes.assign(arc.axes.rbegin(), arc.axes.rend());
    out.vertices.assign(arc.vertices.rbegin(), arc.vertices.rend());
    return out;
  }

  /// The first points of an arc as they are drawn.
  StraightEnd end_of(const Arc& arc, std::uint32_t node) const {
    const Node& end = graph_.nodes[node];
    if (!end.on_boundary) return {};
    if (end.degree() > 1) return {{place_of(end)}, 1};
    return straight_end({arc.points, arc.axes}, size_at_start(arc), rays_);
  }

  double size_at_start(const Arc& arc) const {
    // The first point of a line is in no cell if it sticks out; the second is inside.
    const std::size_t k = std::min<std::size_t>(1, arc.points.size() - 1);
    return sizes_.at(arc.points[k], arc.vertices.empty() ? -1 : arc.vertices[k]);
  }

  /// The place of an end of several lines, on the surface if it is near.
  Vector3 place_of(const Node& node) const {
    const SolidRays::Hit nearest = rays_.nearest(node.place);
    const Arc& arc = graph_.arcs[node.arcs.front()];
    return nearest.distance <= kMostMoved * size_at_start(arc) ? nearest.place : node.place;
  }

  static LineMark turning_mark(const Vector3& place, const DrawnLine& line) {
    LineMark mark{MarkShape::kTurningPoint, place, {}, kNoWall, line.length, Verdict::kMeshable, line.kind};
    double least = kNoWall;
    for (std::size_t k = 1; k < line.points.size(); ++k) {
      const Vector3 &from = line.points[k - 1], way = line.points[k] - from;
      const double length2 = dot(way, way);
      if (!(length2 > 0)) continue;
      const Vector3 on_line = from + std::clamp(dot(place - from, way) / length2, 0.0, 1.0) * way;
      const double distance = norm(on_line - place);
      if (!(distance < least)) continue;
      least = distance;
      mark.place = on_line;
      mark.direction = normalised(way);
      mark.wall = std::min(line.walls[k - 1], line.walls[k]);
    }
    return mark;
  }

  void add_marks_of(std::uint32_t number, DrawnLines& drawn) const {
    const Node& node = graph_.nodes[number];
    LineMark mark{MarkShape::kNode, node.place, {0, 0, 0}, kNoWall, kNoWall, node.verdict, LineKind::kThree};
    Vector3 outward{0, 0, 0};
    for (const std::uint32_t a : node.arcs) {
      const DrawnLine& line = drawn.lines[a];
      const std::size_t last = line.points.size() - 1;
      const bool is_first = graph_.arcs[a].nodes->front() == number;
      mark.wall = std::min(mark.wall, is_first ? line.walls.front() : line.walls.back());
      mark.length = std::min(mark.length, line.length);
      if (a == node.arcs.front()) mark.kind = line.kind;
      mark.place = is_first ? line.points.front() : line.points.back();
      outward = is_first ? line.points[0] - line.points[1] : line.points[last] - line.points[last - 1];
    }
    if (node.degree() > 1) drawn.marks.push_back(mark);
    if (!node.on_boundary) return;
    const SolidRays::Hit nearest = rays_.nearest(mark.place);
    mark.shape = MarkShape::kEnd;
    mark.direction = dot(nearest.normal, nearest.normal) > 0 ? nearest.normal : normalised(outward);
    drawn.marks.push_back(mark);
  }

  const SingularityGraph& graph_;
  SolidRays rays_;
  CellSizes sizes_;
};

}  // namespace

LineKind kind_of(const Arc& arc) {
  if (arc.verdict == Verdict::kNotMeshable) return LineKind::kImpossible;
  if (arc.verdict == Verdict::kUndecided) return LineKind::kUndecided;
  if (arc.index == 0.25) return LineKind::kThree;
  return arc.index == -0.25 ? LineKind::kFive : LineKind::kSix;
}

DrawnLines drawn_lines(const ShownField& field) {
  return LinesOfField(field).lines();
}

}  // namespace crossgrain
