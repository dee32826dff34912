// SPDX-License-Identifier: Apache-2.0
// A frame field on a tet mesh.
#pragma once

#include <span>
#include <vector>

#include "base/quaternion.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/types.hpp"
#include "singularity/matching.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// Unit quaternions, in double precision so that frames on the boundary keep their normals exactly.
struct TetField {
  std::vector<Quaternion> vertex_frames;  ///< one per vertex of the mesh, including unused ones
  std::vector<Quaternion> tet_frames;     ///< one per tet

  /// Of a repaired field, the matching across each of TetSolid::inner_faces, from its first tet to its
  /// second. Empty: the nearest of the frames of tets.
  std::vector<CubeRotation> matchings = {};

  bool is_repaired() const { return !matchings.empty(); }
};

/// The matchings of a field across TetSolid::inner_faces: its own, or the nearest.
std::vector<CubeRotation> matchings_of(const TetSolid& solid, const TetField& field);

/// The singular graph of a field on tets; that of a repaired field is exact (matching/repaired_graph.hpp).
SingularityGraph graph_of(const TetSolid& solid, const TetField& field);

/// Returns for each tet the frame nearest to the mean of its four vertices' degree-4 coefficients: the local
/// maximum found from the most central of the four frames, or the global one if they differ too much.
std::vector<Quaternion> tet_frames_of(const TetMesh& mesh, std::span<const Quaternion> vertex_frames);

}  // namespace crossgrain
