// SPDX-License-Identifier: Apache-2.0
// A tet mesh made ready: checked, its tets turned the right way round, with its faces and its boundary.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// In place of the index of a tet: a flat one, which is left out.
inline constexpr std::uint32_t kNoTet = UINT32_MAX;

/// In place of a component: a vertex that no tet uses.
inline constexpr std::uint32_t kNoComponent = UINT32_MAX;

/// Plain data that nothing changes after `prepare_tets`; safe to read from any number of threads.
///
/// A tet without volume has no gradients, so it is left out of `mesh.tets`. It still counts as filling the
/// place that it stands in: its faces open no slit inside the solid, and on the surface they are boundary.
struct TetSolid {
  TetMesh mesh;  ///< vertices as given; tets of positive volume, in the order given

  /// A face between two tets.
  struct InnerFace {
    std::array<std::uint32_t, 3> vertices;  ///< ascending
    std::array<std::uint32_t, 2> tets;      ///< the second is kNoTet where a flat tet stands behind the face
  };
  std::vector<InnerFace> inner_faces;  ///< of at least one tet of `mesh`; ascending by vertices

  /// Faces of one tet, outward by the right-hand rule over vertices of `mesh`; ascending by sorted vertices.
  std::vector<std::array<std::uint32_t, 3>> boundary;
  std::vector<std::uint32_t> boundary_tets;  ///< whose face each is; kNoTet where that is a flat one

  std::vector<std::uint32_t> tet_components;     ///< per tet: those connected through faces, numbered from 0
  std::vector<std::uint32_t> vertex_components;  ///< per vertex: the lowest of its tets, or kNoComponent
  std::size_t components = 0;

  std::size_t inverted_tets = 0;    ///< turned: two of their vertices exchanged
  std::size_t left_out_tets = 0;    ///< without volume, or of the same vertices as an earlier one
  std::size_t unused_vertices = 0;  ///< of no tet of `mesh`
};

/// Makes a mesh ready, adding to `warnings` for each kind of fault that it mends: tets that are
/// inverted or without volume, tets named twice, vertices that no tet uses, tets on the same side of their
/// common face, edges and vertices where the boundary is no surface, neighbours that do not share vertices.
/// Each names the first one, counted from 0.
///
/// Throws Error(kInput) naming the vertex, tet or face: coordinates that are not finite or beyond 1e100,
/// indices out of range, no tet with a volume, a face of three tets or more.
TetSolid prepare_tets(TetMesh mesh, std::vector<Warning>& warnings);

/// The tag of each of these faces (TetMesh::feature_faces), 0 for those without; empty where the mesh tags no
/// face.
std::vector<std::int32_t> tags_of_faces(const TetMesh& mesh,
                                        const std::vector<std::array<std::uint32_t, 3>>& faces);

/// The boundary as a surface of its own: only the vertices it uses, in the order of the solid's.
TriangleMesh boundary_surface(const TetSolid& solid);

}  // namespace crossgrain
