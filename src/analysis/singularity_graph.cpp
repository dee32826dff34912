// SPDX-License-Identifier: Apache-2.0
#include "analysis/singularity_graph.hpp"

#include <algorithm>

namespace crossgrain {
namespace {

class EdgeNetwork {
 public:
  explicit EdgeNetwork(std::span<const GridEdge> edges) : used_(edges.size(), false) {
    std::vector<GridEdge> sorted(edges.begin(), edges.end());
    std::sort(sorted.begin(), sorted.end(), [](const GridEdge& a, const GridEdge& b) {
      return a.start != b.start ? a.start < b.start : a.axis < b.axis;
    });
    for (const GridEdge& edge : sorted) {
      vertices_.push_back(edge.start);
      vertices_.push_back(edge.end());
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    incident_.resize(vertices_.size());
    odd_.resize(vertices_.size(), false);
    for (const GridEdge& edge : sorted) {
      const std::size_t low = index_of(edge.start), high = index_of(edge.end());
      incident_[low].push_back(ends_.size());
      incident_[high].push_back(ends_.size());
      ends_.push_back({low, high});
      odd_[low] = odd_[low] != edge.turn.is_odd();
      odd_[high] = odd_[high] != edge.turn.is_odd();
    }
  }

  SingularityGraph arcs_and_nodes() {
    SingularityGraph graph;
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      if (degree(v) == 1 || odd_[v]) graph.boundary_ends.push_back(vertices_[v]);
      if (degree(v) >= 3) graph.nodes.push_back(vertices_[v]);
      if (degree(v) != 2) trace_all_from(v, graph);
    }
    // What is left are closed loops.
    for (std::size_t v = 0; v < vertices_.size(); ++v) trace_all_from(v, graph);
    return graph;
  }

 private:
  std::size_t index_of(const GridPoint& point) const {
    return static_cast<std::size_t>(std::lower_bound(vertices_.begin(), vertices_.end(), point) -
                                    vertices_.begin());
  }

  std::size_t degree(std::size_t vertex) const { return incident_[vertex].size(); }

  void trace_all_from(std::size_t vertex, SingularityGraph& graph) {
    for (const std::size_t edge : incident_[vertex]) {
      if (!used_[edge]) graph.arcs.push_back(traced(vertex, edge));
    }
  }

  /// The chain that leaves `vertex` through `edge`.
  std::vector<GridPoint> traced(std::size_t vertex, std::size_t edge) {
    std::vector<GridPoint> arc{vertices_[vertex]};
    while (!used_[edge]) {
      used_[edge] = true;
      vertex = ends_[edge][0] == vertex ? ends_[edge][1] : ends_[edge][0];
      arc.push_back(vertices_[vertex]);
      if (degree(vertex) != 2) break;
      edge = incident_[vertex][0] == edge ? incident_[vertex][1] : incident_[vertex][0];
    }
    return arc;
  }

  std::vector<GridPoint> vertices_;                 ///< sorted
  std::vector<std::vector<std::size_t>> incident_;  ///< edges at each vertex
  std::vector<std::array<std::size_t, 2>> ends_;    ///< vertices of each edge
  std::vector<bool> odd_;                           ///< vertices with an odd number of odd edges
  std::vector<bool> used_;                          ///< edges that are part of an arc
};

}  // namespace

SingularityGraph joined(std::span<const GridEdge> edges, double unit) {
  SingularityGraph graph = EdgeNetwork(edges).arcs_and_nodes();
  graph.edges = edges.size();
  std::int64_t length = 0;
  for (const GridEdge& edge : edges) length += edge.length;
  graph.length = static_cast<double>(length) * unit;
  return graph;
}

SingularityGraph singularity_graph(const Octree& tree, std::span<const StoredQuaternion> frames,
                                   std::span<const std::uint8_t> open_faces,
                                   std::span<const std::uint8_t> owners) {
  return joined(singular_edges(tree, frames, open_faces, owners), tree.root().unit());
}

}  // namespace crossgrain
