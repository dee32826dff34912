// SPDX-License-Identifier: Apache-2.0
// The box of the true faces of bodies, not of their triangles.
#pragma once

#include "cad_reading/program/bodies.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// Returns the box of all faces that have triangles (`tessellate`), to about 1e-12 of its sides. From the
/// highest nodes of each face and edge it climbs along the true surface or curve by Newton's method. Of two
/// bumps of a face that are higher by less than the triangles' distance from it, it may miss the higher one;
/// it never returns more than the faces fill.
///
/// BRepBndLib::AddOptimal takes as long as reading where many faces are splines.
Box exact_box(const Bodies& bodies);

}  // namespace crossgrain
