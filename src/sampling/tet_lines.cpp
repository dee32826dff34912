// SPDX-License-Identifier: Apache-2.0
#include "sampling/tet_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/ascending.hpp"
#include "base/parallel.hpp"
#include "sampling/frame_blend.hpp"
#include "sampling/tube_entry.hpp"
#include "singularity/tet_matchings.hpp"

namespace crossgrain {
namespace {

double mean_edge(const std::array<std::uint32_t, 4>& tet, const std::vector<Vector3>& vertices) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) sum += norm(vertices[tet[i]] - vertices[tet[j]]);
  return sum / 6;
}

}  // namespace

TetLines::TetLines(const FramesOnTets& field, double arc_distance_cells)
    : field_(field), walk_(field.solid), sizes_(field.solid.mesh.tets.size()) {
  const TetMesh& mesh = field.solid.mesh;
  parallel_for(sizes_.size(), [&](std::size_t t) { sizes_[t] = mean_edge(mesh.tets[t], mesh.vertices); });
  if (arc_distance_cells > 0) add_tubes(arc_distance_cells);
}

double TetLines::volume() const {
  const TetMesh& mesh = field_.solid.mesh;
  double sum = 0;
  for (const auto& tet : mesh.tets) {
    const Vector3& a = mesh.vertices[tet[0]];
    sum += dot(cross(mesh.vertices[tet[1]] - a, mesh.vertices[tet[2]] - a), mesh.vertices[tet[3]] - a) / 6;
  }
  return sum;
}

void TetLines::add_tubes(double arc_distance_cells) {
  const TetMesh& mesh = field_.solid.mesh;
  using Edge = std::array<std::uint32_t, 2>;
  const SingularEdges singular = singular_tet_edges(field_.solid, field_.tet_frames, field_.matchings);
  std::vector<Edge> edges;
  std::vector<std::uint8_t> is_end(mesh.vertices.size(), 0);
  for (const SingularEdge& edge : singular.edges) {
    Edge ends{static_cast<std::uint32_t>(singular.points[edge.ends[0]].name),
              static_cast<std::uint32_t>(singular.points[edge.ends[1]].name)};
    std::sort(ends.begin(), ends.end());
    edges.push_back(ends);
    is_end[ends[0]] = is_end[ends[1]] = 1;
  }
  std::sort(edges.begin(), edges.end());
  // The smallest tet at an edge: one edge may be much longer than the tets are wide.
  std::vector<double> sizes(edges.size(), std::numeric_limits<double>::infinity());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Edge ends{std::min(mesh.tets[t][i], mesh.tets[t][j]),
                        std::max(mesh.tets[t][i], mesh.tets[t][j])};
        if (!is_end[ends[0]] || !is_end[ends[1]]) continue;
        const auto at = std::lower_bound(edges.begin(), edges.end(), ends);
        if (at == edges.end() || *at != ends) continue;
        double& size = sizes[static_cast<std::size_t>(at - edges.begin())];
        size = std::min(size, sizes_[t]);
      }
    }
  }
  for (std::uint32_t k = 0; k < edges.size(); ++k) {
    const Tube tube{mesh.vertices[edges[k][0]], mesh.vertices[edges[k][1]], arc_distance_cells * sizes[k]};
    tubes_.push_back(tube);
    Box box = empty_box();
    for (const Vector3& end : {tube.from, tube.to}) {
      include(box, end - Vector3{tube.radius, tube.radius, tube.radius});
      include(box, end + Vector3{tube.radius, tube.radius, tube.radius});
    }
    walk_.finder().for_near(box, [&](std::uint32_t tet) { tubes_at_tets_.push_back({tet, k}); });
  }
  sort_uniquely(tubes_at_tets_);
}

double TetLines::share_to_tube(std::uint32_t tet, const Vector3& from, const Vector3& to) const {
  double least = 1;
  for (auto at = std::lower_bound(tubes_at_tets_.begin(), tubes_at_tets_.end(), TubeAtTet{tet, 0});
       at != tubes_at_tets_.end() && at->tet == tet; ++at) {
    const Tube& tube = tubes_[at->tube];
    const auto distance = [&](double share) {
      return distance_to_segment(from + share * (to - from), tube.from, tube.to);
    };
    if (distance(0) > tube.radius + norm(to - from)) continue;
    least = std::min(least, tube_entry(distance, tube.radius));
  }
  return least;
}

bool TetLines::is_at_arc(const LinePlace& place) const {
  return share_to_tube(place.cell, place.point, place.point) < 1;
}

Quaternion TetLines::frame_at(const LinePlace& from, const Vector3& to, LineCell& end) const {
  const TetWalk::End way = walk_.walk(from.cell, from.point, to, [](std::uint32_t) {});
  end = way.tet;
  const Vector3 place = way.share < 1 ? from.point + way.share * (to - from.point) : to;
  const std::array<double, 4> weights = walk_.weights(way.tet, place);
  const auto& corners = field_.solid.mesh.tets[way.tet];
  std::array<BlendTerm, 4> terms;
  std::size_t nearest = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    terms[k] = {field_.vertex_frames[corners[k]], {0, 0, 0}, std::max(weights[k], 0.0)};
    if (weights[k] > weights[nearest]) nearest = k;
  }
  const FrameBlend blend{terms, terms[nearest]};
  Quaternion frame;
  blend_frames({&blend, 1}, {&frame, 1});
  return frame;
}

LineStop TetLines::first_stop(const LinePlace& from, const Vector3& to) const {
  LineStop stop;
  const auto enter = [&](std::uint32_t tet) {
    stop.at(share_to_tube(tet, from.point, to), StreamlineEnd::kSingularArc);
  };
  enter(from.cell);
  const TetWalk::End way = walk_.walk(from.cell, from.point, to, enter);
  stop.at(way.share, StreamlineEnd::kBoundary);
  stop.cell = way.tet;
  return stop;
}

CellNames TetLines::names_of_vertices() const {
  const auto& vertices = field_.solid.mesh.vertices;
  std::vector<FrameLink> links;
  links.reserve(field_.edges.size());
  for (const StiffnessEdge& edge : field_.edges) {
    const double length = norm(vertices[edge.j] - vertices[edge.i]);
    // The area of the dual face; obtuse tets may have none.
    links.push_back({edge.i, edge.j, length, std::max(edge.weight, 0.0) * length});
  }
  std::vector<std::uint8_t> is_outer(vertices.size(), 0);
  for (const auto& face : field_.solid.boundary)
    for (const std::uint32_t v : face) is_outer[v] = 1;
  return CellNames({field_.vertex_frames.begin(), field_.vertex_frames.end()}, links, is_outer);
}

AxisNames TetLines::names_at(const LinePlace& place, const Quaternion& frame) const {
  std::call_once(names_once_, [&] { names_.emplace(names_of_vertices()); });
  const std::array<double, 4> weights = walk_.weights(place.cell, place.point);
  const auto nearest = std::max_element(weights.begin(), weights.end()) - weights.begin();
  return names_->at(field_.solid.mesh.tets[place.cell][static_cast<std::size_t>(nearest)], frame);
}

}  // namespace crossgrain
