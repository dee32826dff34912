// SPDX-License-Identifier: Apache-2.0
// Lengths of singular arcs in a map.
#pragma once

#include <vector>

#include "crossgrain/singularity_graph.hpp"
#include "map/map_unknowns.hpp"

namespace crossgrain {

/// The length of each arc in the map as a form of columns, in the sense in which its index has it: positive
/// in every map without flips. So none exists if the form is zero, as of an arc from a face of the surface to
/// another point of the same face. `graph` is that of the matchings (repaired_graph); arcs without an axis or
/// of changing sense get zero.
std::vector<LinearForm> arc_lengths(const MapUnknowns& unknowns, const SingularityGraph& graph);

}  // namespace crossgrain
