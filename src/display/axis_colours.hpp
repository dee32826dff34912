// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace crossgrain {

/// Colours of axes named x, y and z, 0xRRGGBB: red, green and indigo, none of which is the
/// colour of a singular line.
inline constexpr std::array<std::uint32_t, 3> kAxisColours{0xc8423b, 0x5f9e3a, 0x3d3a9e};

}  // namespace crossgrain
