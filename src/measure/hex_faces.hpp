// SPDX-License-Identifier: Apache-2.0
// Faces and edges of hexahedra.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "crossgrain/hex_mesh.hpp"

namespace crossgrain {

/// Corners of the six faces of a hexahedron, outward by the right-hand rule.
inline constexpr std::array<std::array<std::uint8_t, 4>, 6> kHexFaces{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

inline constexpr std::array<std::array<std::uint8_t, 2>, 12> kHexEdges{
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

/// The three corners next to each corner of a hexahedron, right-handed.
inline constexpr std::array<std::array<std::uint8_t, 3>, 8> kHexNeighbours{
    {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};

/// Vertices, outward, of side 6 h + s: side s of hexahedron h.
inline std::array<std::uint32_t, 4> corners_of_side(const HexMesh& mesh, std::uint32_t side) {
  const auto& hexahedron = mesh.hexahedra[side / 6];
  const auto& [a, b, c, d] = kHexFaces[side % 6];
  return {hexahedron[a], hexahedron[b], hexahedron[c], hexahedron[d]};
}

/// The sides of hexahedra, those of the same vertices together.
class SideGroups {
 public:
  explicit SideGroups(const HexMesh& mesh);

  /// Calls visit(sides) for each set of vertices, ascending by these, with the sides that have it, ascending.
  template <class Visit>
  void for_each(const Visit& visit) const {
    Checkpoint checkpoint;
    for (std::size_t k = 0; k < sides_.size();) {
      checkpoint.pass();
      std::size_t end = k + 1;
      while (end < sides_.size() && !is_first_[end]) ++end;
      visit(std::span<const std::uint32_t>(sides_).subspan(k, end - k));
      k = end;
    }
  }

 private:
  std::vector<std::uint32_t> sides_;
  std::vector<std::uint8_t> is_first_;  ///< of each of these, whether it is the first of its vertices
};

struct HexSide {
  std::array<std::uint32_t, 4> vertices;  ///< outward
  std::uint32_t hexahedron;
};

/// How hexahedra hang together.
struct HexTopology {
  std::vector<HexSide> boundary;  ///< faces of only one hexahedron, in the order of these

  std::size_t crowded_faces = 0;  ///< faces of more than two hexahedra, or on the same side of two
  std::size_t open_edges = 0;     ///< edges at which the boundary is no closed surface: not two of its faces
  std::size_t pinched_vertices = 0;  ///< at which more than one fan of boundary faces meet

  /// Number of edges with k hexahedra around them, at index k: of edges inside, and of the boundary.
  std::vector<std::size_t> inner_valences, boundary_valences;

  bool is_closed() const { return crowded_faces == 0 && open_edges == 0; }
};

/// A face between two hexahedra.
struct HexInnerFace {
  std::array<std::uint32_t, 4> vertices;  ///< outward from the first
  std::array<std::uint32_t, 2> hexahedra;
};

/// Returns the faces of just two hexahedra, ascending by vertices.
std::vector<HexInnerFace> inner_faces_of(const HexMesh& mesh);

/// Returns the number of sets of hexahedra that are connected over faces.
std::size_t count_bodies(const HexMesh& mesh);

/// Returns HexTopology::boundary alone.
std::vector<HexSide> boundary_of(const HexMesh& mesh);

HexTopology topology_of(const HexMesh& mesh);

}  // namespace crossgrain
