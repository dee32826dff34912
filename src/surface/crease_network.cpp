// SPDX-License-Identifier: Apache-2.0
#include "surface/crease_network.hpp"

#include <algorithm>
#include <functional>
#include <numbers>
#include <queue>
#include <utility>

namespace crossgrain {
namespace {

struct Strand {
  std::vector<std::uint32_t> edges;
  std::array<std::uint32_t, 2> ends;
  double radii = 0;
  double turn_rad = 0;  ///< the largest
  bool is_removed = false;
};

/// Strands between points where other than two edges meet. Closed ones without such a point are not in it.
class Strands {
 public:
  Strands(std::span<const SharpEdge> edges, std::span<const std::uint32_t> holding,
          const FadingCreases& fading)
      : edges_(edges),
        radii_(fading.least_radii),
        sure_rad_(fading.sure_deg * std::numbers::pi / 180),
        counts_(edges.size(), 1) {
    for (const SharpEdge& edge : edges)
      vertices_.insert(vertices_.end(), edge.vertices.begin(), edge.vertices.end());
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    edges_at_.resize(vertices_.size());
    strands_at_.resize(vertices_.size());
    holds_.resize(vertices_.size());
    for (std::uint32_t e = 0; e < edges.size(); ++e)
      for (const std::uint32_t v : edges[e].vertices) edges_at_[place(v)].push_back(e);
    for (const std::uint32_t v : holding) {
      if (std::binary_search(vertices_.begin(), vertices_.end(), v)) holds_[place(v)] = true;
    }
    find_strands();
  }

  std::vector<OpenStrand> open() const {
    std::vector<OpenStrand> result;
    for (const Strand& strand : strands_) {
      std::vector<std::uint32_t> edges = strand.edges;
      const std::uint32_t low = std::min(strand.ends[0], strand.ends[1]);
      const std::uint32_t end = is_open(low) ? low : std::max(strand.ends[0], strand.ends[1]);
      if (!is_open(end)) continue;
      if (end != strand.ends[0]) std::reverse(edges.begin(), edges.end());
      result.push_back({std::move(edges), vertices_[end]});
    }
    return result;
  }

  std::vector<std::uint8_t> without_fading() {
    while (!weakest_.empty()) {
      const std::uint32_t s = weakest_.top().second;
      weakest_.pop();
      if (!strands_[s].is_removed && does_not_count(strands_[s])) remove(s);
    }
    return std::move(counts_);
  }

 private:
  std::uint32_t place(std::uint32_t vertex) const {
    return static_cast<std::uint32_t>(std::lower_bound(vertices_.begin(), vertices_.end(), vertex) -
                                      vertices_.begin());
  }

  bool is_open(std::uint32_t at) const { return strands_at_[at].size() == 1 && !holds_[at]; }

  bool is_passed(std::uint32_t at) const { return edges_at_[at].size() == 2 && !holds_[at]; }

  std::uint32_t far_end(std::uint32_t edge, std::uint32_t at) const {
    const auto& [a, b] = edges_[edge].vertices;
    return place(vertices_[at] == a ? b : a);
  }

  void find_strands() {
    std::vector<std::uint8_t> used(edges_.size(), 0);
    for (std::uint32_t start = 0; start < vertices_.size(); ++start) {
      if (is_passed(start)) continue;
      for (const std::uint32_t first : edges_at_[start]) {
        if (used[first]) continue;
        Strand strand{{first}, {start, far_end(first, start)}};
        used[first] = 1;
        while (is_passed(strand.ends[1])) {
          const auto& both = edges_at_[strand.ends[1]];
          const std::uint32_t next = both[0] == strand.edges.back() ? both[1] : both[0];
          used[next] = 1;
          strand.edges.push_back(next);
          strand.ends[1] = far_end(next, strand.ends[1]);
        }
        add(std::move(strand));
      }
    }
    for (std::uint32_t s = 0; s < strands_.size(); ++s) consider(s);
  }

  void add(Strand strand) {
    for (const std::uint32_t e : strand.edges) {
      strand.radii += edges_[e].radii;
      strand.turn_rad = std::max(strand.turn_rad, edges_[e].turn_rad);
    }
    for (const std::uint32_t end : strand.ends)
      strands_at_[end].push_back(static_cast<std::uint32_t>(strands_.size()));
    strands_.push_back(std::move(strand));
  }

  bool does_not_count(const Strand& strand) const {
    const bool fades = is_open(strand.ends[0]) || is_open(strand.ends[1]);
    return fades && strand.turn_rad < sure_rad_ && strand.radii < radii_;
  }

  void consider(std::uint32_t s) {
    if (does_not_count(strands_[s])) weakest_.emplace(strands_[s].radii, s);
  }

  void take_out(std::uint32_t s) {
    strands_[s].is_removed = true;
    for (const std::uint32_t end : strands_[s].ends) std::erase(strands_at_[end], s);
  }

  void remove(std::uint32_t s) {
    take_out(s);
    for (const std::uint32_t e : strands_[s].edges) counts_[e] = 0;
    for (const std::uint32_t end : std::array(strands_[s].ends)) {
      if (holds_[end]) continue;
      if (strands_at_[end].size() == 2) join_at(end);
      if (strands_at_[end].size() == 1) consider(strands_at_[end][0]);
    }
  }

  /// Joins the two strands that end here, unless both ends are of one, which then is closed.
  void join_at(std::uint32_t at) {
    const std::uint32_t a = strands_at_[at][0], b = strands_at_[at][1];
    if (a == b) return;
    const auto other_end = [&](std::uint32_t s) {
      return strands_[s].ends[0] == at ? strands_[s].ends[1] : strands_[s].ends[0];
    };
    Strand joined{strands_[a].edges, {other_end(a), other_end(b)}};
    joined.edges.insert(joined.edges.end(), strands_[b].edges.begin(), strands_[b].edges.end());
    take_out(a);
    take_out(b);
    add(std::move(joined));
    consider(static_cast<std::uint32_t>(strands_.size() - 1));
  }

  std::span<const SharpEdge> edges_;
  double radii_, sure_rad_;
  std::vector<std::uint8_t> counts_;     ///< per edge
  std::vector<std::uint32_t> vertices_;  ///< of sharp edges, ascending; elsewhere by their places in it
  std::vector<std::vector<std::uint32_t>> edges_at_, strands_at_;
  std::vector<bool> holds_;
  std::vector<Strand> strands_;

  /// Strands that fade out, and may be removed or joined by now, by their radii.
  using Weak = std::pair<double, std::uint32_t>;
  std::priority_queue<Weak, std::vector<Weak>, std::greater<>> weakest_;
};

}  // namespace

double length_in_radii(double turn_rad, double length, double area) {
  return area > 0 ? turn_rad * 1.5 * length * length / area : 0;
}

std::vector<std::uint8_t> are_creases(std::span<const SharpEdge> edges,
                                      std::span<const std::uint32_t> holding, const FadingCreases& fading) {
  return Strands(edges, holding, fading).without_fading();
}

std::vector<OpenStrand> open_strands(std::span<const SharpEdge> edges,
                                     std::span<const std::uint32_t> holding) {
  return Strands(edges, holding, {}).open();
}

}  // namespace crossgrain
