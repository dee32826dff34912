// SPDX-License-Identifier: Apache-2.0
// Disjoint paths of edges along curves.
#pragma once

#include <array>
#include <cstdint>
#include <queue>
#include <unordered_map>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "fit/curve_line.hpp"
#include "fit/quad_complex.hpp"
#include "fit/solid_sets.hpp"

namespace crossgrain {

/// A curve that is to be routed.
struct CurveNet {
  std::uint32_t curve;
  std::array<std::uint32_t, 2> ends;   ///< vertices; kNowhere of a closed curve without corners
  std::array<std::uint32_t, 2> exits;  ///< edges at these that it should use, or kNowhere
};

/// Finds paths of edges near curves. An edge along a path costs its length in sizes times
///   1 + 8 d^2 + (1 - t.e),
/// d being the mean distance of its ends to the curve in sizes and t the curve's tangent, and a little more,
/// so that short paths of few edges win. Long curves that bend, and closed ones, are routed in thirds that
/// meet near the points at which these end, in one search: otherwise they would take the short way around.
///
/// Paths go between the solids of their curve only. A vertex or an edge that several paths use costs more
/// with every round, until each has found its own way or the rounds end (PathFinder: McMurchie and Ebeling
/// 1995, section 3).
class CurveRouting {
 public:
  CurveRouting(const HexMesh& mesh, const QuadComplex& surface, const FeatureComplex& features,
               const SolidSets& sets, double size);

  /// Keeps a vertex from the inside of all paths.
  void block(std::uint32_t vertex) { is_blocked_[vertex] = true; }
  bool is_blocked(std::uint32_t vertex) const { return is_blocked_[vertex]; }

  /// Returns paths from the first end to the last, of which no two share a vertex but ends; empty where there
  /// is none. A closed path ends with its first vertex.
  std::vector<std::vector<std::uint32_t>> disjoint_paths(const std::vector<CurveNet>& nets);

  /// Returns the path of the least cost around blocked vertices and what others use by now; empty if there is
  /// none.
  std::vector<std::uint32_t> least_path(const CurveNet& net);

  /// Returns the path of the least cost whatever others use, through vertices that are not blocked.
  std::vector<std::uint32_t> crowded_path(const CurveNet& net);

  /// What an edge of the surface costs a path of a curve from `vertex` on, within one of its thirds (0 of a
  /// curve that is not divided). Without what others use.
  double edge_cost(std::uint32_t curve, std::uint32_t third, std::uint32_t edge, std::uint32_t vertex);

  /// What the change from one third to the next costs at a vertex; infinite in the middle of a third.
  double change_cost(std::uint32_t curve, std::uint32_t third, std::uint32_t vertex) const;

  std::uint32_t thirds(std::uint32_t curve) const { return guides_[curve].thirds; }

 private:
  struct Near {
    double distance;  // in sizes
    Vector3 tangent;
  };
  struct Guide {
    CurveLine line;
    std::uint32_t thirds;  // 3 or 1
    bool is_closed;
    std::array<std::unordered_map<std::uint32_t, Near>, 3> near;
  };
  struct State {
    double cost;
    std::uint32_t place;  // third * vertices + vertex
    bool operator>(const State& other) const {
      return cost != other.cost ? cost > other.cost : place > other.place;
    }
  };

  const Near& near(std::uint32_t curve, std::uint32_t third, std::uint32_t vertex);
  std::uint32_t seam_of(std::uint32_t curve);
  double use_cost(std::uint32_t vertex) const;
  void relax(const CurveNet& net, std::uint32_t goal, std::uint32_t start, const State& state);
  void reach(std::uint32_t place, double cost, std::uint32_t from);
  std::vector<std::uint32_t> traced(std::uint32_t start, std::uint32_t goal);
  void count_uses(const std::vector<std::uint32_t>& path, int change);
  bool is_in_conflict(const std::vector<std::uint32_t>& path) const;
  void reroute(const std::vector<CurveNet>& nets, std::vector<std::vector<std::uint32_t>>& paths);
  void separate(const std::vector<CurveNet>& nets, std::vector<std::vector<std::uint32_t>>& paths);

  const HexMesh& mesh_;
  const QuadComplex& surface_;
  const SolidSets& sets_;
  const double size_;
  std::vector<Guide> guides_;
  std::vector<bool> is_blocked_;
  std::vector<int> vertex_uses_, edge_uses_;
  std::vector<double> vertex_history_, edge_history_;
  double use_price_ = 0, history_price_ = 1;

  // Of one search.
  std::vector<double> cost_;
  std::vector<std::uint32_t> from_, touched_;
  std::priority_queue<State, std::vector<State>, std::greater<>> open_;
};

}  // namespace crossgrain
