// SPDX-License-Identifier: Apache-2.0
#include "matching/matched_field.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "base/degree.hpp"
#include "base/elementary.hpp"
#include "base/parallel.hpp"
#include "singularity/tet_matchings.hpp"
#include "singularity/vertex_link.hpp"

namespace crossgrain {
namespace {

/// Turn of the surface at an edge from which its geometry says whether it is convex; below, frames say it.
constexpr double kConvexDeg = 15;

/// Angle of the solid at an edge between two boundary faces, from the first through the solid to the second,
/// right-handed about `along`.
double solid_angle_deg(const Vector3& first, const Vector3& second, const Vector3& along) {
  return 180 + arc_tangent(dot(cross(first, second), along), dot(first, second)) / kDegree;
}

/// The cyclic sequence that is first among all its rotations and reflections.
std::vector<int> canonical(const std::vector<int>& border) {
  std::vector<int> best = border;
  std::vector<int> turned = border;
  for (int side = 0; side < 2; ++side) {
    for (std::size_t k = 0; k < border.size(); ++k) {
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      best = std::min(best, turned);
    }
    std::reverse(turned.begin(), turned.end());
  }
  return best;
}

/// Number of quarter turns about `normal`, counter-clockwise, from one axis across it to another.
int quarters(SignedAxis normal, SignedAxis from, SignedAxis to) {
  if (from == to) return 0;
  if (from == opposite(to)) return 2;
  return cross_of(normal, from) == to ? 1 : 3;
}

}  // namespace

MatchedField::MatchedField(const TetComplex& complex, std::span<const Quaternion> frames)
    : MatchedField(complex, frames, tet_matchings(complex.solid(), frames)) {}

MatchedField::MatchedField(const TetComplex& complex, std::span<const Quaternion> frames,
                           std::span<const CubeRotation> matchings)
    : complex_(&complex), frames_(frames), matchings_(matchings.size()) {
  const TetSolid& solid = complex.solid();
  assert(frames.size() == solid.mesh.tets.size() && matchings.size() == solid.inner_faces.size());
  for (std::size_t f = 0; f < matchings.size(); ++f) matchings_[f] = group_->number_of(matchings[f]);
  const std::vector<Vector3>& normals = complex.boundary_normals();
  for (std::size_t f = 0; f < normals.size(); ++f)
    normal_axes_.push_back(nearest_axis(frames[solid.boundary_tets[f]], normals[f]));
  for (const TetComplex::Edge& edge : complex.edges()) {
    double angle = 180;
    if (edge.is_on_boundary() && !edge.is_branched) {
      const Vector3 along = normalised(solid.mesh.vertices[edge.ends[1]] - solid.mesh.vertices[edge.ends[0]]);
      angle = solid_angle_deg(normals[edge.boundary_faces[0]], normals[edge.boundary_faces[1]], along);
    }
    angles_deg_.push_back(angle);
  }
}

MatchedField MatchedField::with_frames(std::span<const Quaternion> frames) const {
  MatchedField field = *this;
  field.frames_ = frames;
  return field;
}

std::vector<CubeRotation> MatchedField::matchings() const {
  std::vector<CubeRotation> result;
  for (const std::uint8_t number : matchings_) result.push_back((*group_)[number]);
  return result;
}

std::uint8_t MatchedField::holonomy(std::uint32_t edge) const {
  std::uint8_t product = CubeGroup::kIdentity;
  for (const Crossing& crossing : complex_->around(edge))
    product = group_->product(across(crossing), product);
  return product;
}

std::optional<std::uint8_t> MatchedField::wanted_holonomy(std::uint32_t index, std::uint8_t now) const {
  const TetComplex::Edge& edge = complex_->edges()[index];
  if (!edge.is_on_boundary()) return CubeGroup::kIdentity;
  if (edge.is_branched) return std::nullopt;
  const SignedAxis carried = group_->image(now, normal_axis(edge.boundary_faces[0]));
  const SignedAxis arrives = normal_axis(edge.boundary_faces[1]);
  const std::vector<Vector3>& vertices = complex_->solid().mesh.vertices;
  const Vector3 along = vertices[edge.ends[1]] - vertices[edge.ends[0]];
  const std::uint32_t last = complex_->solid().boundary_tets[edge.boundary_faces[1]];
  const auto nearest = nearest_axis(frames_[last], along);
  // The axis along the edge, across both normals.
  SignedAxis axis = nearest;
  if (carried % 3 != arrives % 3) {
    axis = cross_of(carried, arrives);
    if (dot(axis_in_space(frames_[last], axis), along) < 0) axis = opposite(axis);
  } else if (axis % 3 == arrives % 3) {
    return std::nullopt;
  }
  const int wanted = std::max(1, static_cast<int>(std::lround(angles_deg_[index] / 90)));
  // A solid of k quarter turns turns the outward normal by k - 2 of them about the edge.
  SignedAxis target = arrives;
  for (int k = 0; k < 4; ++k) {
    // `target` is what carried must become: arrives, turned back by k - 2 quarter turns.
    if ((k - (wanted - 2) % 4 + 4) % 4 == 0) break;
    target = target % 3 == axis % 3 ? target : cross_of(target, axis);
  }
  if (target == carried) return now;
  const std::uint8_t turn = group_->rotation_between(carried, target, axis);
  return group_->product(turn, now);
}

EdgeTurn MatchedField::turn_around(std::uint32_t inner_edge) const {
  EdgeTurn turn;
  const CubeRotation& rotation = (*group_)[holonomy(inner_edge)];
  if (rotation.is_identity()) return turn;
  const std::array<int, 3> parts{rotation.x, rotation.y, rotation.z};
  const int other = (rotation.x != 0) + (rotation.y != 0) + (rotation.z != 0);
  turn.kind = other > 1         ? EdgeTurn::Kind::kOther
              : rotation.w == 0 ? EdgeTurn::Kind::kHalf
                                : EdgeTurn::Kind::kQuarter;
  if (other > 1) return turn;
  const auto axis = static_cast<SignedAxis>(parts[0] != 0 ? 0 : parts[1] != 0 ? 1 : 2);
  turn.axis = parts[axis] > 0 ? axis : opposite(axis);
  const TetComplex::Edge& edge = complex_->edges()[inner_edge];
  if (turn.kind == EdgeTurn::Kind::kHalf) {
    // Of a half turn the frames say the sense; without one the cosine stays 0.
    constexpr double kRounding = 1e-6;
    const double sense = dot(turning_around(inner_edge), axis_in_space(frames_[edge.first_tet], turn.axis));
    if (std::abs(sense) < kRounding) return turn;
    if (sense < 0) turn.axis = opposite(turn.axis);
  }
  const std::vector<Vector3>& vertices = complex_->solid().mesh.vertices;
  const Vector3 along = normalised(vertices[edge.ends[1]] - vertices[edge.ends[0]]);
  Vector3 sum{0, 0, 0};
  SignedAxis carried = turn.axis;
  for (const Crossing& crossing : complex_->around(inner_edge)) {
    carried = group_->image(across(crossing), carried);
    sum += axis_in_space(frames_[complex_->solid().inner_faces[crossing.face].tets[!crossing.reversed]],
                         carried);
  }
  turn.cosine = dot(normalised(sum), along);
  return turn;
}

Vector3 MatchedField::turning_around(std::uint32_t inner_edge) const {
  Vector3 sum{0, 0, 0};
  for (const Crossing& crossing : complex_->around(inner_edge)) {
    const auto& tets = complex_->solid().inner_faces[crossing.face].tets;
    const Quaternion& from = frames_[tets[crossing.reversed ? 1 : 0]];
    const Quaternion& to = frames_[tets[crossing.reversed ? 0 : 1]];
    const Quaternion step = to * to_quaternion((*group_)[across(crossing)]) * conjugate(from);
    // A step of nearly half a turn has no sense.
    constexpr double kNoStep = 0.1;
    if (std::abs(step.w) < kNoStep) continue;
    const double twice = step.w < 0 ? -2 : 2;
    sum += Vector3{twice * step.x, twice * step.y, twice * step.z};
  }
  return sum;
}

BoundaryTurn MatchedField::boundary_turn(std::uint32_t boundary_edge) const {
  const TetComplex::Edge& edge = complex_->edges()[boundary_edge];
  BoundaryTurn turn{2, angles_deg_[boundary_edge]};
  if (edge.is_branched) return turn;
  const SignedAxis carried = group_->image(holonomy(boundary_edge), normal_axis(edge.boundary_faces[0]));
  const SignedAxis arrives = normal_axis(edge.boundary_faces[1]);
  if (carried == arrives) return turn;
  if (carried == opposite(arrives)) {
    turn.hexahedra = turn.angle_deg < 180 ? 0 : 4;
  } else if (std::abs(turn.angle_deg - 180) > kConvexDeg) {
    turn.hexahedra = turn.angle_deg < 180 ? 1 : 3;
  } else {
    const std::vector<Vector3>& vertices = complex_->solid().mesh.vertices;
    const Vector3 along = vertices[edge.ends[1]] - vertices[edge.ends[0]];
    const std::uint32_t last = complex_->solid().boundary_tets[edge.boundary_faces[1]];
    turn.hexahedra = dot(axis_in_space(frames_[last], cross_of(carried, arrives)), along) > 0 ? 3 : 1;
  }
  return turn;
}

std::optional<MatchedField::Border> MatchedField::border_of(std::uint32_t vertex) const {
  // Seen from outside, counter-clockwise: the way from a face to the next through the solid is right-handed
  // about the direction of the edge between them away from the vertex.
  const std::span<const TetComplex::RingFace> ring = complex_->ring(vertex);
  const std::size_t count = ring.size();
  const auto carry = [&](std::size_t k, SignedAxis axis, bool back = false) {
    const std::uint32_t edge = ring[k].edge;
    std::uint8_t product = holonomy(edge);
    if ((complex_->edges()[edge].ends[0] == vertex) == back) product = group_->inverse_of(product);
    return group_->image(product, axis);
  };
  const auto normal = [&](std::size_t k) { return normal_axis(ring[k % count].face); };

  /// Hexahedra at each edge of the ring, and the axis along it away from the vertex, in the next face.
  std::vector<int> hexahedra(count, 2);
  std::vector<SignedAxis> along(count, 0);
  std::size_t first = count;
  for (std::size_t k = 0; k < count; ++k) {
    hexahedra[k] = boundary_turn(ring[k].edge).hexahedra;
    if (hexahedra[k] == 0 || hexahedra[k] == 4) return std::nullopt;
    if (hexahedra[k] == 2) continue;
    const SignedAxis carried = carry(k, normal(k)), arrives = normal(k + 1);
    along[k] = hexahedra[k] == 3 ? cross_of(carried, arrives) : cross_of(arrives, carried);
    if (first == count) first = k;
  }
  Border border;
  if (first == count) {
    SignedAxis axis = (normal(0) % 3 + 1) % 3;
    const SignedAxis start = axis;
    for (std::size_t k = 0; k < count; ++k) axis = carry(k, axis);
    // A cone of s quadrants turns what is carried around it by 4 - s of them.
    border.sectors.push_back(4 - quarters(normal(0), start, axis));
    border.is_open.push_back(true);
    return border;
  }
  SignedAxis carried = along[first];
  double angle = 0;
  border.creases.push_back(hexahedra[first]);
  for (std::size_t step = 1; step <= count; ++step) {
    const std::size_t k = (first + step) % count;
    angle += ring[k].angle_rad;
    if (hexahedra[k] == 2) {
      carried = carry(k, carried);
      continue;
    }
    int sector = quarters(normal(k), carried, carry(k, along[k], /*back=*/true));
    if (sector == 0 && angle > std::numbers::pi) sector = 4;
    border.sectors.push_back(sector);
    border.is_open.push_back(angle > 1.25 * std::numbers::pi);
    if (step < count) border.creases.push_back(hexahedra[k]);
    carried = along[k];
    angle = 0;
  }
  return border;
}

VertexState MatchedField::vertex_state(std::uint32_t vertex) const {
  if (complex_->is_pinched(vertex)) return VertexState::kUnknown;
  std::vector<int> valences;
  std::vector<std::size_t> of_any_sense;
  for (const std::uint32_t edge : complex_->edges_at(vertex)) {
    if (complex_->edges()[edge].is_on_boundary() || !is_singular(edge)) continue;
    const EdgeTurn turn = turn_around(edge);
    if (!turn.may_be_meshed()) return VertexState::kImpossible;
    const std::optional<int> valence = turn.has_sense() ? turn.valence() : valence_along(vertex, edge);
    if (!valence) of_any_sense.push_back(valences.size());
    valences.push_back(valence.value_or(turn.valence()));
  }
  const bool is_inside = complex_->ring(vertex).empty();
  if (is_inside && valences.empty()) return VertexState::kPossible;
  std::optional<Border> border;
  if (!is_inside && !(border = border_of(vertex))) return VertexState::kImpossible;
  constexpr std::size_t kMostOfAnySense = 4;
  if (of_any_sense.size() > kMostOfAnySense) of_any_sense.resize(kMostOfAnySense);
  bool is_unknown = false;
  for (std::size_t choice = 0; choice < std::size_t{1} << of_any_sense.size(); ++choice) {
    std::vector<int> chosen = valences;
    for (std::size_t k = 0; k < of_any_sense.size(); ++k)
      if (choice >> k & 1) chosen[of_any_sense[k]] = 8 - chosen[of_any_sense[k]];
    const VertexState state = is_inside ? state_inside(chosen) : state_with(*border, chosen);
    if (state == VertexState::kPossible) return state;
    is_unknown |= state == VertexState::kUnknown;
  }
  return is_unknown ? VertexState::kUnknown : VertexState::kImpossible;
}

bool MatchedField::is_map_corner(std::uint32_t vertex) const {
  const std::optional<Border> border = border_of(vertex);
  if (!border) return true;
  constexpr int kStraight = 2;  // quarter turns
  return !border->creases.empty() &&
         (border->creases.size() != 2 || border->sectors[0] != kStraight || border->sectors[1] != kStraight);
}

std::uint32_t MatchedField::edge_beyond(std::uint32_t vertex, std::uint32_t edge) const {
  if (complex_->is_on_boundary(vertex)) return kNoEdge;
  std::uint32_t beyond = kNoEdge;
  for (const std::uint32_t other : complex_->edges_at(vertex)) {
    if (other == edge || !is_singular(other)) continue;
    if (beyond != kNoEdge) return kNoEdge;
    beyond = other;
  }
  return beyond;
}

std::optional<int> MatchedField::valence_along(std::uint32_t vertex, std::uint32_t edge) const {
  std::optional<int> valence;
  walk_arc(vertex, edge, [&](std::uint32_t at, std::uint32_t) {
    const EdgeTurn turn = turn_around(at);
    if (turn.kind != EdgeTurn::Kind::kOther && turn.has_sense()) valence = turn.valence();
    return !valence;
  });
  return valence;
}

std::vector<int> MatchedField::valences_at(std::uint32_t vertex) const {
  std::vector<int> valences;
  for (const std::uint32_t edge : complex_->edges_at(vertex)) {
    if (complex_->edges()[edge].is_on_boundary()) continue;
    const EdgeTurn turn = turn_around(edge);
    if (turn.kind == EdgeTurn::Kind::kNone) continue;
    valences.push_back(turn.has_sense() ? turn.valence()
                                        : valence_along(vertex, edge).value_or(turn.valence()));
  }
  return valences;
}

std::vector<int> MatchedField::creases_at(std::uint32_t vertex) const {
  std::vector<int> creases;
  for (const TetComplex::RingFace& at : complex_->ring(vertex))
    if (const int k = boundary_turn(at.edge).hexahedra; k != 2) creases.push_back(k);
  return creases;
}

VertexState MatchedField::state_inside(const std::vector<int>& valences) const {
  // One line that goes on as it came; where its sense changes, the arc has a turning point.
  if (valences.size() == 2 && valences[0] == valences[1] && valences[0] > 2) return VertexState::kPossible;
  if (valences.size() < 3) return VertexState::kImpossible;
  if (std::find(valences.begin(), valences.end(), 2) != valences.end()) return VertexState::kImpossible;
  return stated(has_link({}, valences));
}

VertexState MatchedField::stated(std::optional<bool> has_link) {
  if (!has_link) return VertexState::kUnknown;
  return *has_link ? VertexState::kPossible : VertexState::kImpossible;
}

VertexState MatchedField::state_with(const Border& border, const std::vector<int>& valences) const {
  if (std::find(valences.begin(), valences.end(), 2) != valences.end()) return VertexState::kImpossible;
  bool is_unknown = false;
  const std::size_t open =
      static_cast<std::size_t>(std::count(border.is_open.begin(), border.is_open.end(), true));
  for (std::size_t choice = 0; choice < std::size_t{1} << open; ++choice) {
    std::vector<int> full;
    std::size_t bit = 0;
    bool is_empty = false;
    for (std::size_t k = 0; k < border.sectors.size(); ++k) {
      int sector = border.sectors[k];
      if (border.is_open[k] && choice >> bit++ & 1) sector += 4;
      is_empty |= sector < 1;
      if (!border.creases.empty()) full.push_back(border.creases[k]);
      full.insert(full.end(),
                  static_cast<std::size_t>(std::max(0, border.creases.empty() ? sector : sector - 1)), 2);
    }
    if (is_empty) continue;
    const VertexState state = stated(has_link(full, valences));
    if (state == VertexState::kPossible) return state;
    is_unknown |= state == VertexState::kUnknown;
  }
  return is_unknown ? VertexState::kUnknown : VertexState::kImpossible;
}

std::optional<bool> MatchedField::has_link(std::vector<int> border, std::vector<int> valences) const {
  std::sort(valences.begin(), valences.end());
  border = canonical(border);
  const auto [known, is_new] = links_.try_emplace({border, valences}, std::nullopt);
  if (is_new) known->second = border.empty() ? has_inner_link(valences) : has_link_within(border, valences);
  return known->second;
}

}  // namespace crossgrain
