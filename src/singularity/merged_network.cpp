// SPDX-License-Identifier: Apache-2.0
#include "singularity/merged_network.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/disjoint_sets.hpp"
#include "singularity/chains.hpp"
#include "singularity/crease_curves.hpp"
#include "singularity/touching_ends.hpp"

namespace crossgrain {
namespace {

using Ends = std::array<std::uint32_t, 2>;

/// Axis of rotation for the direction away from one of the edge's ends.
Vector3 axis_away_from(const SingularEdge& edge, std::uint32_t end) {
  return edge.ends[0] == end ? edge.turn.axis : -1.0 * edge.turn.axis;
}

/// Whether a line along an edge to one of its ends continues from `other_end` along the other edge: frames
/// rotate alike around both.
bool is_one_line(const SingularEdge& edge, std::uint32_t end, const SingularEdge& other,
                 std::uint32_t other_end) {
  return edge.turn.kind == other.turn.kind &&
         -dot(axis_away_from(edge, end), axis_away_from(other, other_end)) > 1 / std::numbers::sqrt2;
}

/// Largest length of a closed arc that is left out: where frames of neighbours differ by more than 45 degrees
/// the matching is ambiguous, and a wrong one produces a loop around its face.
constexpr double kLoopCells = 6;

/// Largest length of an arc from surface to surface that is left out where it stays within kHookReachCells of
/// one crease. Where the angle of solid at a crease passes 45, 135, 225 or 315 degrees, two numbers of
/// hexahedra cost alike, and the line between them runs along the crease, in and out of the first cells.
/// docs/notes/verdict.md has the sweep.
constexpr double kHookCells = 12, kHookReachCells = 1.5;

/// How near a crease an arc from surface to surface of at most SingularityTuning::merge_cells is left out
/// too: at a knife edge the tip has no room for lines across it.
constexpr double kTipReachCells = 3;

/// How far on grids the other end of a line that touches the surface may lie beside the direction of either.
constexpr double kTouchAsideCells = 1.5;

class Merger {
 public:
  Merger(const SingularEdges& singular, const SingularityTuning& options)
      : singular_(singular),
        creases_(singular.creases),
        options_(options),
        incident_(singular.points.size()),
        linked_(singular.points.size(), false),
        sets_(singular.points.size()) {
    for (std::uint32_t e = 0; e < singular.edges.size(); ++e)
      for (const std::uint32_t end : singular.edges[e].ends) incident_[end].push_back(e);
    for (const auto& [a, b] : singular.surface_edges) {
      if (!goes_on_over_surface(a, b)) continue;
      linked_[a] = linked_[b] = true;
      sets_.join(a, b);
      touches_ += singular.points[a].name < 0;
    }
  }

  MergedNetwork merge() {
    MergedNetwork network;
    network.touches = touches_;
    const std::vector<Chain> lines = lines_between_points();
    std::vector<const Chain*> kept, kept_after_all;
    const auto take_in = [&](const Chain& line) {
      for (const std::uint32_t point : line.vertices) sets_.join(point, line.vertices.front());
    };
    for (const Chain& line : lines) {
      if (is_mere_loop(line)) {
        ++network.unresolved_loops;
      } else if (is_stub(line)) {
        ++network.unresolved_stubs;
      } else if (is_part_of_a_node(line)) {
        take_in(line);
      } else {
        kept.push_back(&line);
      }
    }
    find_ends_on_boundary();
    // Arcs between nodes that were merged have become loops.
    for (const Chain* line : kept) {
      const bool is_loop =
          !line->is_closed() && sets_.root(line->vertices.front()) == sets_.root(line->vertices.back());
      if (is_loop && is_short_loop(*line))
        take_in(*line);
      else if (is_hook(*line))
        ++network.crease_hooks;
      else
        kept_after_all.push_back(line);
    }
    join(kept_after_all, network);
    return network;
  }

 private:
  std::vector<Chain> lines_between_points() const {
    std::vector<Ends> ends;
    for (const SingularEdge& edge : singular_.edges) ends.push_back(edge.ends);
    std::vector<std::uint8_t> goes_through(incident_.size());
    for (std::uint32_t p = 0; p < incident_.size(); ++p) {
      const auto& edges = incident_[p];
      goes_through[p] =
          edges.size() == 2 && (!singular_.points[p].on_boundary ||
                                is_one_line(singular_.edges[edges[0]], p, singular_.edges[edges[1]], p));
    }
    return chains(ends, goes_through);
  }

