// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad_reading/cad_messages.hpp"
#include "cad_reading/program/bodies.hpp"

namespace crossgrain {

/// Returns the closed bodies as solids that look outward, with the numbers that the triangles of `tessellate`
/// have.
CadSolids solids_of(const Bodies& bodies);

}  // namespace crossgrain
