// SPDX-License-Identifier: Apache-2.0
// The edges of a tet mesh with the faces around them, for matchings that change.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/lists.hpp"
#include "tets/boundary_vertices.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// A face of a boundary at a vertex or an edge that is none.
inline constexpr std::uint32_t kNoFace = UINT32_MAX, kNoEdge = UINT32_MAX;

class ListTable : public Lists<std::uint32_t> {
 public:
  ListTable() = default;

  /// Takes pairs of a list and an entry; entries of a list keep their order.
  ListTable(std::size_t lists, std::span<const std::array<std::uint32_t, 2>> pairs)
      : Lists(lists, [&](const auto& add) {
          for (const auto& [list, entry] : pairs) add(list, entry);
        }) {}
};

/// The way through a face, from the tet on one side to that on the other.
struct Crossing {
  std::uint32_t face;  ///< index into TetSolid::inner_faces
  bool reversed;       ///< from the second tet of the face to the first
};

/// For each tet the way through the face opposite each corner; kNoFace on the surface.
std::vector<std::array<Crossing, 4>> crossings_of(const TetSolid& solid);

/// The edges, faces and stars of a solid. `solid` must outlive it and have no flat tets (kNoTet) beside inner
/// faces.
class TetComplex {
 public:
  explicit TetComplex(const TetSolid& solid, const InnerFeatures& features = {});

  struct Edge {
    std::array<std::uint32_t, 2> ends;  ///< ascending
    double length;
    std::uint32_t first_tet;  ///< where the way around begins

    /// The boundary faces at which the way around begins and ends; kNoFace inside the solid.
    std::array<std::uint32_t, 2> boundary_faces;

    /// Whether the tets around the edge are not one way: the boundary is no surface there.
    bool is_branched;

    bool is_on_boundary() const { return boundary_faces[0] != kNoFace; }
  };

  const TetSolid& solid() const { return *solid_; }
  const std::vector<Edge>& edges() const { return edges_; }

  /// The crossings around an edge, right-handed about the direction from its first end to its second: all
  /// around inside the solid, otherwise from boundary face to boundary face.
  std::span<const Crossing> around(std::uint32_t edge) const {
    return {crossings_.data() + around_begins_[edge], around_begins_[edge + 1] - around_begins_[edge]};
  }

  std::uint32_t edge_between(std::uint32_t a, std::uint32_t b) const;
  const std::array<std::uint32_t, 3>& edges_of_face(std::uint32_t inner_face) const {
    return face_edges_[inner_face];
  }
  std::span<const std::uint32_t> edges_at(std::uint32_t vertex) const { return vertex_edges_[vertex]; }
  std::span<const std::uint32_t> faces_at(std::uint32_t vertex) const { return vertex_faces_[vertex]; }

  bool is_on_boundary(std::uint32_t vertex) const { return !rings_[vertex].empty() || is_pinched(vertex); }

  /// The boundary around a vertex.
  struct RingFace {
    std::uint32_t face;  ///< index into TetSolid::boundary
    std::uint32_t edge;  ///< the edge at the vertex between this face and the next
    double angle_rad;    ///< of the face at the vertex
  };

  /// Counter-clockwise seen from outside; empty inside the solid and at pinched vertices.
  std::span<const RingFace> ring(std::uint32_t vertex) const { return rings_[vertex]; }

  /// Whether the boundary at the vertex is not one fan of faces.
  bool is_pinched(std::uint32_t vertex) const { return is_pinched_[vertex] != 0; }

  /// The features that frames follow: indices into TetSolid::inner_faces, and of edges.
  const std::vector<std::uint32_t>& wall_faces() const { return wall_faces_; }
  const std::vector<std::uint32_t>& feature_edges() const { return feature_edges_; }

  /// Unit normals of the boundary faces, outward.
  const std::vector<Vector3>& boundary_normals() const { return boundary_normals_; }

  double mean_edge_length() const { return mean_edge_length_; }

 private:
  void find_edges();
  void find_rings();

  const TetSolid* solid_;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> around_begins_;
  std::vector<Crossing> crossings_;
  std::vector<std::array<std::uint32_t, 3>> face_edges_;
  ListTable vertex_edges_, vertex_faces_;
  std::vector<std::vector<RingFace>> rings_;
  std::vector<std::uint8_t> is_pinched_;
  std::vector<std::uint32_t> wall_faces_, feature_edges_;
  std::vector<Vector3> boundary_normals_;
  double mean_edge_length_ = 0;
};

}  // namespace crossgrain
