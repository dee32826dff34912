// SPDX-License-Identifier: Apache-2.0
// Lengths of singular arcs in a map.
#pragma once

#include <cstddef>
#include <vector>

#include "crossgrain/singularity_graph.hpp"
#include "reduction/map_unknowns.hpp"

namespace crossgrain {

/// The length of each arc in the map as a form of columns, in the sense in which its index has it: positive
/// in every map without flips. So none exists if the form is zero, as of an arc from a face of the surface to
/// another point of the same face. `graph` is that of the matchings (repaired_graph); arcs without an axis or
/// of changing sense get zero.
std::vector<LinearForm> arc_lengths(const MapUnknowns& unknowns, const SingularityGraph& graph);

/// Of a field: the arcs of its graph that have an axis, and a length that is the zero form. Throws
/// Error(kLimit) as MapUnknowns does.
std::vector<std::size_t> arcs_of_length_zero(const MatchedField& field, const SingularityGraph& graph);

}  // namespace crossgrain
