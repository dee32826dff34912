// SPDX-License-Identifier: Apache-2.0
// What the boundary of a tet mesh, and the faces inside that frames follow, look like at each of their
// vertices: smooth, a crease or a corner.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/types.hpp"
#include "tets/inner_walls.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

struct BoundaryVertexOptions {
  /// A vertex is smooth where the normals of all its faces are closer than this to their area-weighted mean.
  double smooth_spread_deg = 15;

  /// An edge is sharp where the normals of its two faces differ by more. At twice the smooth spread no
  /// smooth vertex has a sharp edge.
  double sharp_dihedral_deg = 30;

  /// Two sharp edges are one crease where its direction turns by less from one to the other.
  double crease_turn_deg = 45;
};

enum class BoundaryClass : std::uint8_t {
  kSmooth,  ///< one normal tells all
  kCrease,  ///< two sharp or tagged edges that go on in each other, or the end of tagged ones: a tangent
  kCorner   ///< all others: sharp edges end, meet or turn, or the boundary curves within one face
};

struct FaceAtVertex {
  Vector3 normal;     ///< unit, outward; of a vertex of walls, on the side of that of its first face
  double area_third;  ///< a third of the face's area
};

/// Lists run over the vertices of boundary faces, of walls inside and of tagged edges, ascending. Faces
/// without area count nowhere. Of walls either side is as good as the other: where a vertex has any, normals
/// count up to their sign.
struct BoundaryVertices {
  std::vector<std::uint32_t> vertices;
  std::vector<Vector3> normals;    ///< unit area-weighted mean; {0, 0, 0} where opposite faces cancel
  std::vector<double> spread_deg;  ///< largest angle of a face's normal to it; 180 where there is no face
  std::vector<BoundaryClass> classes;
  std::vector<Vector3> tangents;  ///< of creases: unit, of either sign; of smooth vertices that of a tagged
                                  ///< edge through them, across the normal; {0, 0, 0} for all others

  std::vector<std::uint32_t> face_begin;  ///< one more than vertices
  std::vector<FaceAtVertex> faces;        ///< of vertex k: from face_begin[k], in the order of solid.boundary

  std::size_t size() const { return vertices.size(); }

  std::span<const FaceAtVertex> faces_at(std::size_t k) const {
    return {faces.data() + face_begin[k], face_begin[k + 1] - face_begin[k]};
  }
};

/// What there is inside beside the boundary.
struct InnerFeatures {
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< tagged ones; those on the boundary too
};

/// The walls as faces and the tagged edges of a mesh. `unite`: without walls between regions and without
/// edges along these; such an edge may still be sharp.
InnerFeatures features_of(const TetSolid& solid, const std::vector<InnerWall>& walls, bool unite);

BoundaryVertices classify_boundary_vertices(const TetSolid& solid, const BoundaryVertexOptions& options = {},
                                            const InnerFeatures& features = {});

}  // namespace crossgrain
