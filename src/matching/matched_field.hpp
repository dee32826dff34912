// SPDX-License-Identifier: Apache-2.0
// Frames of tets with matchings that need not be the nearest, and what they say about edges and vertices.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/quaternion.hpp"
#include "base/vector3.hpp"
#include "matching/tet_complex.hpp"
#include "singularity/cube_group.hpp"
#include "singularity/matching.hpp"

namespace crossgrain {

/// Cosine between an edge and its axis below which the edge has no sense of its own.
inline constexpr double kNoSense = 0.25;

/// What is around an inner edge.
struct EdgeTurn {
  enum class Kind : std::uint8_t {
    kNone,     ///< regular
    kQuarter,  ///< a quarter turn about an axis: 3 or 5 hexahedra
    kHalf,     ///< a half turn about an axis: 2 or 6 hexahedra
    kOther     ///< a rotation about a diagonal, which no hexahedra have
  };
  Kind kind = Kind::kNone;

  /// The axis about which frames turn by a positive angle, for the direction from the first end to the
  /// second, as one of the first tet; not for kNone and kOther.
  SignedAxis axis = 0;

  /// Between the axis, averaged over the tets around, and the direction of the edge.
  double cosine = 0;

  /// Whether hexahedra can be around it: not two of them, as half turns of the other sense have.
  bool may_be_meshed() const {
    return kind == Kind::kNone || kind == Kind::kQuarter || (kind == Kind::kHalf && cosine < -kNoSense);
  }

  bool has_sense() const { return std::abs(cosine) >= kNoSense; }

  /// Number of hexahedra, by the sign of the cosine.
  int valence() const {
    const int quarters = kind == Kind::kQuarter ? 1 : kind == Kind::kHalf ? 2 : 0;
    return cosine > 0 ? 4 - quarters : 4 + quarters;
  }
};

/// What is between the two faces at an edge of the boundary.
struct BoundaryTurn {
  int hexahedra = 2;       ///< quarter turns of the solid in the map, 0 to 4
  double angle_deg = 180;  ///< of the solid
};

/// Whether hexahedra can meet at a vertex.
enum class VertexState : std::uint8_t {
  kPossible,
  kImpossible,
  kUnknown  ///< the boundary is not a surface there, or there are too many hexahedra to say
};

/// Frames of tets with a matching across each inner face.
class MatchedField {
 public:
  /// Takes the nearest matchings. `complex` and `frames` must outlive it; one frame per tet.
  MatchedField(const TetComplex& complex, std::span<const Quaternion> frames);
  MatchedField(const TetComplex& complex, std::span<const Quaternion> frames,
               std::span<const CubeRotation> matchings);

  /// The same matchings and axes of faces with other frames, which must outlive it.
  MatchedField with_frames(std::span<const Quaternion> frames) const;

  const TetComplex& complex() const { return *complex_; }
  std::span<const Quaternion> frames() const { return frames_; }

  std::uint8_t matching(std::uint32_t face) const { return matchings_[face]; }
  void set_matching(std::uint32_t face, std::uint8_t matching) { matchings_[face] = matching; }
  std::vector<CubeRotation> matchings() const;

  /// Carries frames across a face.
  std::uint8_t across(const Crossing& crossing) const {
    const std::uint8_t matching = matchings_[crossing.face];
    return crossing.reversed ? group_->inverse_of(matching) : matching;
  }

  /// The product of all matchings around an edge, starting in its first tet.
  std::uint8_t holonomy(std::uint32_t edge) const;

  bool is_singular(std::uint32_t inner_edge) const { return holonomy(inner_edge) != CubeGroup::kIdentity; }

  /// The holonomy that an edge should have in place of `now`: none around an inner edge; on the boundary the
  /// one that differs from it by the smallest rotation about the edge, so that the map has as many quarter
  /// turns as the geometry, at least one. None where no axis across the normals is nearest to the edge.
  std::optional<std::uint8_t> wanted_holonomy(std::uint32_t edge, std::uint8_t now) const;

