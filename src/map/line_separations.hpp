// SPDX-License-Identifier: Apache-2.0
// Distances along and between the lines that a map takes to lines of the grid.
#pragma once

#include "map/separations.hpp"

namespace crossgrain {

/// Lengths of singular arcs between their nodes, and of the curves of the surface (edges that the map bends)
/// between its corners; positive in a map without flips, so at least 1 in one of integers.
Separations line_lengths(const MapUnknowns& unknowns, const Eigen::VectorXd& columns);

/// Distances between two such lines that pass near each other, less than 1.5 hexahedra across either and less
/// than 0.25 along either: across both, or, for two that run side by side, along the axis on which they are
/// farther apart. They must stay apart, or the lines would meet.
Separations line_gaps(const MapUnknowns& unknowns, const Eigen::VectorXd& columns, const MapCoordinates& map);

/// The value of a form for values of the columns.
double value_of(const LinearForm& form, const Eigen::VectorXd& columns);

}  // namespace crossgrain
