// SPDX-License-Identifier: Apache-2.0
#include "fit/corner_exits.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/vector3.hpp"
#include "fit/curve_line.hpp"
#include "fit/least_assignment.hpp"
#include "fit/nowhere.hpp"

namespace crossgrain {
namespace {

/// How far along a curve its direction at a corner is taken, in sizes: where its first edge will end.
constexpr double kExitReach = 0.7;

/// Steps of a search. Six ends among ten edges need fewer than 3,000.
constexpr std::size_t kMostExitSteps = 20000;

/// A quad at a vertex, between two of its edges, counter-clockwise.
struct Wedge {
  std::uint32_t from, to;  // indices of edges at the vertex
  std::int32_t below, above;
  bool ends;  // the quads do not go on across `to`
};

std::vector<Wedge> wedges_at(const QuadComplex& surface, std::uint32_t vertex) {
  const auto edges = surface.edges_of(vertex);
  const auto index = [&](std::uint32_t edge) {
    return static_cast<std::uint32_t>(std::ranges::find(edges, edge) - edges.begin());
  };
  std::vector<Wedge> wedges;
  for (const std::uint32_t quad : surface.quads_of(vertex)) {
    const auto [from, to] = surface.edges_at(quad, vertex);
    wedges.push_back({index(from), index(to), surface.quads()[quad].below, surface.quads()[quad].above,
                      surface.across(quad, to) == kNowhere});
  }
  return wedges;
}

/// A search of all assignments that keep the order of ends in sectors, with bounds.
class OrderedAssignment {
 public:
  OrderedAssignment(std::span<const FeatureComplex::Sector> sectors, const std::vector<Wedge>& wedges,
                    const std::vector<std::vector<double>>& turns)
      : sectors_(sectors), wedges_(wedges), turns_(turns) {
    edge_of_.assign(turns.size(), kNowhere);
    is_taken_.assign(turns.empty() ? 0 : turns[0].size(), false);
    for (const auto& of_end : turns) left_ += *std::ranges::min_element(of_end);
    if (left_ < INFINITY) search(0, 0);
  }

  bool is_found() const { return least_ < INFINITY; }
  double least() const { return least_; }
  const std::vector<std::uint32_t>& edges() const { return best_; }

 private:
  /// The edge after one, counter-clockwise between two solids, or kNowhere.
  const Wedge* wedge_from(std::uint32_t edge, const FeatureComplex::Sector& sector) const {
    for (const Wedge& wedge : wedges_)
      if (wedge.from == edge && wedge.below == sector.below && wedge.above == sector.above) return &wedge;
    return nullptr;
  }

  /// Edges counter-clockwise after the first of a sector, up to the first taken one, which is the last in the
  /// list; empty if there is no taken one and the quads end.
  std::vector<std::uint32_t> following(const FeatureComplex::Sector& sector) const {
    std::vector<std::uint32_t> edges;
    std::uint32_t edge = edge_of_[sector.from];
    for (std::size_t k = 0; k <= wedges_.size(); ++k) {
      const Wedge* const wedge = wedge_from(edge, sector);
      if (wedge == nullptr) break;
      edge = wedge->to;
      edges.push_back(edge);
      if (is_taken_[edge] || wedge->ends) break;
    }
    return edges;
  }

  bool is_in_order() const {
    for (const FeatureComplex::Sector& sector : sectors_) {
      if (sector.from == kNowhere || edge_of_[sector.from] == kNowhere || edge_of_[sector.to] == kNowhere)
        continue;
      const auto edges = following(sector);
      if (edges.empty() || edges.back() != edge_of_[sector.to]) return false;
    }
    return true;
  }

