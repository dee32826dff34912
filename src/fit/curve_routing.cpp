// SPDX-License-Identifier: Apache-2.0
#include "fit/curve_routing.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "fit/nowhere.hpp"

namespace crossgrain {
namespace {

constexpr double kDistanceCost = 8, kEdgeCost = 0.02;

/// Other exits than those of the corner: as far around as two edges.
constexpr double kOtherExitCost = 2;

/// Thirds may meet so near to their common point for nothing, in sizes: some vertex of an even path does.
constexpr double kFreeChange = 0.6, kChangeCost = 4;

/// A curve is divided that is longer than this many chords, and than so many sizes: shorter ones have too few
/// edges.
constexpr double kMostChords = 1.3, kLeastDivided = 2;

/// Price of a use by others at first, and its growth in a round.
constexpr double kFirstPrice = 0.5, kPriceGrowth = 1.5;
constexpr int kRoutingRounds = 40;

std::uint32_t thirds_of(const FeatureComplex& features, std::uint32_t curve, double size) {
  const FeatureComplex::Curve& of = features.curves[curve];
  const double chord = norm(features.vertices[of.vertices.back()] - features.vertices[of.vertices.front()]);
  const bool is_bent = of.is_closed() || of.length > kMostChords * chord;
  return of.is_closed() || (is_bent && of.length > kLeastDivided * size) ? 3 : 1;
}

}  // namespace

CurveRouting::CurveRouting(const HexMesh& mesh, const QuadComplex& surface, const FeatureComplex& features,
                           const SolidSets& sets, double size)
    : mesh_(mesh), surface_(surface), sets_(sets), size_(size) {
  for (std::uint32_t c = 0; c < features.curves.size(); ++c)
    guides_.push_back(
        {CurveLine(features, c), thirds_of(features, c, size), features.curves[c].is_closed(), {}});
  const std::size_t vertices = mesh.vertices.size(), edges = surface.edges().size();
  is_blocked_.assign(vertices, false);
  vertex_uses_.assign(vertices, 0);
  vertex_history_.assign(vertices, 0);
  edge_uses_.assign(edges, 0);
  edge_history_.assign(edges, 0);
  cost_.assign(3 * vertices, INFINITY);
  from_.assign(3 * vertices, kNowhere);
}

const CurveRouting::Near& CurveRouting::near(std::uint32_t curve, std::uint32_t third, std::uint32_t vertex) {
  Guide& guide = guides_[curve];
  const auto [entry, is_new] = guide.near[third].try_emplace(vertex);
  if (is_new) {
    const double whole = guide.line.length(), part = whole / guide.thirds;
    const double more = std::min(size_, part / 2);  // beyond each third
    const double low = guide.thirds == 1 ? 0 : third * part - more;
    const double high = guide.thirds == 1 ? whole : (third + 1) * part + more;
    const CurveLine::Nearest nearest = guide.line.nearest(mesh_.vertices[vertex], low, high);
    entry->second = {nearest.distance / size_, nearest.tangent};
  }
  return entry->second;
}

double CurveRouting::edge_cost(std::uint32_t curve, std::uint32_t third, std::uint32_t edge,
                               std::uint32_t vertex) {
  const std::uint32_t other = surface_.other_end(edge, vertex);
  const Near &here = near(curve, third, vertex), &there = near(curve, third, other);
  const Vector3 along = mesh_.vertices[other] - mesh_.vertices[vertex];
  const double length = norm(along), distance = (here.distance + there.distance) / 2;
  const double turn =
      length > 0 ? 1 - (dot(along, here.tangent) + dot(along, there.tangent)) / (2 * length) : 1;
  return length / size_ * (1 + kDistanceCost * distance * distance + turn) + kEdgeCost;
}

double CurveRouting::change_cost(std::uint32_t curve, std::uint32_t third, std::uint32_t vertex) const {
  const Guide& guide = guides_[curve];
  const double whole = guide.line.length(), part = whole / guide.thirds, place = part * (third + 1);
  const Vector3& point = mesh_.vertices[vertex];
  // On a short curve all vertices are near; what lies in the middle of a third belongs to no other.
  const double apart = std::abs(guide.line.nearest(point, 0, whole).arc_length - place);
  if (std::min(apart, guide.is_closed ? whole - apart : apart) > part / 2) return INFINITY;
  const double off = std::max(0.0, norm(point - guide.line.at(place)) / size_ - kFreeChange);
  return kChangeCost * off * off;
}

double CurveRouting::use_cost(std::uint32_t vertex) const {
  return use_price_ * vertex_uses_[vertex] + history_price_ * vertex_history_[vertex];
}

/// The vertex where a closed curve begins.
std::uint32_t CurveRouting::seam_of(std::uint32_t curve) {
  std::uint32_t seam = kNowhere;
  double least = INFINITY;
  const double reach = 4 * size_;
  const Vector3 start = guides_[curve].line.at(0);
  for (const std::uint32_t v : surface_.vertices()) {
    if (sets_.of_vertex[v] != sets_.of_curve[curve] || is_blocked_[v]) continue;
    if (norm(mesh_.vertices[v] - start) > reach) continue;
    const double distance = near(curve, 0, v).distance;
    const double cost = change_cost(curve, 2, v) + kDistanceCost * distance * distance + use_cost(v);
    if (cost < least) least = cost, seam = v;
  }
  return seam;
}

void CurveRouting::reach(std::uint32_t place, double cost, std::uint32_t from) {
  if (cost >= cost_[place]) return;
  if (cost_[place] == INFINITY) touched_.push_back(place);
  cost_[place] = cost;
  from_[place] = from;
  open_.push({cost, place});
}

void CurveRouting::relax(const CurveNet& net, std::uint32_t goal, std::uint32_t start, const State& state) {
  const auto vertices = static_cast<std::uint32_t>(mesh_.vertices.size());
  const std::uint32_t third = state.place / vertices, v = state.place % vertices;
  const std::uint32_t last = guides_[net.curve].thirds - 1, set = sets_.of_curve[net.curve];
  const bool is_start = state.place == start;
  // A path does not turn back on its edge: a short closed one would come home by the way it went.
  std::uint32_t before = is_start ? kNowhere : from_[state.place];
  while (before != kNowhere && before % vertices == v) before = from_[before];
  if (third < last && !is_start)
    reach(state.place + vertices, state.cost + change_cost(net.curve, third, v), state.place);
  for (const std::uint32_t edge : surface_.edges_of(v)) {
    if (sets_.of_edge[edge] != set) continue;
    const std::uint32_t other = surface_.other_end(edge, v), place = third * vertices + other;
    if (before != kNowhere && other == before % vertices) continue;
    const bool is_goal = place == goal;
    if (!is_goal && (is_blocked_[other] || sets_.of_vertex[other] != set || other == start % vertices ||
                     other == goal % vertices))
      continue;
    double cost = state.cost + edge_cost(net.curve, third, edge, v) + use_price_ * edge_uses_[edge] +
                  history_price_ * edge_history_[edge];
    if (is_start && net.exits[0] != kNowhere && edge != net.exits[0]) cost += kOtherExitCost;
    if (is_goal && net.exits[1] != kNowhere && edge != net.exits[1]) cost += kOtherExitCost;
    if (!is_goal) cost += use_cost(other);
    reach(place, cost, state.place);
  }
}

std::vector<std::uint32_t> CurveRouting::traced(std::uint32_t start, std::uint32_t goal) {
  const auto vertices = static_cast<std::uint32_t>(mesh_.vertices.size());
  std::vector<std::uint32_t> path;
  if (cost_[goal] < INFINITY) {
    for (std::uint32_t place = goal;; place = from_[place]) {
      if (path.empty() || path.back() != place % vertices) path.push_back(place % vertices);
      if (place == start && path.size() > 1) break;
    }
    std::ranges::reverse(path);
  }
  for (const std::uint32_t place : touched_) cost_[place] = INFINITY;
  touched_.clear();
  open_ = {};
  return path;
}

std::vector<std::uint32_t> CurveRouting::least_path(const CurveNet& net) {
  const auto vertices = static_cast<std::uint32_t>(mesh_.vertices.size());
  const std::uint32_t seam = net.ends[0] == kNowhere ? seam_of(net.curve) : kNowhere;
  const std::uint32_t start = net.ends[0] == kNowhere ? seam : net.ends[0];
  const std::uint32_t end = net.ends[0] == kNowhere ? seam : net.ends[1];
  if (start == kNowhere || end == kNowhere) return {};
  const std::uint32_t goal = (guides_[net.curve].thirds - 1) * vertices + end;
  Checkpoint checkpoint;
  reach(start, 0, kNowhere);
  while (!open_.empty()) {
    checkpoint.pass();
    const State state = open_.top();
    open_.pop();
    if (state.cost > cost_[state.place]) continue;
    if (state.place == goal) break;
    relax(net, goal, start, state);
  }
  return traced(start, goal);
}

std::vector<std::uint32_t> CurveRouting::crowded_path(const CurveNet& net) {
  const std::array<double, 2> prices{std::exchange(use_price_, 0), std::exchange(history_price_, 0)};
  std::vector<std::uint32_t> path = least_path(net);
  use_price_ = prices[0];
  history_price_ = prices[1];
  return path;
}

void CurveRouting::count_uses(const std::vector<std::uint32_t>& path, int change) {
  if (path.empty()) return;
  const bool is_closed = path.front() == path.back() && !is_blocked_[path.front()];
  for (std::size_t k = is_closed ? 0 : 1; k + 1 < path.size(); ++k) vertex_uses_[path[k]] += change;
  for (std::size_t k = 1; k < path.size(); ++k)
    edge_uses_[surface_.edge_between(path[k - 1], path[k])] += change;
}

bool CurveRouting::is_in_conflict(const std::vector<std::uint32_t>& path) const {
  for (std::size_t k = 0; k < path.size(); ++k) {
    if (vertex_uses_[path[k]] > 1) return true;
    if (k > 0 && edge_uses_[surface_.edge_between(path[k - 1], path[k])] > 1) return true;
  }
  return false;
}

void CurveRouting::reroute(const std::vector<CurveNet>& nets,
                           std::vector<std::vector<std::uint32_t>>& paths) {
  std::vector<std::size_t> order(nets.size());
  for (std::size_t k = 0; k < nets.size(); ++k) order[k] = k;
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return guides_[nets[k].curve].line.length(); });
  use_price_ = kFirstPrice;
  for (int round = 0; round < kRoutingRounds; ++round, use_price_ *= kPriceGrowth) {
    for (const std::size_t k : order) {
      check_watched();
      if (round > 0 && !is_in_conflict(paths[k])) continue;
      count_uses(paths[k], -1);
      paths[k] = least_path(nets[k]);
      count_uses(paths[k], 1);
    }
    bool is_done = true;
    for (const auto& path : paths) is_done = is_done && !is_in_conflict(path);
    if (is_done) return;
    for (const std::uint32_t v : surface_.vertices()) vertex_history_[v] += vertex_uses_[v] > 1 ? 1 : 0;
    for (std::size_t e = 0; e < edge_uses_.size(); ++e) edge_history_[e] += edge_uses_[e] > 1 ? 1 : 0;
  }
}

