// SPDX-License-Identifier: Apache-2.0
// The frames that a field on the grid gives to the vertices of a tet mesh.
#pragma once

#include <cstddef>
#include <vector>

#include "base/quaternion.hpp"
#include "field/field_data.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

struct CarriedFrames {
  std::vector<Quaternion> frames;  ///< one per vertex
  std::size_t outside = 0;         ///< vertices of tets that are in no active cell
};

/// Each vertex in an active cell takes the frame of that cell; relaxation forgets what interpolation would
/// add. Others take that of the nearest cell of their own component: one that is joined through open faces to
/// a cell which holds a vertex of the same component of tets. Where there is none such, of the nearest cell.
CarriedFrames carried_frames(const FieldData& field, const TetSolid& solid);

}  // namespace crossgrain
