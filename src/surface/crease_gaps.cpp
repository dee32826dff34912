// SPDX-License-Identifier: Apache-2.0
#include "surface/crease_gaps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <queue>
#include <utility>

#include "base/degree.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Bends, angles and lengths that differ by less are equal, so that rounding decides nothing in a rotated
/// model.
constexpr double kEqual = 1e-9;

/// Sharp edges between two nodes, with the gaps in them that are closed.
struct Run {
  double sharp = 0, gaps = 0;      ///< lengths
  double radii = 0, turn_rad = 0;  ///< in sum, and the largest
  std::array<std::uint32_t, 2> ends;
};

struct Gap {
  std::vector<std::uint32_t> edges;
  std::uint32_t end;
  double length;
};

class GapCloser {
 public:
  GapCloser(std::vector<SharpEdge> edges, const std::vector<Vector3>& vertices,
            std::span<const std::uint32_t> holding, const CreaseAngles& angles)
      : edges_(std::move(edges)),
        at_(vertices),
        gaps_(angles.gaps),
        sure_rad_(angles.fading.sure_deg * kDegree),
        straight_(std::cos(kCornerDeg * kDegree)) {
    const double least_rad = angles.least_deg * kDegree;
    for (const SharpEdge& edge : edges_) is_sharp_.push_back(edge.turn_rad > least_rad);
    list_spokes();
    holds_.resize(vertices.size());
    for (const std::uint32_t v : holding) holds_[v] = 1;
    passed_.assign(vertices.size(), 0);
    run_of_.assign(edges_.size(), kNone);
  }