  void search(std::size_t assigned, double sum) {
    if (sum + left_ >= least_ || ++steps_ > kMostExitSteps) return;
    if (assigned == edge_of_.size()) {
      least_ = sum;
      best_ = edge_of_;
      return;
    }
    std::vector<std::uint32_t> candidates;
    const std::size_t end = next_end(candidates);
    std::ranges::stable_sort(candidates, {}, [&](std::uint32_t edge) { return turns_[end][edge]; });
    const double own = *std::ranges::min_element(turns_[end]);
    left_ -= own;
    for (const std::uint32_t edge : candidates) {
      if (is_taken_[edge] || turns_[end][edge] == INFINITY) continue;
      is_taken_[edge] = true;
      edge_of_[end] = edge;
      if (is_in_order()) search(assigned + 1, sum + turns_[end][edge]);
      is_taken_[edge] = false;
      edge_of_[end] = kNowhere;
    }
    left_ += own;
  }

  /// Returns an end without an edge: the next one after another that has one, where there is such, with the
  /// edges that it may have.
  std::size_t next_end(std::vector<std::uint32_t>& candidates) const {
    for (const FeatureComplex::Sector& sector : sectors_) {
      if (sector.from == kNowhere || edge_of_[sector.from] == kNowhere || edge_of_[sector.to] != kNowhere)
        continue;
      candidates = following(sector);
      return sector.to;
    }
    for (std::uint32_t edge = 0; edge < is_taken_.size(); ++edge) candidates.push_back(edge);
    return static_cast<std::size_t>(std::ranges::find(edge_of_, kNowhere) - edge_of_.begin());
  }

  const std::span<const FeatureComplex::Sector> sectors_;
  const std::vector<Wedge>& wedges_;
  const std::vector<std::vector<double>>& turns_;
  std::vector<std::uint32_t> edge_of_, best_;
  std::vector<bool> is_taken_;
  double least_ = INFINITY, left_ = 0;
  std::size_t steps_ = 0;
};

}  // namespace

ExitSearch::ExitSearch(const HexMesh& mesh, const QuadComplex& surface, const FeatureComplex& features,
                       const SolidSets& sets, double size)
    : mesh_(mesh), surface_(surface), features_(features), sets_(sets) {
  for (const FeatureComplex::Corner& corner : features.corners) {
    std::vector<Vector3>& directions = directions_.emplace_back();
    for (const FeatureComplex::End& end : corner.ends) {
      const CurveLine line(features, end.curve);
      const double along = std::min(kExitReach * size, 0.5 * line.length());
      directions.push_back(normalised(line.at(end.is_last ? line.length() - along : along) - corner.point));
    }
  }
}

CornerExits ExitSearch::exits(std::uint32_t corner, std::uint32_t vertex) const {
  const auto& ends = features_.corners[corner].ends;
  CornerExits exits{std::vector<std::uint32_t>(ends.size(), kNowhere), 0, 0, true};
  if (ends.empty()) return exits;
  const auto edges = surface_.edges_of(vertex);
  std::vector<std::vector<double>> turns(ends.size(), std::vector<double>(edges.size(), INFINITY));
  std::vector<AssignmentChoice> choices;
  for (std::uint32_t k = 0; k < ends.size(); ++k) {
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      if (sets_.of_edge[edges[e]] != sets_.of_curve[ends[k].curve]) continue;
      const Vector3 along =
          normalised(mesh_.vertices[surface_.other_end(edges[e], vertex)] - mesh_.vertices[vertex]);
      turns[k][e] = std::max(0.0, 1 - dot(along, directions_[corner][k]));
      choices.push_back({k, e, turns[k][e]});
    }
  }
  const OrderedAssignment ordered(features_.corners[corner].sectors, wedges_at(surface_, vertex), turns);
  exits.fits = ordered.is_found();
  // Without an edge costs more than any turn, which is 2 at most.
  const auto least = exits.fits ? ordered.edges() : least_assignment(ends.size(), choices, 100);
  double sum = 0;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    if (least[k] == kNowhere) {
      ++exits.missing;
      continue;
    }
    exits.edges[k] = edges[least[k]];
    sum += turns[k][least[k]];
  }
  exits.mean_turn = sum / static_cast<double>(ends.size());
  return exits;
}

}  // namespace crossgrain
