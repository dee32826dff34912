// SPDX-License-Identifier: Apache-2.0
// Surfaces of coarse triangles that have no sharp edges, or one that fades out.
#pragma once

#include "crossgrain/types.hpp"

namespace crossgrain {

/// A sphere of radius 1 (make_sphere) whose points move outward by `knobs` times a sum of smooth waves, and
/// by random numbers up to `noise`. It has no creases, but edges of any angle where knobs are narrow.
TriangleMesh make_knobbly_sphere(int subdivisions, double knobs, double noise, unsigned seed);

/// An open sheet over [0, 2] x [-1, 1] of 2 `cells` x 2 `cells` squares with a ridge along y = 0, whose angle
/// between normals is `angle_deg` at x = 0 and falls to 0 at x = 1.5, linearly in the slope of its sides.
TriangleMesh make_fading_ridge(int cells, double angle_deg);

}  // namespace crossgrain
