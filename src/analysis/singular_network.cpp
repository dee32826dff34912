// SPDX-License-Identifier: Apache-2.0
#include "analysis/singular_network.hpp"

#include <algorithm>
#include <cstddef>

namespace crossgrain {
namespace {

class Chainer {
 public:
  explicit Chainer(const SingularEdges& singular)
      : singular_(singular), incident_(singular.points.size()), used_(singular.edges.size(), false) {
    for (std::uint32_t e = 0; e < singular.edges.size(); ++e)
      for (const std::uint32_t end : singular.edges[e].ends) incident_[end].push_back(e);
    // By the other end, which no two edges share.
    for (std::uint32_t point = 0; point < incident_.size(); ++point)
      std::sort(incident_[point].begin(), incident_[point].end(),
                [&](std::uint32_t a, std::uint32_t b) { return other_end(a, point) < other_end(b, point); });
  }

  SingularNetwork chain() {
    SingularNetwork network;
    for (const auto& edges : incident_) network.degrees.push_back(static_cast<std::uint32_t>(edges.size()));
    for (std::uint32_t p = 0; p < incident_.size(); ++p) {
      if (!goes_through(p)) trace_all_from(p, network);
    }
    // What is left are closed loops.
    for (std::uint32_t p = 0; p < incident_.size(); ++p) trace_all_from(p, network);
    return network;
  }

 private:
  bool goes_through(std::uint32_t point) const {
    return incident_[point].size() == 2 && !singular_.points[point].on_boundary;
  }

  std::uint32_t other_end(std::uint32_t edge, std::uint32_t point) const {
    const auto& ends = singular_.edges[edge].ends;
    return ends[0] == point ? ends[1] : ends[0];
  }

  void trace_all_from(std::uint32_t point, SingularNetwork& network) {
    for (const std::uint32_t edge : incident_[point]) {
      if (!used_[edge]) network.arcs.push_back(traced(point, edge));
    }
  }

  /// The chain that leaves `point` through `edge`.
  SingularNetwork::Arc traced(std::uint32_t point, std::uint32_t edge) {
    SingularNetwork::Arc arc{{point}, {}};
    while (!used_[edge]) {
      used_[edge] = true;
      point = other_end(edge, point);
      arc.points.push_back(point);
      arc.edges.push_back(edge);
      if (!goes_through(point)) break;
      edge = incident_[point][0] == edge ? incident_[point][1] : incident_[point][0];
    }
    return arc;
  }

  const SingularEdges& singular_;
  std::vector<std::vector<std::uint32_t>> incident_;  ///< edges at each point
  std::vector<bool> used_;                            ///< edges that are part of an arc
};

}  // namespace

SingularNetwork chained(const SingularEdges& singular) {
  return Chainer(singular).chain();
}

}  // namespace crossgrain
