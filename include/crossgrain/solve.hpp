// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crossgrain/frame_field.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/options.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// The octahedral frame field inside a surface: smooth, and with an axis along the surface's normal
/// (arXiv 2309.13477). The surface is immersed in an octree and the field found coarse to fine. The same
/// input and options give the same bits, whatever `options.threads` is.
///
/// Errors: kUsage for options out of range; kInput for a mesh without triangles, with NaN or an index out of
/// range, or one that encloses nothing; kLimit where memory or the depth of the octree does not suffice;
/// kInterrupted.
FrameField solve(const TriangleMesh& mesh, const SolveOptions& options = {}, const Monitor& monitor = {});

/// The same, starting from an earlier field (of this or another surface) in place of random frames.
FrameField solve_from(const FrameField& earlier, const TriangleMesh& mesh, const SolveOptions& options = {},
                      const Monitor& monitor = {});

}  // namespace crossgrain
