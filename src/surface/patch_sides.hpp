// SPDX-License-Identifier: Apache-2.0
// The orientation of the patches of a damaged surface, and which of them bound nothing.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/patches.hpp"

namespace crossgrain {

/// Patch number of a triangle that is half of an internal sheet.
inline constexpr std::uint32_t kNoPatch = UINT32_MAX;

/// Share of minority orientation in a patch above which the majority is not decisive.
inline constexpr double kUndecided = 0.4;

struct PatchSides {
  std::vector<bool> flipped;   ///< per patch: its triangles are reversed
  std::vector<bool> stray;     ///< per patch: it bounds nothing
  std::vector<bool> left_out;  ///< per triangle: it is of a stray patch, or of a sheet that is not inside
  bool inside_out = false;     ///< the whole surface is inside out after that
};

/// Returns the orientation of patches. Triangles must be consistently oriented within each patch; `patch_of`
/// has one entry per triangle.
///
/// A patch is classified by the winding numbers at a few of its triangles, each the mean of those on its two
/// sides. `own` is the part due to the patch itself, `others` the part due to the rest.
///
///   own                     | others, rounded |
///   ------------------------+-----------------+--------------------------------------------------------------
///   1/4 and more (or less   | 0               | flipped where `own` is negative
///   than -1/4): it encloses | 1 and more      | kept: a void, or a part inside another
///   a volume                | -1 and less     | flipped: it lies in a part that is flipped
///   in between: a sheet     | any             | stray where own + others is not within 1/4 of 1/2, unless
///   closed, or 0 is on one side and 2 or more on the other: sheets that lie on each other
///
/// The orientation of a patch with nearly equal shares of both is unknown: inside an odd number of others it
/// becomes a void. Surfaces of more than 3,000 patches are not classified.
PatchSides judge_patches(const TriangleMesh& mesh, const std::vector<std::uint32_t>& patch_of,
                         const std::vector<Patch>& patches);

/// Reverses a triangle and its corner normals.
void turn_triangle(TriangleMesh& mesh, std::size_t triangle);

/// Returns the mesh with only these triangles and their data, in this order.
TriangleMesh selected_triangles(const TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles);

}  // namespace crossgrain
