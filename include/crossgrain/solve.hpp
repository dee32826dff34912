// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crossgrain/frame_field.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/options.hpp"
#include "crossgrain/tet_domain.hpp"
#include "crossgrain/tet_frame_field.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

// Concurrency of all functions here. Any number of threads may call them at once, on the same meshes,
// domains, fields, options and monitors or on different ones, as long as nobody changes those meanwhile. Each
// call computes with the threads that its own `options.threads` asks for, or with fewer where a ThreadLimit
// of the calling thread says so. Neither what it computes nor when it ends depends on the others, but for one
// thing: memory belongs to the process. A solve reckons with what the process holds when it begins, not with
// what others take afterwards; give each of several solves at once a smaller `max_memory_bytes`. Peaks of
// memory in reports are those of the process. Listeners of a monitor are called from the thread that called
// the function.

/// The octahedral frame field inside a surface: smooth, and with an axis along the surface's normal
/// (arXiv 2309.13477). The surface is immersed in an octree and the field found coarse to fine. The same
/// input and options give the same bits, whatever `options.threads` is.
///
/// Errors: kUsage for options out of range; kInput for a mesh without triangles, with NaN or an index out of
/// range, or one that encloses nothing, and for constraints that make no sense, are all beside the model or
/// on faces that it has not; kLimit where memory or the depth of the octree does not suffice;
/// kInterrupted.
FrameField solve(const TriangleMesh& mesh, const SolveOptions& options = {}, const Monitor& monitor = {});

/// The same, starting from an earlier field (of this or another surface) in place of random frames.
FrameField solve_from(const FrameField& earlier, const TriangleMesh& mesh, const SolveOptions& options = {},
                      const Monitor& monitor = {});

/// The options for a field that is to be carried onto tets: where they give neither resolution nor cell size,
/// with cells of the size of the tets' edges (OntoOptions). Errors: kUsage.
SolveOptions sized_for(const TetDomain& domain, SolveOptions options = {});

/// Carries a field onto the vertices of a tet mesh and finishes it there (docs/solver.md): relaxation and
/// sweeps lower the Dirichlet energy of the degree-4 coefficients, linear in every tet. Smooth boundary
/// vertices keep an axis along their area-weighted normal exactly and turn about it only; creases and corners
/// are held as `options.onto` says. Vertices in no cell begin with the frame of the nearest cell of their own
/// component. The degree is that of `field`. Errors: kUsage; kInput where no vertex lies in a cell, or for
/// tets of a size or place that leaves single precision; kLimit; kInterrupted.
TetFrameField carry_onto(const FrameField& field, const TetDomain& domain, const SolveOptions& options = {},
                         const Monitor& monitor = {});

/// The field inside the boundary of a tet mesh, carried onto it: `solve` with the options of `sized_for`, and
/// `carry_onto`. Errors as those two.
TetFrameField solve_onto(const TetDomain& domain, const SolveOptions& options = {},
                         const Monitor& monitor = {});

}  // namespace crossgrain
