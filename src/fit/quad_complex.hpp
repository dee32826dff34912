// SPDX-License-Identifier: Apache-2.0
// The surface of a mesh of hexahedra: its quads with their edges and vertices.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/lists.hpp"
#include "crossgrain/hex_mesh.hpp"

namespace crossgrain {

/// Faces of hexahedra at which solids end: those of only one hexahedron, and those between two solids. All
/// vertices are those of the mesh.
///
/// Solids have numbers above 0; 0 is outside. A quad looks by the right-hand rule from the solid of the
/// higher number, `below`, to the other, `above`; so do the faces of a FeatureComplex.
class QuadComplex {
 public:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  struct Quad {
    std::array<std::uint32_t, 4> vertices;
    std::array<std::uint32_t, 4> edges;  ///< edges[k] is between vertices[k] and the next
    std::int32_t below, above;
    std::uint32_t hexahedron_below, hexahedron_above;  ///< the second is kNone outside
  };

  /// A quad at an edge.
  struct Use {
    std::uint32_t quad;
    bool is_left;  ///< of the edge from its first to its second vertex, seen from above
  };

  /// Quads of hexahedra in solids of one number, 1, whatever their regions.
  explicit QuadComplex(const HexMesh& mesh);

  /// `solids`: number of each hexahedron's, above 0.
  QuadComplex(const HexMesh& mesh, std::span<const std::int32_t> solids);

  const std::vector<Quad>& quads() const { return quads_; }

  /// Ends of the edges, ascending, in ascending order.
  const std::vector<std::array<std::uint32_t, 2>>& edges() const { return edges_; }

  /// Vertices on quads, ascending.
  const std::vector<std::uint32_t>& vertices() const { return vertices_; }

  std::span<const Use> uses_of_edge(std::uint32_t edge) const { return uses_[edge]; }

  /// Edges at a vertex of the mesh, ascending; none inside.
  std::span<const std::uint32_t> edges_of(std::uint32_t vertex) const { return edges_of_[vertex]; }
  std::span<const std::uint32_t> quads_of(std::uint32_t vertex) const { return quads_of_[vertex]; }

  /// Returns the edge between two vertices, or kNone.
  std::uint32_t edge_between(std::uint32_t a, std::uint32_t b) const;

  std::uint32_t other_end(std::uint32_t edge, std::uint32_t vertex) const {
    return edges_[edge][0] == vertex ? edges_[edge][1] : edges_[edge][0];
  }

  /// Edges of a quad at one of its vertices. Seen from above the quad lies counter-clockwise from the first
  /// to the second.
  std::array<std::uint32_t, 2> edges_at(std::uint32_t quad, std::uint32_t vertex) const;

  /// Returns the quad across an edge between the same two solids, or kNone if there is not just one that
  /// continues this one.
  std::uint32_t across(std::uint32_t quad, std::uint32_t edge) const;

  /// Returns the quads around a vertex from one on, counter-clockwise seen from above, up to the first edge
  /// for which `ends(edge)`, at most once around. `last` becomes that edge; kNone if the quads end before, at
  /// an edge that has nothing across.
  template <class Ends>
  std::vector<std::uint32_t> around(std::uint32_t vertex, std::uint32_t from, const Ends& ends,
                                    std::uint32_t& last) const {
    std::vector<std::uint32_t> fan{from};
    for (;;) {
      last = edges_at(fan.back(), vertex)[1];
      if (ends(last)) return fan;
      const std::uint32_t next = across(fan.back(), last);
      if (next == from) return fan;
      if (next == kNone) {
        last = kNone;
        return fan;
      }
      fan.push_back(next);
    }
  }

 private:
  void add_quads(const HexMesh& mesh, std::span<const std::int32_t> solids);
  void join_quads(std::size_t mesh_vertices);

  std::vector<Quad> quads_;
  std::vector<std::array<std::uint32_t, 2>> edges_;
  std::vector<std::uint32_t> vertices_;
  Lists<Use> uses_;
  Lists<std::uint32_t> edges_of_, quads_of_;
};

/// Half the cross product of its diagonals: its area times its mean normal, towards `above`.
Vector3 area_vector(const HexMesh& mesh, const QuadComplex::Quad& quad);

}  // namespace crossgrain
