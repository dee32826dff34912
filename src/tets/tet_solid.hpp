// SPDX-License-Identifier: Apache-2.0
// A validated tet mesh: tets of positive orientation, with their faces and the boundary.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// Index of a flat tet, which is not in the mesh.
inline constexpr std::uint32_t kNoTet = UINT32_MAX;

/// Component of a vertex that no tet uses.
inline constexpr std::uint32_t kNoComponent = UINT32_MAX;

/// A validated tet mesh (`prepare_tets`). Not changed afterwards; safe to read from any number of threads.
///
/// A tet without volume has no gradients, so it is not in `mesh.tets`. It still fills its place: its faces
/// open no slit inside the solid, and on the surface they are boundary.
struct TetSolid {
  TetMesh mesh;  ///< vertices as given; tets of positive volume, in the order given
  std::vector<std::array<std::uint32_t, 4>> flat_tets;  ///< tets of four distinct vertices without volume

  /// A face between two tets.
  struct InnerFace {
    std::array<std::uint32_t, 3> vertices;  ///< ascending
    std::array<std::uint32_t, 2> tets;      ///< the second is kNoTet if a flat tet is behind the face
  };
  std::vector<InnerFace> inner_faces;  ///< faces of at least one tet of `mesh`, ascending by vertices

  /// Faces of only one tet, outward by the right-hand rule, as vertices of `mesh`; ascending by sorted
  /// vertices.
  std::vector<std::array<std::uint32_t, 3>> boundary;
  std::vector<std::uint32_t> boundary_tets;  ///< tet of each boundary face; kNoTet if it is flat

  std::vector<std::uint32_t> tet_components;     ///< tets connected through faces share a component, from 0
  std::vector<std::uint32_t> vertex_components;  ///< lowest component of each vertex's tets, or kNoComponent
  std::size_t components = 0;

  std::size_t inverted_tets = 0;    ///< number of tets reoriented by exchanging two vertices
  std::size_t left_out_tets = 0;    ///< number of tets without volume or with the vertices of an earlier one
  std::size_t faulty_tets = 0;      ///< number of tets given that are inverted or without volume
  Vector3 faulty_place{0, 0, 0};    ///< the centroid of the first of these
  std::size_t unused_vertices = 0;  ///< number of vertices of no tet of `mesh`
};

/// Validates and repairs a mesh, adding a warning for each kind of fault: tets that are
/// inverted or without volume, repeated tets, vertices that no tet uses, tets on the same side of their
/// common face, edges and vertices where the boundary is not a surface, neighbours that do not share
/// vertices. Each names the first one, counted from 0.
///
/// Throws Error(kInput) naming the vertex, tet or face: coordinates that are not finite or beyond 1e100,
/// indices out of range, no tet with a volume, a face of three or more tets.
TetSolid prepare_tets(TetMesh mesh, std::vector<Warning>& warnings);

/// Tags of these faces (TetMesh::feature_faces), 0 for those without; empty if the mesh tags no face.
std::vector<std::int32_t> tags_of_faces(const TetMesh& mesh,
                                        const std::vector<std::array<std::uint32_t, 3>>& faces);

/// The boundary as a separate surface: only the vertices it uses, in the order of the solid.
TriangleMesh boundary_surface(const TetSolid& solid);

}  // namespace crossgrain
