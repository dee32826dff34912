// SPDX-License-Identifier: Apache-2.0
// Splits of tets at the middles of edges, faces and tets.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "crossgrain/types.hpp"
#include "tets/split_simplices.hpp"

namespace crossgrain {

/// The vertices of which a new vertex is the mean; each has a lower number, and may be new itself.
struct MeanOfVertices {
  std::array<std::uint32_t, 4> vertices{UINT32_MAX, UINT32_MAX, UINT32_MAX, UINT32_MAX};  ///< ascending
  std::uint8_t count = 0;  ///< how many are used: 2 in an edge, 3 in a face, 4 in a tet

  std::span<const std::uint32_t> used() const { return {vertices.data(), count}; }
};

/// A mesh after splits.
struct SplitTetMesh {
  /// First the given vertices, then the new ones. A tet, tagged edge or tagged face that was not split keeps
  /// its place; parts of one that was split take its place and the end of the list, and inherit its tag or
  /// region.
  TetMesh mesh;
  std::vector<std::uint32_t> parents;        ///< for each tet the given one of which it is a part
  std::vector<MeanOfVertices> new_vertices;  ///< the last vertices of the mesh
};

/// A tet mesh, split step by step: edges at the middle, faces and tets at the centroid. A split replaces all
/// tets around an edge, face or tet, and so keeps the mesh conforming, the orientations of tets and the
/// boundary as a set of points. The result depends on the mesh and the order of splits only.
///
/// A split is refused if rounding would leave a tet flat, or of other orientation, that comes from one that
/// is neither (TetShape); the mesh is then unchanged. The limit of flatness is a thousand times the rounding
/// error of a volume, so all other volumes have exactly the sign that was computed. Parts of flat tets are
/// not checked: such tets keep faces conforming.
class TetSplits {
 public:
  /// Tets must have four distinct vertices in range (`prepare_tets`).
  explicit TetSplits(TetMesh mesh);

  /// Each returns the new vertex; none if the split is refused or no tet has these distinct vertices.
  std::optional<std::uint32_t> split_edge(std::uint32_t a, std::uint32_t b);
  std::optional<std::uint32_t> split_face(const std::array<std::uint32_t, 3>& vertices);
  std::optional<std::uint32_t> split_tet(std::uint32_t tet);

  const std::vector<Vector3>& vertices() const { return given_.vertices; }
  const std::vector<std::array<std::uint32_t, 4>>& tets() const { return tets_.simplices(); }
  const std::vector<std::uint32_t>& parents() const { return tets_.parents(); }

  SplitTetMesh result() const;

 private:
  std::optional<std::uint32_t> split(std::span<const std::uint32_t> vertices);

  /// Whether a split at the last vertex keeps the shape of all parts of a tet.
  bool keeps_shape(std::uint32_t tet, std::span<const std::uint32_t> vertices) const;

  TetMesh given_;  ///< with the new vertices
  SplitSimplices<4> tets_;
  SplitSimplices<3> tagged_faces_;
  SplitSimplices<2> tagged_edges_;
  std::vector<MeanOfVertices> new_vertices_;
};

}  // namespace crossgrain