  EdgeTurn turn_around(std::uint32_t inner_edge) const;

  /// Calls visit(edge, vertex) for each edge of the arc that leaves a vertex along an edge, with the far end,
  /// up to the first edge that `visit` returns false for; and no further than to a node, the surface, or
  /// kLongestWay edges.
  template <typename Visit>
  void walk_arc(std::uint32_t vertex, std::uint32_t edge, const Visit& visit) const;
  BoundaryTurn boundary_turn(std::uint32_t boundary_edge) const;

  /// The axis of the tet behind a boundary face that is nearest to its outward normal.
  SignedAxis normal_axis(std::uint32_t boundary_face) const { return normal_axes_[boundary_face]; }

  /// Whether hexahedra can meet at a vertex as its edges say: the link of the vertex has a triangulation with
  /// a vertex of valence n for each singular edge and, on the boundary, a border with k triangles at each
  /// crease and as many quarter turns between creases as the map has there (singularity/vertex_link.hpp).
  VertexState vertex_state(std::uint32_t vertex) const;

  /// Whether a map has a corner of the solid at a vertex of the boundary: edges there that are bent in the
  /// map (other than two hexahedra), unless these are two that go straight on.
  bool is_map_corner(std::uint32_t vertex) const;

  /// Numbers of hexahedra of the singular edges at a vertex, and of the edges of the boundary around it, in
  /// cyclic order without those of 2.
  std::vector<int> valences_at(std::uint32_t vertex) const;
  std::vector<int> creases_at(std::uint32_t vertex) const;

 private:
  /// The only other singular inner edge at a vertex inside, or kNoEdge.
  std::uint32_t edge_beyond(std::uint32_t vertex, std::uint32_t edge) const;

  /// Number of hexahedra around an arc, as its first edge with a sense says, seen from a vertex along one of
  /// its edges; none if that is not found.
  std::optional<int> valence_along(std::uint32_t vertex, std::uint32_t edge) const;

  /// The sum of the rotation vectors, to first order, of frames on the way around an edge: the sense of a
  /// half turn, which is the same rotation in either.
  Vector3 turning_around(std::uint32_t inner_edge) const;

  /// The border of the link of a boundary vertex.
  struct Border {
    std::vector<int> creases;   ///< k of each crease, counter-clockwise
    std::vector<int> sectors;   ///< quarter turns from each crease to the next; all around without creases
    std::vector<bool> is_open;  ///< whether four quarter turns more are possible in that sector
  };
  std::optional<Border> border_of(std::uint32_t vertex) const;
  VertexState state_inside(const std::vector<int>& valences) const;
  static VertexState stated(std::optional<bool> has_link);
  VertexState state_with(const Border& border, const std::vector<int>& valences) const;
  std::optional<bool> has_link(std::vector<int> border, std::vector<int> valences) const;

  const TetComplex* complex_;
  std::span<const Quaternion> frames_;
  const CubeGroup* group_ = &CubeGroup::instance();
  std::vector<std::uint8_t> matchings_;
  std::vector<SignedAxis> normal_axes_;
  std::vector<double> angles_deg_;  ///< of the solid at boundary edges

  /// Links that were searched for; not safe to use from several threads.
  mutable std::map<std::pair<std::vector<int>, std::vector<int>>, std::optional<bool>> links_;
};

template <typename Visit>
void MatchedField::walk_arc(std::uint32_t vertex, std::uint32_t edge, const Visit& visit) const {
  constexpr int kLongestWay = 256;
  for (int step = 0; step < kLongestWay && edge != kNoEdge; ++step) {
    const auto& ends = complex_->edges()[edge].ends;
    vertex = ends[0] == vertex ? ends[1] : ends[0];
    if (!visit(edge, vertex)) return;
    edge = edge_beyond(vertex, edge);
  }
}

}  // namespace crossgrain
