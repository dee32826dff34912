// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "fit/layer_needs.hpp"

namespace crossgrain {

/// Returns 1 for each face that a layer under one face has to cover: its group, and those beside that a layer
/// cannot dive along. Those are, repeatedly:
/// - faces beside which one hexahedron would fill more than kMostLayerDeg at a curve;
/// - faces of which a quad at a corner, one for each covered curve there, would be wider;
/// - where solids meet in a curve, both outer faces, or all if there are several faces between solids;
/// - all at a corner where covered quads would meet in the vertex alone.
std::vector<std::uint8_t> layer_extent(const EmbeddedMesh& embedded, std::uint32_t face);

/// Adds the curves along which a pillow below a group of faces has to go on, besides those in `curves` (of
/// each curve 1): from a corner to the next curve of the group there, unless the pillow can dive along the
/// face beside that: of three curves at the corner the third parts the two faces beside, and neither it nor
/// the corner of the group is wider than kMostLayerDeg.
void extend_pillow(const EmbeddedMesh& embedded, std::uint32_t group, std::vector<std::uint8_t>& curves);

}  // namespace crossgrain