  std::vector<SharpEdge> closed() {
    find_runs();
    while (!waiting_.empty()) {
      const std::uint32_t end = waiting_.top().second;
      waiting_.pop();
      if (!is_open_end(end)) continue;
      if (const std::optional<Gap> gap = gap_from(end)) close(end, *gap);
    }
    std::vector<SharpEdge> result;
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (is_sharp_[e]) result.push_back(edges_[e]);
    return result;
  }

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  void list_spokes() {
    begin_.assign(at_.size() + 1, 0);
    sharp_at_.assign(at_.size(), 0);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      for (const std::uint32_t v : edges_[e].vertices) {
        ++begin_[v + 1];
        sharp_at_[v] += is_sharp_[e];
      }
    }
    for (std::size_t v = 0; v < at_.size(); ++v) begin_[v + 1] += begin_[v];
    spokes_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
      for (const std::uint32_t v : edges_[e].vertices) spokes_[next[v]++] = e;
  }

  std::span<const std::uint32_t> edges_at(std::uint32_t vertex) const {
    return std::span(spokes_).subspan(begin_[vertex], begin_[vertex + 1] - begin_[vertex]);
  }

  std::uint32_t other_end(std::uint32_t edge, std::uint32_t vertex) const {
    const auto& [a, b] = edges_[edge].vertices;
    return a == vertex ? b : a;
  }

  double length_of(std::uint32_t edge) const {
    const auto& [a, b] = edges_[edge].vertices;
    return norm(at_[b] - at_[a]);
  }

  Vector3 direction(std::uint32_t from, std::uint32_t to) const { return normalised(at_[to] - at_[from]); }

  bool is_open_end(std::uint32_t vertex) const { return sharp_at_[vertex] == 1 && !holds_[vertex]; }

  /// The first sharp edge at a vertex other than this one.
  std::uint32_t sharp_edge_at(std::uint32_t vertex, std::uint32_t other_than = kNone) const {
    for (const std::uint32_t e : edges_at(vertex))
      if (is_sharp_[e] && e != other_than) return e;
    return kNone;
  }

  void find_runs() {
    for (std::uint32_t start = 0; start < at_.size(); ++start) {
      if (!is_open_end(start)) continue;
      std::uint32_t edge = sharp_edge_at(start), end = start;
      if (run_of_[edge] == kNone) {
        Run run{0, 0, 0, 0, {start, start}};
        while (edge != kNone && run_of_[edge] == kNone) {
          checkpoint_.pass();
          run_of_[edge] = static_cast<std::uint32_t>(runs_.size());
          run.sharp += length_of(edge);
          run.radii += edges_[edge].radii;
          run.turn_rad = std::max(run.turn_rad, edges_[edge].turn_rad);
          end = other_end(edge, end);
          edge = sharp_at_[end] == 2 && !holds_[end] ? sharp_edge_at(end, edge) : kNone;
        }
        run.ends[1] = end;
        parent_.push_back(static_cast<std::uint32_t>(runs_.size()));
        runs_.push_back(run);
      }
      wait(start);
    }
  }

  std::uint32_t root(std::uint32_t run) {
    while (parent_[run] != run) run = parent_[run] = parent_[parent_[run]];
    return run;
  }

  void wait(std::uint32_t end) {
    if (const std::optional<Gap> gap = gap_from(end)) waiting_.emplace(gap->length, end);
  }

  /// The edge that goes straight on, kNone if none does.
  std::uint32_t next_edge(std::uint32_t before, std::uint32_t vertex) const {
    const Vector3 on = direction(before, vertex);
    std::uint32_t best = kNone;
    double best_cosine = straight_;
    for (const std::uint32_t e : edges_at(vertex)) {
      const std::uint32_t to = other_end(e, vertex);
      if (is_sharp_[e] || to == before) continue;
      const double cosine = dot(on, direction(vertex, to));
      if (cosine < best_cosine - kEqual || (best == kNone && cosine <= straight_)) continue;
      if (best != kNone && cosine <= best_cosine + kEqual && !is_preferred(e, best, vertex)) continue;
      best = e;
      best_cosine = cosine;
    }
    return best;
  }

  /// Which of two edges that bend alike.
  bool is_preferred(std::uint32_t edge, std::uint32_t to, std::uint32_t vertex) const {
    const double difference = edges_[edge].turn_rad - edges_[to].turn_rad;
    if (std::abs(difference) > kEqual) return difference > 0;
    return other_end(edge, vertex) < other_end(to, vertex);
  }

  std::optional<Gap> gap_from(std::uint32_t end) {
    const std::uint32_t first = sharp_edge_at(end), run = root(run_of_[first]);
    if (runs_[run].radii < gaps_.least_radii && runs_[run].turn_rad < sure_rad_) return std::nullopt;
    const double room = gaps_.longest * runs_[run].sharp - runs_[run].gaps;
    Gap gap{{}, end, 0};
    std::uint32_t before = other_end(first, end);
    passed_[end] = ++walks_;
    for (;;) {
      checkpoint_.pass();
      const std::uint32_t edge = next_edge(before, gap.end);
      if (edge == kNone) return std::nullopt;
      gap.edges.push_back(edge);
      gap.length += length_of(edge);
      before = gap.end;
      gap.end = other_end(edge, before);
      if (gap.length > (1 + kEqual) * room || passed_[gap.end] == walks_) return std::nullopt;
      passed_[gap.end] = walks_;
      if (holds_[gap.end]) return gap;
      if (sharp_at_[gap.end] > 0) return leads_on(run, before, gap.end) ? std::optional(gap) : std::nullopt;
    }
  }

  /// Whether the path from the vertex before may end here: not in the middle of the run that it continues,
  /// nor where it would bend at the end of another.
  bool leads_on(std::uint32_t run, std::uint32_t before, std::uint32_t vertex) {
    const std::uint32_t edge = sharp_edge_at(vertex);
    if (is_open_end(vertex) &&
        dot(direction(before, vertex), direction(vertex, other_end(edge, vertex))) <= straight_)
      return false;
    if (vertex == runs_[run].ends[0] || vertex == runs_[run].ends[1]) return true;
    return run_of_[edge] == kNone || root(run_of_[edge]) != run;
  }

  void close(std::uint32_t start, const Gap& gap) {
    const std::uint32_t run = root(run_of_[sharp_edge_at(start)]);
    const bool joins = is_open_end(gap.end);
    const std::uint32_t other = joins ? root(run_of_[sharp_edge_at(gap.end)]) : run;
    for (const std::uint32_t e : gap.edges) {
      is_sharp_[e] = 1;
      run_of_[e] = run;
      for (const std::uint32_t v : edges_[e].vertices) ++sharp_at_[v];
    }
    runs_[run].gaps += gap.length;
    if (other == run) return;
    parent_[other] = run;
    const auto far_end = [&](std::uint32_t r, std::uint32_t near) {
      return runs_[r].ends[0] == near ? runs_[r].ends[1] : runs_[r].ends[0];
    };
    runs_[run].ends = {far_end(run, start), far_end(other, gap.end)};
    runs_[run].sharp += runs_[other].sharp;
    runs_[run].radii += runs_[other].radii;
    runs_[run].turn_rad = std::max(runs_[run].turn_rad, runs_[other].turn_rad);
    runs_[run].gaps += runs_[other].gaps;
    for (const std::uint32_t end : std::array(runs_[run].ends))
      if (is_open_end(end)) wait(end);
  }

  std::vector<SharpEdge> edges_;
  const std::vector<Vector3>& at_;
  CreaseGaps gaps_;
  double sure_rad_, straight_;
  std::vector<std::uint8_t> is_sharp_, holds_;
  std::vector<std::uint32_t> begin_, spokes_, sharp_at_;  ///< edges at each vertex
  std::vector<std::uint32_t> passed_;                     ///< the last walk through each vertex
  std::uint32_t walks_ = 0;
  Checkpoint checkpoint_;
  std::vector<std::uint32_t> run_of_, parent_;
  std::vector<Run> runs_;

  using Waiting = std::pair<double, std::uint32_t>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting_;
};

}  // namespace

double least_turn_in_gaps(const CreaseAngles& angles) {
  return angles.gaps.share * angles.least_deg * kDegree;
}

std::vector<SharpEdge> with_closed_gaps(std::vector<SharpEdge> edges, const std::vector<Vector3>& vertices,
                                        std::span<const std::uint32_t> holding, const CreaseAngles& angles) {
  if (edges.empty()) return edges;
  return GapCloser(std::move(edges), vertices, holding, angles).closed();
}

}  // namespace crossgrain