  /// Whether two ends, a pair of SingularEdges::surface_edges, belong to one line that leaves the tets or the
  /// leaves there.
  bool goes_on_over_surface(std::uint32_t a, std::uint32_t b) const {
    if (linked_[a] || linked_[b] || incident_[a].size() != 1 || incident_[b].size() != 1) return false;
    if (!is_one_line(singular_.edges[incident_[a][0]], a, singular_.edges[incident_[b][0]], b)) return false;
    const bool on_a_grid = singular_.points[a].name < 0;
    return !on_a_grid || (leads_to(a, b) && leads_to(b, a));
  }

  /// Whether the last edges of a line that ends at `end` point to `other`, as well as a staircase can.
  bool leads_to(std::uint32_t end, std::uint32_t other) const {
    constexpr int kLastEdges = 4;
    constexpr double kBehind = 0.5;
    std::uint32_t before = end, edge = incident_[end][0];
    for (int k = 0; k < kLastEdges; ++k) {
      const auto& ends = singular_.edges[edge].ends;
      before = ends[ends[0] == before];
      if (incident_[before].size() != 2) break;
      edge = incident_[before][incident_[before][0] == edge];
    }
    const SingularEdges::Point& from = singular_.points[end];
    const Vector3 direction = normalised(from.place - singular_.points[before].place);
    const Vector3 gap = (1 / from.cell_size) * (singular_.points[other].place - from.place);
    const double forward = dot(gap, direction);
    return forward >= -kBehind && norm(gap) <= kTouchCells &&
           norm(gap - forward * direction) <= kTouchAsideCells;
  }

  bool is_node(std::uint32_t point) const { return incident_[point].size() > 2; }

  double length_in_cells(const Chain& line) const {
    double cells = 0;
    for (const std::uint32_t e : line.edges) {
      const auto& [a, b] = singular_.edges[e].ends;
      const SingularEdges::Point &from = singular_.points[a], &to = singular_.points[b];
      cells += 2 * norm(to.place - from.place) / (from.cell_size + to.cell_size);
    }
    return cells;
  }

  bool is_short_loop(const Chain& line) const {
    return options_.merge_cells > 0 && length_in_cells(line) <= kLoopCells;
  }

  bool is_mere_loop(const Chain& line) const {
    return line.is_closed() && !is_node(line.vertices.front()) && is_short_loop(line);
  }

  /// Whether a line is shorter than two lines that it might be: third turns are two quarter turns that the
  /// cells do not separate.
  bool is_stub(const Chain& line) const {
    const bool is_between_surfaces =
        !line.is_closed() && !is_node(line.vertices.front()) && !is_node(line.vertices.back());
    return is_between_surfaces && length_in_cells(line) <= options_.merge_cells &&
           std::none_of(line.edges.begin(), line.edges.end(),
                        [&](std::uint32_t e) { return singular_.edges[e].turn.is_about_an_axis(); });
  }

  void find_ends_on_boundary() {
    reaches_surface_.assign(incident_.size(), false);
    for (std::uint32_t p = 0; p < incident_.size(); ++p)
      if (ends_on_boundary(p)) reaches_surface_[sets_.root(p)] = true;
  }

  /// Whether a short line from surface to surface keeps close to one crease.
  bool is_hook(const Chain& line) {
    const double length = length_in_cells(line);
    if (line.is_closed() || options_.merge_cells == 0 || length > kHookCells ||
        !reaches_surface_[sets_.root(line.vertices.front())] ||
        !reaches_surface_[sets_.root(line.vertices.back())])
      return false;
    std::vector<Vector3> places;
    double cell_size = 0;
    for (const std::uint32_t point : line.vertices) {
      places.push_back(singular_.points[point].place);
      cell_size = std::max(cell_size, singular_.points[point].cell_size);
    }
    const double reach = length <= options_.merge_cells ? kTipReachCells : kHookReachCells;
    return creases_.one_follows(places, reach * cell_size);
  }

