// SPDX-License-Identifier: Apache-2.0
// What the boundary of a tet mesh looks like at each of its vertices: smooth, a crease or a corner.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/types.hpp"
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
  kCrease,  ///< two sharp edges that go on in each other: there is a tangent
  kCorner   ///< all others: sharp edges end, meet or turn, or the boundary curves within one face
};

struct FaceAtVertex {
  Vector3 normal;     ///< unit, outward
  double area_third;  ///< a third of the face's area
};

/// Lists run over the vertices of boundary faces, ascending. Faces without area count nowhere.
struct BoundaryVertices {
  std::vector<std::uint32_t> vertices;
  std::vector<Vector3> normals;    ///< unit area-weighted mean; {0, 0, 0} where opposite faces cancel
  std::vector<double> spread_deg;  ///< largest angle of a face's normal to it
  std::vector<BoundaryClass> classes;
  std::vector<Vector3> tangents;  ///< of creases: unit, of either sign; {0, 0, 0} for other classes

  std::vector<std::uint32_t> face_begin;  ///< one more than vertices
  std::vector<FaceAtVertex> faces;        ///< of vertex k: from face_begin[k], in the order of solid.boundary

  std::size_t size() const { return vertices.size(); }

  std::span<const FaceAtVertex> faces_at(std::size_t k) const {
    return {faces.data() + face_begin[k], face_begin[k + 1] - face_begin[k]};
  }
};

BoundaryVertices classify_boundary_vertices(const TetSolid& solid, const BoundaryVertexOptions& options = {});

}  // namespace crossgrain
