// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crossgrain/frame_field.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/options.hpp"
#include "crossgrain/tet_domain.hpp"
#include "crossgrain/tet_frame_field.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup solving Solving
/// @{

// Concurrency: any number of threads may call these functions at once, with the same meshes, domains, fields,
// options and monitors or different ones, as long as nobody modifies them meanwhile. Each call uses the
// number of threads in its own `options.threads`, or fewer if a ThreadLimit of the calling thread says so,
// and its result does not depend on other calls. Memory is shared by the process: a solve accounts for what
// the process holds when it starts, so give concurrent solves a smaller `max_memory_bytes` each. Peak memory
// in a report is that of the process. Listeners of a monitor are called on the thread that called the
// function.

/// Returns the octahedral frame field inside a surface: smooth, with an axis along the normal of the surface
/// (arXiv 2309.13477). The surface is immersed in an octree and the field is solved coarse to fine. The
/// result depends only on the input and the options, bit for bit, not on `options.threads`.
///
/// Errors: kUsage for options out of range; kInput for a mesh without triangles, with NaN or an index out of
/// range, or one that encloses nothing, and for constraints that are invalid, all outside the model or on
/// faces that it does not have; kLimit if memory or the depth of the octree does not suffice; kInterrupted.
FrameField solve(const TriangleMesh& mesh, const SolveOptions& options = {}, const Monitor& monitor = {});

/// Solves from an earlier field, of this or another surface, instead of random frames.
FrameField solve_from(const FrameField& earlier, const TriangleMesh& mesh, const SolveOptions& options = {},
                      const Monitor& monitor = {});

/// Returns the options for a field that will be transferred to tets: if they give neither resolution nor cell
/// size, with cells that suit the edges of the tets. Errors: kUsage.
SolveOptions sized_for(const TetDomain& domain, SolveOptions options = {});

/// Transfers a field to the vertices of a tet mesh and finishes it there (docs/solver.md): relaxation and
/// sweeps lower the Dirichlet energy of the degree-4 coefficients, which are linear in every tet. The same is
/// done with fields on other grids inside the tets, and the one of the lowest energy is returned. Smooth
/// boundary vertices keep an axis exactly along their area-weighted normal; SolveOptions::boundary says
/// whether creases and corners are constrained. Vertices outside all cells start with the frame of the
/// nearest cell of their component. The degree is that of `field`. Errors: kUsage; kInput if no vertex lies
/// in a cell, or for tets of a size or place beyond single precision; kLimit; kInterrupted.
TetFrameField carry_onto(const FrameField& field, const TetDomain& domain, const SolveOptions& options = {},
                         const Monitor& monitor = {});

/// Solves inside the boundary of a tet mesh and transfers the field to it: `solve` with the options of
/// `sized_for`, then `carry_onto`. Errors: those of both.
TetFrameField solve_onto(const TetDomain& domain, const SolveOptions& options = {},
                         const Monitor& monitor = {});

/// @}

}  // namespace crossgrain