  /// On tets the edges of a line reach the surface itself.
  bool is_end_on_a_grid(std::uint32_t point) const {
    return incident_[point].size() == 1 && singular_.points[point].name < 0;
  }

  bool is_part_of_a_node(const Chain& line) const {
    const std::uint32_t front = line.vertices.front(), back = line.vertices.back();
    if (!is_node(front) && !is_node(back)) return false;
    if (line.is_closed()) return is_short_loop(line);
    const bool ends_on_a_grid = is_end_on_a_grid(front) || is_end_on_a_grid(back);
    return length_in_cells(line) <= (ends_on_a_grid ? options_.end_cells : options_.merge_cells);
  }

  /// Joins the remaining lines at places where exactly two of them meet.
  void join(const std::vector<const Chain*>& lines, MergedNetwork& network) {
    std::vector<std::uint32_t>& place_of = network.place_of;
    place_of.resize(singular_.points.size());
    const auto add_place = [&](std::uint32_t point) {
      place_of[point] = static_cast<std::uint32_t>(network.places.size());
      network.places.push_back({{}, false});
    };
    for (std::uint32_t p = 0; p < place_of.size(); ++p) {
      if (sets_.root(p) == p) add_place(p);
    }
    for (std::uint32_t p = 0; p < place_of.size(); ++p) {
      place_of[p] = place_of[sets_.root(p)];
      network.places[place_of[p]].points.push_back(p);
    }
    std::vector<Ends> ends;
    std::vector<std::uint32_t> degrees(network.places.size(), 0);
    for (const Chain* line : lines) {
      ends.push_back({place_of[line->vertices.front()], place_of[line->vertices.back()]});
      for (const std::uint32_t end : ends.back()) ++degrees[end];
    }
    std::vector<std::uint8_t> goes_through(network.places.size(), 0);
    for (std::size_t k = 0; k < network.places.size(); ++k) {
      MergedNetwork::Place& place = network.places[k];
      // At a place with one line, another one continues to the surface without an edge.
      place.on_boundary =
          degrees[k] == 1 || std::any_of(place.points.begin(), place.points.end(),
                                         [&](std::uint32_t p) { return ends_on_boundary(p); });
      goes_through[k] = degrees[k] == 2 && !place.on_boundary;
    }
    for (const Chain& chain : chains(ends, goes_through))
      network.arcs.push_back(arc_of(chain, lines, place_of, goes_through[chain.vertices.front()] != 0));
  }

  /// Whether a line ends on the surface at this point, rather than touching it.
  bool ends_on_boundary(std::uint32_t p) const {
    const auto& edges = incident_[p];
    return singular_.points[p].on_boundary && !linked_[p] &&
           !(edges.size() == 2 && is_one_line(singular_.edges[edges[0]], p, singular_.edges[edges[1]], p));
  }

  MergedNetwork::Arc arc_of(const Chain& chain, const std::vector<const Chain*>& lines,
                            const std::vector<std::uint32_t>& place_of, bool closed) const {
    MergedNetwork::Arc arc{{chain.vertices.front()}, {}, closed};
    for (std::size_t k = 0; k < chain.edges.size(); ++k) {
      const Chain& line = *lines[chain.edges[k]];
      // A line from a place to itself keeps its direction.
      const bool forward = place_of[line.vertices.front()] == chain.vertices[k];
      for (std::size_t i = 0; i < line.edges.size(); ++i) {
        const std::size_t last = line.edges.size() - 1;
        arc.edges.push_back(line.edges[forward ? i : last - i]);
        arc.places.push_back(place_of[line.vertices[forward ? i + 1 : last - i]]);
      }
    }
    return arc;
  }

  const SingularEdges& singular_;
  const CreaseCurves creases_;
  const SingularityTuning& options_;
  std::vector<std::vector<std::uint32_t>> incident_;  ///< edges at each point
  std::vector<bool> linked_;                          ///< ends from which a line continues over the surface
  std::size_t touches_ = 0;                           ///< pairs of these on a grid
  DisjointSets sets_;                                 ///< sets of points that are one place
  std::vector<bool> reaches_surface_;                 ///< by root: whether a line ends on the surface there
};

}  // namespace

MergedNetwork merged(const SingularEdges& singular, const SingularityTuning& options) {
  return Merger(singular, options).merge();
}

}  // namespace crossgrain
