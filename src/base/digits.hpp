// SPDX-License-Identifier: Apache-2.0
// Numbers in few digits, for texts.
#pragma once

#include <string>

namespace crossgrain {

/// Returns the largest number with so many significant digits that is not above a positive one: whoever takes
/// it as it is written stays within the limit.
double rounded_down(double limit, int digits);

/// Returns a forecast of a count: "about 4100", "about 2.3 million".
std::string about(double count);

}  // namespace crossgrain
