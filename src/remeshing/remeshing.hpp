// SPDX-License-Identifier: Apache-2.0
// New triangles for a surface, as a mesher of volumes needs them: of the wanted size, as equilateral as
// possible, with the same patches and curves.
#pragma once

#include "crossgrain/monitor.hpp"
#include "remeshing/remeshing_options.hpp"
#include "surface/patched_surface.hpp"

namespace crossgrain {

/// Returns a surface of the same topology, patches and curves whose triangles are about as large as wanted.
/// Vertices lie on the given surface, those of curves on them; ends of curves stay where they are. By splits
/// of long edges, collapses of short ones, flips and smoothing along the surface (Botsch, Kobbelt 2004), each
/// of which is done only if the triangles stay close to the given ones. The result is the same on every
/// machine.
///
/// Edges of one triangle, or of more than two, stay as they are. Throws Error(kInterrupted).
PatchedSurface remeshed(const PatchedSurface& given, const Remeshing& options, const Monitor& monitor = {});

/// Quality of a triangle: 4 sqrt(3) times its area over the sum of its squared edges, 1 if it is equilateral.
double quality_of(const std::array<Vector3, 3>& corners);

}  // namespace crossgrain
