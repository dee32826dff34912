// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace crossgrain {

/// Colours of axes named x, y and z, 0xRRGGBB: those of the axis cross, in tones that singular lines lack.
inline constexpr std::array<std::uint32_t, 3> kAxisColours{0xc8423b, 0x5f9e3a, 0x4a6fd0};

}  // namespace crossgrain
