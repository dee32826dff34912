// SPDX-License-Identifier: Apache-2.0
// Frames smoothed with their matchings kept.
#pragma once

#include <vector>

#include "base/quaternion.hpp"
#include "matching/matched_field.hpp"

namespace crossgrain {

/// Returns the frames of tets after up to 100 sweeps, until none turns by more than 0.001, that lower the sum
/// over inner faces of area / distance of the centres times |q_a - q_b g|^2, with the matchings g of the
/// field: each frame becomes the mean of its neighbours and itself, as quaternions, since that is the mean of
/// rotations that are near. A frame of a tet at the boundary keeps the axis of each of its faces along the
/// normal (MatchedField::normal_axis), or as near as the faces allow; at walls and tagged edges it is the
/// axis of the field's frame that is nearest. The same to the bit for any number of threads.
std::vector<Quaternion> smoothed_frames(const MatchedField& field, std::vector<Quaternion> frames);

}  // namespace crossgrain
