// SPDX-License-Identifier: Apache-2.0
// What must stay apart when a map is rounded.
#pragma once

#include <vector>

#include "map/map_energy.hpp"

namespace crossgrain {

/// A distance along an axis of the map that must be at least 1, as a form of integer columns.
using Separations = std::vector<LinearForm>;

/// Lengths of and gaps between lines (map/line_separations.hpp), and distances between lines and planes of
/// the grid that face each other in a map: along rays that leave faces of the surface and singular edges
/// along the axes across them, and go on straight through the map to a face of the surface. Rays that meet
/// flipped tets are lost. Each form once, in the order in which they are found.
///
/// Bommes, Campen, Ebke, Alliez, Kobbelt 2013 and Lyon, Campen, Bommes, Kobbelt 2019 ("Parametrization
/// quantization with free boundaries") keep such distances in two dimensions.
Separations separations_of(const MapUnknowns& unknowns, const Eigen::VectorXd& columns,
                           const MapCoordinates& map);

}  // namespace crossgrain
