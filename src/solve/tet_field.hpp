// SPDX-License-Identifier: Apache-2.0
// A frame field on a tet mesh.
#pragma once

#include <span>
#include <vector>

#include "base/quaternion.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// Unit quaternions, in double precision so that frames on the boundary keep their normals exactly.
struct TetField {
  std::vector<Quaternion> vertex_frames;  ///< one per vertex of the mesh, including unused ones
  std::vector<Quaternion> tet_frames;     ///< one per tet
};

/// Returns for each tet the frame nearest to the mean of its four vertices' degree-4 coefficients: the local
/// maximum found from the most central of the four frames, or the global one if they differ too much.
std::vector<Quaternion> tet_frames_of(const TetMesh& mesh, std::span<const Quaternion> vertex_frames);

}  // namespace crossgrain
