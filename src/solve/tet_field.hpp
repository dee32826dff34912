// SPDX-License-Identifier: Apache-2.0
// A frame field on a tet mesh.
#pragma once

#include <span>
#include <vector>

#include "base/quaternion.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// Unit quaternions in double precision: a boundary normal that a vertex holds exactly stays so.
struct TetField {
  std::vector<Quaternion> vertex_frames;  ///< one per vertex of the mesh, used or not
  std::vector<Quaternion> tet_frames;     ///< one per tet
  SingularityGraph singularities;         ///< of the frames of tets
};

/// For each tet the frame nearest to the mean of its four vertices' degree-4 coefficients: the maximum uphill
/// from the most central of the four frames, or, where they disagree, the global one.
std::vector<Quaternion> tet_frames_of(const TetMesh& mesh, std::span<const Quaternion> vertex_frames);

}  // namespace crossgrain
