// SPDX-License-Identifier: Apache-2.0
#include "singularity/chains.hpp"

#include <algorithm>
#include <cassert>

namespace crossgrain {
namespace {

class Chainer {
 public:
  Chainer(std::span<const std::array<std::uint32_t, 2>> edges, std::span<const std::uint8_t> goes_through)
      : edges_(edges),
        goes_through_(goes_through),
        incident_(goes_through.size()),
        used_(edges.size(), false) {
    for (std::uint32_t e = 0; e < edges.size(); ++e)
      for (const std::uint32_t end : edges[e]) incident_[end].push_back(e);
    for (std::uint32_t v = 0; v < incident_.size(); ++v) {
      assert(!goes_through[v] || incident_[v].size() == 2);
      std::sort(incident_[v].begin(), incident_[v].end(), [&](std::uint32_t a, std::uint32_t b) {
        const std::uint32_t end_a = other_end(a, v), end_b = other_end(b, v);
        return end_a != end_b ? end_a < end_b : a < b;
      });
    }
  }

  std::vector<Chain> all() {
    std::vector<Chain> found;
    for (std::uint32_t v = 0; v < incident_.size(); ++v) {
      if (!goes_through_[v]) trace_all_from(v, found);
    }
    // The remaining chains are closed.
    for (std::uint32_t v = 0; v < incident_.size(); ++v) trace_all_from(v, found);
    return found;
  }

 private:
  std::uint32_t other_end(std::uint32_t edge, std::uint32_t vertex) const {
    return edges_[edge][0] == vertex ? edges_[edge][1] : edges_[edge][0];
  }

  void trace_all_from(std::uint32_t vertex, std::vector<Chain>& found) {
    for (const std::uint32_t edge : incident_[vertex]) {
      if (!used_[edge]) found.push_back(traced(vertex, edge));
    }
  }

  Chain traced(std::uint32_t vertex, std::uint32_t edge) {
    Chain chain{{vertex}, {}};
    while (!used_[edge]) {
      used_[edge] = true;
      vertex = other_end(edge, vertex);
      chain.vertices.push_back(vertex);
      chain.edges.push_back(edge);
      if (!goes_through_[vertex]) break;
      edge = incident_[vertex][0] == edge ? incident_[vertex][1] : incident_[vertex][0];
    }
    return chain;
  }

  std::span<const std::array<std::uint32_t, 2>> edges_;
  std::span<const std::uint8_t> goes_through_;
  std::vector<std::vector<std::uint32_t>> incident_;  ///< edges at each vertex
  std::vector<bool> used_;                            ///< edges that are part of a chain
};

}  // namespace

std::vector<Chain> chains(std::span<const std::array<std::uint32_t, 2>> edges,
                          std::span<const std::uint8_t> goes_through) {
  return Chainer(edges, goes_through).all();
}

}  // namespace crossgrain
