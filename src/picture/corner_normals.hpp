// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vector3.hpp"

namespace crossgrain {

/// Unit normals at the corners of each triangle for smooth shading: the mean, weighted by area, over the
/// triangles at the vertex whose normals are within `crease_deg` of the triangle's own.
std::vector<std::array<std::array<float, 3>, 3>> corner_normals(
    const std::vector<Vector3>& vertices, const std::vector<std::array<std::uint32_t, 3>>& triangles,
    double crease_deg);

}  // namespace crossgrain
