// SPDX-License-Identifier: Apache-2.0
// Which way round the patches of a damaged surface belong, and which of them bound nothing.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/patches.hpp"

namespace crossgrain {

/// The patch of a triangle that is half of an internal sheet.
inline constexpr std::uint32_t kNoPatch = UINT32_MAX;

/// Share of a patch that is turned against the rest, above which the majority says nothing.
inline constexpr double kUndecided = 0.4;

struct PatchSides {
  std::vector<bool> flipped;   ///< patch by patch: looks the other way than its triangles as given
  std::vector<bool> stray;     ///< patch by patch: bounds nothing
  std::vector<bool> left_out;  ///< triangle by triangle: of a stray patch, or a sheet that is not inside
  bool inside_out = false;     ///< the surface as a whole, after that
};

/// The surface's triangles must agree within each patch; `patch_of` has an entry a triangle.
///
/// A patch is judged by the winding numbers at a few of its triangles, half of what they are on its two
/// sides. `own` is the part of the patch itself, `others` that of the rest.
///
///   own                     | others, rounded |
///   ------------------------+-----------------+--------------------------------------------------------------
///   1/4 and more (or less   | 0               | flipped where `own` is negative
///   than -1/4): it curves   | 1 and more      | kept: a void, or a part inside another
///   round a volume          | -1 and less     | flipped: it lies in a part that is flipped
///   in between: a sheet     | any             | stray where own + others is not within 1/4 of 1/2, unless
///   closed
///
/// A patch of which nearly half is turned against the rest says nothing of what it was meant to be: inside
/// an odd number of others it becomes a void. Nothing is judged where there are more than 3,000 patches.
PatchSides judge_patches(const TriangleMesh& mesh, const std::vector<std::uint32_t>& patch_of,
                         const std::vector<Patch>& patches);

/// Reverses a triangle, its corner normals too.
void turn_triangle(TriangleMesh& mesh, std::size_t triangle);

/// These triangles of a mesh, in this order, with whatever the mesh knows of them; all else unchanged.
TriangleMesh selected_triangles(const TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles);

}  // namespace crossgrain