/// Takes away paths in conflict, those with most of it first, and lets them look for a way around the others.
void CurveRouting::separate(const std::vector<CurveNet>& nets,
                            std::vector<std::vector<std::uint32_t>>& paths) {
  std::vector<std::size_t> removed;
  for (;;) {
    std::size_t most = 0, worst = 0;
    for (std::size_t k = 0; k < paths.size(); ++k) {
      std::size_t shared = 0;
      for (std::size_t i = 0; i < paths[k].size(); ++i) {
        shared += vertex_uses_[paths[k][i]] > 1;
        shared += i > 0 && edge_uses_[surface_.edge_between(paths[k][i - 1], paths[k][i])] > 1;
      }
      if (shared > most) most = shared, worst = k;
    }
    if (most == 0) break;
    count_uses(paths[worst], -1);
    paths[worst].clear();
    removed.push_back(worst);
  }
  // So much that a path through others costs more than any other.
  use_price_ = 1e9;
  for (const std::size_t k : removed) {
    paths[k] = least_path(nets[k]);
    count_uses(paths[k], 1);
    if (!is_in_conflict(paths[k])) continue;
    count_uses(paths[k], -1);
    paths[k].clear();
  }
}

std::vector<std::vector<std::uint32_t>> CurveRouting::disjoint_paths(const std::vector<CurveNet>& nets) {
  for (const CurveNet& net : nets)
    for (const std::uint32_t end : net.ends)
      if (end != kNowhere) block(end);
  std::vector<std::vector<std::uint32_t>> paths(nets.size());
  reroute(nets, paths);
  separate(nets, paths);
  use_price_ = 1e9;
  return paths;
}

}  // namespace crossgrain
