// SPDX-License-Identifier: Apache-2.0
#include "repair/matching_repair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <utility>

#include "base/elementary.hpp"
#include "base/parallel.hpp"

namespace crossgrain {
namespace {

/// Largest number of ends of a push that are tried, the nearest first.
constexpr std::size_t kMostEnds = 40;

/// Sweeps of moves over all vertices, until none lowers the cost.
constexpr int kMostSweeps = 30;

/// Mean of the lengths by which a wandering may raise the cost, in mean edge lengths.
constexpr double kTemperature = 30;

/// A push must lower the cost by this much, in mean edge lengths.
constexpr double kLeastGain = 1e-9;

std::uint32_t third_of(const std::array<std::uint32_t, 3>& face, std::uint32_t a, std::uint32_t b) {
  for (const std::uint32_t v : face)
    if (v != a && v != b) return v;
  return a;
}

}  // namespace

MatchingRepair::MatchingRepair(MatchedField& field, const RepairWeights& weights, std::size_t work)
    : field_(field), complex_(field.complex()), cost_(field, weights), work_(work) {
  const auto count = static_cast<std::uint32_t>(complex_.edges().size());
  edge_costs_.resize(count);
  is_singular_.resize(count);
  parallel_for(count, [&](std::size_t e) {
    const auto edge = static_cast<std::uint32_t>(e);
    edge_costs_[e] = cost_.of_edge(edge);
    is_singular_[e] = !complex_.edges()[e].is_on_boundary() && field_.is_singular(edge);
  });
  const auto vertices = static_cast<std::uint32_t>(complex_.solid().mesh.vertices.size());
  for (std::uint32_t v = 0; v < vertices; ++v) vertex_costs_.push_back(cost_.of_vertex(v));
}

double MatchingRepair::cost() const {
  double sum = 0;
  for (const double cost : edge_costs_) sum += cost;
  for (const double cost : vertex_costs_) sum += cost;
  return sum;
}

void MatchingRepair::run(const RepairTuning& options) {
  pull_off_creases();
  touch_faults();
  settle(kMostSweeps);
  std::mt19937_64 random(0);
  std::vector<int> in_vain(vertex_costs_.size(), 0);
  for (bool any = true; any;) {
    any = false;
    for (std::uint32_t v = 0; v < vertex_costs_.size(); ++v) {
      while (is_costly(v) && in_vain[v] < options.disturbances && may_go_on(options)) {
        const bool lowered = disturb(v, random(), -kLeastGain);
        in_vain[v] = lowered ? 0 : in_vain[v] + 1;
        any |= lowered;
      }
    }
  }
}

void MatchingRepair::wander(const RepairTuning& options, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::size_t best = journal_.size();
  double least = gained_;
  for (int step = 0; step < options.wandering_steps && may_go_on(options); ++step) {
    std::vector<std::uint32_t> faults;
    for (std::uint32_t v = 0; v < vertex_costs_.size(); ++v)
      if (is_costly(v)) faults.push_back(v);
    if (faults.empty()) break;
    const std::uint32_t at = faults[random() % faults.size()];
    constexpr double kTwoTo53 = 9007199254740992.0;
    const double uniform = (static_cast<double>(random() >> 11) + 1) / kTwoTo53;
    disturb(at, random(), -kTemperature * logarithm(uniform));
    if (gained_ >= least - kLeastGain * complex_.mean_edge_length()) continue;
    least = gained_;
    best = journal_.size();
  }
  roll_back(best);
  gained_ = least;
}

void MatchingRepair::touch_faults() {
  for (std::uint32_t e = 0; e < edge_costs_.size(); ++e)
    if (edge_costs_[e] > 0) touched_.insert(complex_.edges()[e].ends.begin(), complex_.edges()[e].ends.end());
  for (std::uint32_t v = 0; v < vertex_costs_.size(); ++v)
    if (is_costly(v)) touched_.insert(v);
}

void MatchingRepair::settle(int most_sweeps) {
  for (int sweep = 0; sweep < most_sweeps && !touched_.empty(); ++sweep) {
    check_watched();
    const Vertices now = std::exchange(touched_, {});
    constexpr int kMostPushes = 6;
    for (const std::uint32_t v : now)
      for (int k = 0; k < kMostPushes && push_at(v); ++k) {
      }
    for (const std::uint32_t v : now)
      if (is_costly(v)) check_watched(), flip_at(v);
  }
  touched_.clear();
}

bool MatchingRepair::disturb(std::uint32_t vertex, std::uint64_t random, double allowance) {
  check_watched();
  const CubeGroup& group = CubeGroup::instance();
  const std::size_t mark = journal_.size();
  const double before = gained_;
  const auto draw = [&](std::size_t count) {
    const auto drawn = static_cast<std::size_t>(random % count);
    random = random / count * 6364136223846793005u + 1442695040888963407u;
    return drawn;
  };
  // One to three faces at the vertex or at a neighbour of it.
  const std::size_t count = 1 + draw(3);
  for (std::size_t k = 0; k < count; ++k) {
    std::uint32_t at = vertex;
    if (draw(2) == 1) {
      const auto edges = complex_.edges_at(vertex);
      const auto& [a, b] = complex_.edges()[edges[draw(edges.size())]].ends;
      at = a == vertex ? b : a;
    }
    const auto faces = complex_.faces_at(at);
    if (faces.empty()) continue;
    const std::uint32_t face = faces[draw(faces.size())];
    const auto turn = static_cast<std::uint8_t>(1 + draw(CubeGroup::kCount - 1));
    const FaceChange change{face, group.product(turn, field_.matching(face))};
    gained_ += apply({&change, 1});
    keep();
  }
  constexpr int kFewSweeps = 10;
  settle(kFewSweeps);
  if (gained_ < before + allowance * complex_.mean_edge_length()) return true;
  roll_back(mark);
  gained_ = before;
  return false;
}

void MatchingRepair::add_along_arcs(const Vertices& from, Vertices& vertices) const {
  for (const std::uint32_t v : from) {
    for (const std::uint32_t e : complex_.edges_at(v)) {
      if (complex_.edges()[e].is_on_boundary() || !field_.is_singular(e)) continue;
      field_.walk_arc(v, e, [&](std::uint32_t edge, std::uint32_t vertex) {
        if (field_.turn_around(edge).has_sense()) return false;
        vertices.insert(vertex);
        return true;
      });
    }
  }
}

double MatchingRepair::apply(std::span<const FaceChange> changes) {
  undo_faces_.clear();
  undo_edges_.clear();
  undo_vertices_.clear();
  std::set<std::uint32_t> edges;
  Vertices vertices;
  for (const FaceChange& change : changes) {
    for (const std::uint32_t e : complex_.edges_of_face(change.face)) edges.insert(e);
    for (const std::uint32_t v : complex_.solid().inner_faces[change.face].vertices) vertices.insert(v);
  }
  const Vertices changed = vertices;
  add_along_arcs(changed, vertices);
  for (const FaceChange& change : changes) {
    undo_faces_.push_back({change.face, field_.matching(change.face)});
    field_.set_matching(change.face, change.matching);
  }
  add_along_arcs(changed, vertices);
  work_ += edges.size() + vertices.size();
  double gain = 0;
  for (const std::uint32_t e : edges) {
    undo_edges_.push_back({e, edge_costs_[e]});
    edge_costs_[e] = cost_.of_edge(e);
    gain += edge_costs_[e] - undo_edges_.back().cost;
    if (!complex_.edges()[e].is_on_boundary()) is_singular_[e] = field_.is_singular(e);
  }
  for (const std::uint32_t v : vertices) {
    undo_vertices_.push_back({v, vertex_costs_[v]});
    vertex_costs_[v] = cost_.of_vertex(v);
    gain += vertex_costs_[v] - undo_vertices_.back().cost;
  }
  return gain;
}

void MatchingRepair::undo() {
  for (auto change = undo_faces_.rbegin(); change != undo_faces_.rend(); ++change)
    field_.set_matching(change->face, change->matching);
  for (const OldCost& old : undo_edges_) {
    edge_costs_[old.index] = old.cost;
    if (!complex_.edges()[old.index].is_on_boundary())
      is_singular_[old.index] = field_.is_singular(old.index);
  }
  for (const OldCost& old : undo_vertices_) vertex_costs_[old.index] = old.cost;
}

void MatchingRepair::keep() {
  for (const FaceChange& change : undo_faces_) journal_.push_back(change);
  for (const OldCost& old : undo_vertices_) touched_.insert(old.index);
  ++moves_;
}

void MatchingRepair::roll_back(std::size_t mark) {
  std::vector<FaceChange> former(journal_.begin() + static_cast<std::ptrdiff_t>(mark), journal_.end());
  std::reverse(former.begin(), former.end());
  apply(former);
  journal_.resize(mark);
}

bool MatchingRepair::accept(std::span<const FaceChange> changes) {
  const double gain = apply(changes);
  if (gain >= -kLeastGain * complex_.mean_edge_length()) {
    undo();
    return false;
  }
  gained_ += gain;
  keep();
  return true;
}

bool MatchingRepair::push_at(std::uint32_t vertex) {
  std::vector<std::uint32_t> far_ends;
  for (const std::uint32_t e : complex_.edges_at(vertex)) {
    const TetComplex::Edge& edge = complex_.edges()[e];
    const bool is_off = edge.is_on_boundary() ? edge_costs_[e] > 0 : is_singular_[e] != 0;
    if (is_off) far_ends.push_back(edge.ends[0] == vertex ? edge.ends[1] : edge.ends[0]);
  }
  return std::any_of(far_ends.begin(), far_ends.end(),
                     [&](std::uint32_t from) { return push_along(vertex, from); });
}

bool MatchingRepair::push_along(std::uint32_t vertex, std::uint32_t from) {
  struct Step {
    double distance;
    std::uint32_t before, face;
  };
  std::map<std::uint32_t, std::vector<std::array<std::uint32_t, 2>>> link;  // neighbour and face
  for (const std::uint32_t f : complex_.faces_at(vertex)) {
    const auto& face = complex_.solid().inner_faces[f].vertices;
    const std::uint32_t a = face[0] == vertex ? face[1] : face[0], b = third_of(face, vertex, a);
    link[a].push_back({b, f});
    link[b].push_back({a, f});
  }
  const auto spoke = [&](std::uint32_t x) -> const TetComplex::Edge& {
    return complex_.edges()[complex_.edge_between(vertex, x)];
  };
  const auto is_end = [&](std::uint32_t x) {
    return is_singular_[complex_.edge_between(vertex, x)] || spoke(x).is_on_boundary();
  };
  const RepairWeights& weights = cost_.weights();
  const auto weight_of = [&](std::uint32_t x, std::uint32_t y) {
    const std::uint32_t e = complex_.edge_between(x, y);
    const TetComplex::Edge& edge = complex_.edges()[e];
    constexpr double kAsGoodAsFree = 0.01;
    if (edge.is_on_boundary()) return (edge_costs_[e] > 0 ? kAsGoodAsFree : weights.crease) * edge.length;
    if (is_singular_[e]) return kAsGoodAsFree * edge.length;
    return edge.length * (1 + weights.end * (complex_.is_on_boundary(x) + complex_.is_on_boundary(y)));
  };
  std::map<std::uint32_t, Step> steps{{from, {0, from, kNoFace}}};
  std::set<std::pair<double, std::uint32_t>> queue{{0, from}};
  while (!queue.empty()) {
    const auto [distance, x] = *queue.begin();
    queue.erase(queue.begin());
    if (x != from && is_end(x)) continue;
    for (const auto& [y, face] : link[x]) {
      const double reached = distance + weight_of(x, y);
      const auto [known, is_new] = steps.try_emplace(y, Step{reached, x, face});
      if (!is_new) {
        if (reached >= known->second.distance) continue;
        queue.erase({known->second.distance, y});
        known->second = {reached, x, face};
      }
      queue.insert({reached, y});
    }
  }
  std::vector<std::pair<double, std::uint32_t>> ends;
  for (const auto& [y, step] : steps)
    if (y != from && is_end(y)) ends.push_back({step.distance, y});
  std::sort(ends.begin(), ends.end());
  if (ends.size() > kMostEnds) ends.resize(kMostEnds);
  // A push costs the edges of the way and gains no more than what is at its ends, unless it mends a vertex.
  const double at_vertex = edge_costs_[complex_.edge_between(vertex, from)];
  for (const auto& [distance, y] : ends) {
    const double gain = at_vertex + edge_costs_[complex_.edge_between(vertex, y)];
    const bool may_mend = is_costly(vertex) || is_costly(from) || is_costly(y);
    if (!may_mend && distance > gain) continue;
    std::vector<std::uint32_t> way{y}, faces;
    for (std::uint32_t x = y; x != from; x = steps[x].before) {
      faces.push_back(steps[x].face);
      way.push_back(steps[x].before);
    }
    std::reverse(way.begin(), way.end());
    std::reverse(faces.begin(), faces.end());
    if (accept(push_changes(field_, vertex, way, faces))) return true;
  }
  return false;
}

bool MatchingRepair::may_gain(const FaceChange& change, std::uint32_t vertex) {
  constexpr std::size_t kCosts = 4;  // of the vertex and three edges
  work_ += kCosts;
  const std::uint8_t old = field_.matching(change.face);
  field_.set_matching(change.face, change.matching);
  double least = cost_.of_vertex(vertex) - vertex_costs_[vertex];
  for (const std::uint32_t v : complex_.solid().inner_faces[change.face].vertices)
    if (v != vertex) least -= vertex_costs_[v];
  for (const std::uint32_t e : complex_.edges_of_face(change.face))
    least += cost_.of_edge(e) - edge_costs_[e];
  field_.set_matching(change.face, old);
  return least < 0;
}

bool MatchingRepair::flip_best(std::uint32_t face, std::uint32_t vertex) {
  const CubeGroup& group = CubeGroup::instance();
  const std::uint8_t old = field_.matching(face);
  double best = 0;
  std::uint8_t best_matching = old;
  for (std::uint8_t turn = 1; turn < CubeGroup::kCount; ++turn) {
    const FaceChange change{face, group.product(turn, old)};
    if (!may_gain(change, vertex)) continue;
    const double gain = apply({&change, 1});
    undo();
    if (gain < best) best = gain, best_matching = change.matching;
  }
  const FaceChange change{face, best_matching};
  return best_matching != old && accept({&change, 1});
}

bool MatchingRepair::flip_at(std::uint32_t vertex) {
  bool any = false;
  for (const std::uint32_t f : complex_.faces_at(vertex)) any |= flip_best(f, vertex);
  return any;
}

void MatchingRepair::pull_off_creases() {
  const CubeGroup& group = CubeGroup::instance();
  for (std::uint32_t e = 0; e < edge_costs_.size(); ++e) {
    const TetComplex::Edge& edge = complex_.edges()[e];
    if (!edge.is_on_boundary() || edge.is_branched || field_.boundary_turn(e).hexahedra != 0) continue;
    double best = 0;
    FaceChange best_change{kNoFace, 0};
    for (const Crossing& crossing : complex_.around(e)) {
      const std::uint8_t old = field_.matching(crossing.face);
      for (std::uint8_t turn = 1; turn < CubeGroup::kCount; ++turn) {
        if (group[turn].w == 0 || !group[turn].is_odd()) continue;  // only quarter turns
        const FaceChange change{crossing.face, group.product(turn, old)};
        const double gain = apply({&change, 1});
        undo();
        if (gain < best) best = gain, best_change = change;
      }
    }
    if (best_change.face != kNoFace) accept({&best_change, 1});
  }
}

}  // namespace crossgrain
