// SPDX-License-Identifier: Apache-2.0
// The parts of models/, one source file each. Lengths are millimetres, z is up.
#pragma once

#include <TopoDS_Shape.hxx>

namespace crossgrain::models {

/// A base plate with four bolt holes, an upright with a slanted edge and a large bore, filleted, and a rib.
/// No symmetry of any kind.
TopoDS_Shape bracket();

/// A bearing housing on a base with two slots.
TopoDS_Shape pillow_block();

/// A pipe with a branch at 55 degrees and a bolted flange at one end.
TopoDS_Shape pipe_branch();

/// A wedge with a bore across and a countersunk hole square to its slanted face.
TopoDS_Shape wedge();

/// An open box with walls of 3 mm, a slanted rim and screw bosses inside.
TopoDS_Shape housing();

}  // namespace crossgrain::models
