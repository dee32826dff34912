// SPDX-License-Identifier: Apache-2.0
#include "repair/repair_cost.hpp"

#include <algorithm>
#include <cmath>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Cosine to the mean normal within which faces around a vertex, or the axis of an arc that ends there, count
/// as along it.
constexpr double kAlong = 0.8;

/// Angle between the map and the geometry of a boundary edge up to which they agree: half a quarter turn, and
/// a degree for rounding.
constexpr double kAgreeDeg = 46;

/// How much worse a crease of the map is where its hexahedra would be flat: from 1 at angles up to
/// kNotFlatDeg for each of them, to kFlat at 180 degrees, where their corners have no volume.
double flatness(double angle_deg) {
  constexpr double kNotFlatDeg = 150, kFlat = 10;
  return 1 + (kFlat - 1) * std::max(0.0, angle_deg - kNotFlatDeg) / (180 - kNotFlatDeg);
}

/// Lengths of regular arcs that a boundary edge without a hexahedron costs.
constexpr double kNoHexahedron = 40;

}  // namespace

RepairCost::RepairCost(const MatchedField& field, const RepairWeights& weights)
    : field_(field), complex_(field.complex()), weights_(weights) {
  const std::size_t count = complex_.solid().mesh.vertices.size();
  smooth_normals_.resize(count, Vector3{0, 0, 0});
  for (std::uint32_t v = 0; v < count; ++v) {
    Vector3 sum{0, 0, 0};
    const auto ring = complex_.ring(v);
    for (const auto& at : ring) sum += at.angle_rad * complex_.boundary_normals()[at.face];
    const Vector3 mean = normalised(sum);
    bool is_smooth = !ring.empty();
    for (const auto& at : ring) is_smooth &= dot(complex_.boundary_normals()[at.face], mean) > kAlong;
    if (is_smooth) smooth_normals_[v] = mean;
  }
}

bool RepairCost::may_end(const TetComplex::Edge& edge, std::uint32_t vertex, const Vector3& axis) const {
  const bool other_too = complex_.is_on_boundary(edge.ends[0]) && complex_.is_on_boundary(edge.ends[1]);
  return !other_too && std::abs(dot(axis, smooth_normals_[vertex])) > kAlong;
}

double RepairCost::of_edge(std::uint32_t index) const {
  const TetComplex::Edge& edge = complex_.edges()[index];
  if (edge.is_branched) return 0;
  if (edge.is_on_boundary()) {
    const BoundaryTurn turn = field_.boundary_turn(index);
    if (turn.hexahedra == 0) return edge.length * kNoHexahedron * (1 + weights_.end);
    const double off = std::abs(90.0 * turn.hexahedra - turn.angle_deg);
    if (off <= kAgreeDeg) return 0;
    return edge.length * weights_.crease * (off / 90) * flatness(turn.angle_deg / turn.hexahedra);
  }
  const EdgeTurn turn = field_.turn_around(index);
  if (turn.kind == EdgeTurn::Kind::kNone) return 0;
  double ends = 1;
  for (const std::uint32_t v : edge.ends) {
    if (!complex_.is_on_boundary(v)) continue;
    const bool has_axis = turn.kind != EdgeTurn::Kind::kOther;
    const bool may = has_axis && may_end(edge, v, axis_in_space(field_.frames()[edge.first_tet], turn.axis));
    if (!may) ends += weights_.end;
  }
  const double times = !turn.may_be_meshed() ? 3 : turn.kind == EdgeTurn::Kind::kHalf ? 2 : 1;
  return edge.length * ends * times;
}

double RepairCost::of_vertex(std::uint32_t vertex) const {
  return field_.vertex_state(vertex) == VertexState::kImpossible
             ? weights_.corner * complex_.mean_edge_length()
             : 0;
}

}  // namespace crossgrain
