// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crossgrain/hexahedra.hpp"

namespace crossgrain {

/// Throws Error(kUsage) for options out of range.
void check_options(const HexOptions& options);

}  // namespace crossgrain
