// SPDX-License-Identifier: Apache-2.0
// The matchings of a field as onto.vtu has them: with each tet, where its axes go on behind its faces.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "singularity/matching.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// FaceMatching::axes behind the faces opposite the corners of a tet in turn; zeros on the surface.
using AxesBehindFaces = std::array<std::int8_t, 12>;

std::vector<AxesBehindFaces> axes_behind_faces(const TetSolid& solid,
                                               const std::vector<CubeRotation>& matchings);

/// The matchings across the inner faces; none where the axes are those of no matchings, or of others on the
/// two sides of a face.
std::optional<std::vector<CubeRotation>> matchings_in(const TetSolid& solid,
                                                      const std::vector<AxesBehindFaces>& axes);

}  // namespace crossgrain
