// SPDX-License-Identifier: Apache-2.0
#include "support/rims.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace crossgrain {

TriangleMesh make_wavy_rim(double mean_deg, double wave_deg) {
  constexpr std::uint32_t kEdges = 48;
  constexpr double kWidth = 0.1, kDegree = std::numbers::pi / 180;
  TriangleMesh sheet;
  for (std::uint32_t k = 0; k < kEdges; ++k) {
    const double phi = 2 * std::numbers::pi * k / kEdges, x = std::cos(phi), y = std::sin(phi);
    const double height = kWidth / std::tan((mean_deg + wave_deg * x) * kDegree), inner = 1 - kWidth;
    sheet.vertices.insert(sheet.vertices.end(), {{x, y, -kWidth}, {x, y, 0}, {inner * x, inner * y, height}});
    const std::uint32_t here = 3 * k, next = 3 * ((k + 1) % kEdges);
    for (const std::uint32_t row : {0u, 1u}) {
      sheet.triangles.push_back({here + row, next + row, next + row + 1});
      sheet.triangles.push_back({here + row, next + row + 1, here + row + 1});
    }
  }
  return sheet;
}

}  // namespace crossgrain
