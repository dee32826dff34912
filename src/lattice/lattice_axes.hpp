// SPDX-License-Identifier: Apache-2.0
// Directions of a lattice.
#pragma once

#include "base/quaternion.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// Returns the rotation R whose axes most of a surface is aligned with: its frame is the projection of the
/// area-weighted mean of degree-4 harmonics of the normals onto frames, made exact on the faces that are
/// nearly aligned. The identity if that aligns as much area up to kAxesGain, which keeps coordinates of faces
/// exact.
Quaternion lattice_axes(const Surface& surface);

/// Returns the mean, over the area of a surface, of sum_k (n . r_k)^4 with the axes r_k of a frame: 1 if all
/// normals lie on axes, 3/5 of a sphere, 1/3 at least.
double alignment_with(const Surface& surface, const Quaternion& frame);

/// Alignment that turning the lattice away from the coordinate axes must gain.
inline constexpr double kAxesGain = 0.03;

}  // namespace crossgrain
