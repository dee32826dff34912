// SPDX-License-Identifier: Apache-2.0
// Frames of tets that follow their faces exactly.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/quaternion.hpp"
#include "base/vector3.hpp"
#include "harmonics/coefficients.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// A tet with the faces that its frame follows.
struct TetFaceNormals {
  std::uint32_t tet;
  std::vector<Vector3> normals;  ///< with twice the area of the face as length; of either sign on walls
};

/// The tets with faces of the boundary or of `walls`, ascending. Faces without area are left out.
std::vector<TetFaceNormals> followed_normals(const TetSolid& solid,
                                             std::span<const std::array<std::uint32_t, 3>> walls);

/// Returns the frame that follows these normals (at least one, none zero). Those that turn by at most 45
/// degrees from the largest of a group, up to sign, form that group. One group: an axis is exactly along its
/// sum, and target . h(R) is the largest about this axis. Two groups or three: the frame nearest to the
/// directions of their sums, by the polar decomposition, exact if these are orthogonal. `start` names the
/// axes: it is rotated onto the normal by the shortest way.
Quaternion frame_on_faces(std::span<const Vector3> normals, const Coefficients<4>& target,
                          const Quaternion& start);

/// The frame with an axis along a unit vector that maximises target . h(R) among these, which is c + A cos 4t
/// + B sin 4t of the angle t about it.
Quaternion best_about_axis(const Vector3& axis, const Coefficients<4>& target, const Quaternion& start);

}  // namespace crossgrain
