// SPDX-License-Identifier: Apache-2.0
// Places in sentences.
#pragma once

#include <string>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// Returns the coordinates of a place as text, "106.23 51 0", rounded to four decimals of the power of ten
/// below `size`: the largest extent of the model, or the largest coordinate where it is not known (0).
std::string words_of_place(const Vector3& place, double size = 0);

}  // namespace crossgrain
