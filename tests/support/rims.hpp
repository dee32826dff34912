// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crossgrain/types.hpp"

namespace crossgrain {

/// An open sheet with a round rim of radius 1 in z = 0, of 48 edges: a wall below it, and a slope above it
/// whose normal turns from the wall's by about mean_deg + wave_deg cos(phi).
TriangleMesh make_wavy_rim(double mean_deg, double wave_deg);

}  // namespace crossgrain
