// SPDX-License-Identifier: Apache-2.0
// From triangles around a solid to tets in it.
#pragma once

#include "surface/patched_surface.hpp"
#include "surface/surface.hpp"
#include "tet_making/tet_program.hpp"

namespace crossgrain {

/// Returns a mended surface as one that is ready to be filled, looking outward: without triangles that occur
/// in both orientations, since what they separate is one solid.
PatchedSurface surface_to_fill(const Surface& surface, const CreaseAngles& creases);

/// Returns new triangles for it of the wanted sizes; the given ones if the new ones would cross.
PatchedSurface filled_triangles(const PatchedSurface& given, const TetJob& job);

/// Fills each body of a closed surface. Regions are bodies, from 1; triangles and edges have the tags of
/// patches and the numbers of curves, from 1. Throws as TetProgram::fill does.
TetMesh tets_in(const PatchedSurface& surface, const TetProgram& program, const TetJob& job);

}  // namespace crossgrain
