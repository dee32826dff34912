// SPDX-License-Identifier: Apache-2.0
// Where hexahedra of a lattice do not keep a model, and smaller ones might.
#pragma once

#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/hex_report.hpp"
#include "lattice/lattice_planes.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// Returns the places in `earlier`, and those where hexahedra of about `size` are badly shaped, lack a
/// feature, or are farther from the surface than kFarOff; none if there are no new ones, or the report has
/// no features. Each new one has the size that is to be tried there: kFinerSize of that at the nearest place
/// in `earlier` (which it is near to), else of `size`.
std::vector<FinePlace> places_to_refine(const HexMesh& mesh, const HexReport& report, const Surface& model,
                                        double size, const std::vector<FinePlace>& earlier);

/// In sizes asked for (HexReport::size): less than the distance in all that a faithful mesh may have
/// (measure/ surface_distance.hpp), so that what is next to it is refined too.
inline constexpr double kFarOff = 0.28;

/// Of the size at a place, what is tried there next.
inline constexpr double kFinerSize = 0.5;

}  // namespace crossgrain
