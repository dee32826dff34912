// SPDX-License-Identifier: Apache-2.0
// Classes of the vertices of a tet mesh's boundary, and of the faces inside that frames follow: smooth,
// crease or corner.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/types.hpp"
#include "surface/crease_angles.hpp"
#include "tets/inner_walls.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

struct BoundaryVertexOptions {
  /// Largest angle between the normals of a smooth vertex's faces and their area-weighted mean (exclusive).
  double smooth_spread_deg = 15;

  /// Smallest angle between the normals of the two faces of a sharp edge (exclusive). At twice the smooth
  /// spread no smooth vertex has a sharp edge.
  double sharp_dihedral_deg = 30;

  /// Which sharp edges count that end in the smooth surface.
  FadingCreases fading = {};

  /// Largest change of direction between two sharp edges of one crease (exclusive).
  double crease_turn_deg = 45;
};

enum class BoundaryClass : std::uint8_t {
  kSmooth,  ///< one normal describes all faces
  kCrease,  ///< two sharp or tagged edges that continue each other, or the end of tagged ones: a tangent
  kCorner   ///< all others: sharp edges end, meet or change direction, or the boundary curves within one face
};

struct FaceAtVertex {
  Vector3 normal;     ///< unit, outward; at a vertex of walls, on the side of its first face's normal
  double area_third;  ///< one third of the area of the face
};

/// The vertices of boundary faces, of walls inside and of tagged edges, ascending, with their classes. Faces
/// without area are ignored. The two sides of a wall are equivalent: at vertices of walls normals count up to
/// sign.
struct BoundaryVertices {
  std::vector<std::uint32_t> vertices;
  std::vector<Vector3> normals;    ///< unit area-weighted mean; {0, 0, 0} if opposite faces cancel
  std::vector<double> spread_deg;  ///< largest angle between it and a face's normal; 180 without faces
  std::vector<BoundaryClass> classes;
  std::vector<Vector3> tangents;  ///< unit, of either sign: along creases; at smooth vertices along a tagged
                                  ///< edge, across the normal; {0, 0, 0} for all others

  std::vector<std::uint32_t> face_begin;  ///< start of each vertex in `faces`, and the end
  std::vector<FaceAtVertex> faces;        ///< vertex k from face_begin[k], in the order of solid.boundary

  std::size_t size() const { return vertices.size(); }

  std::span<const FaceAtVertex> faces_at(std::size_t k) const {
    return {faces.data() + face_begin[k], face_begin[k + 1] - face_begin[k]};
  }
};

/// Features besides the boundary.
struct InnerFeatures {
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< tagged edges, including those on the boundary
};

/// The walls as faces, and the tagged edges of a mesh. `unite` excludes walls between regions and edges along
/// them; such an edge may still be sharp.
InnerFeatures features_of(const TetSolid& solid, const std::vector<InnerWall>& walls, bool unite);

/// The edges that make a vertex a crease or corner: edges of two faces with an angle that counts, of more
/// than two faces, and tagged edges; ascending.
std::vector<std::array<std::uint32_t, 2>> crease_edges(const TetSolid& solid,
                                                       const BoundaryVertexOptions& options = {},
                                                       const InnerFeatures& features = {});

BoundaryVertices classify_boundary_vertices(const TetSolid& solid, const BoundaryVertexOptions& options = {},
                                            const InnerFeatures& features = {});

}  // namespace crossgrain
