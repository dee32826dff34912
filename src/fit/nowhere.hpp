// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace crossgrain {

/// The index of a vertex, an edge, a curve that is not there.
inline constexpr std::uint32_t kNowhere = UINT32_MAX;

}  // namespace crossgrain
