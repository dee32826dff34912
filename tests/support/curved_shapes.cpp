// SPDX-License-Identifier: Apache-2.0
#include "support/curved_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "base/vector3.hpp"
#include "support/shapes.hpp"

namespace crossgrain {

TriangleMesh make_knobbly_sphere(int subdivisions, double knobs, double noise, unsigned seed) {
  TriangleMesh mesh = make_sphere(1, subdivisions);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::array<Vector3, 6> waves;
  for (Vector3& wave : waves) wave = 7 * Vector3{uniform(random), uniform(random), uniform(random)};
  for (Vector3& p : mesh.vertices) {
    double out = 0;
    for (const Vector3& wave : waves) out += std::sin(dot(wave, p)) / 6;
    p = (1 + knobs * out + noise * uniform(random)) * p;
  }
  return mesh;
}

TriangleMesh make_fading_ridge(int cells, double angle_deg) {
  const double steepest = std::tan(angle_deg / 2 * std::numbers::pi / 180);
  TriangleMesh mesh;
  for (int j = -cells; j <= cells; ++j) {
    for (int i = 0; i <= 2 * cells; ++i) {
      const double x = static_cast<double>(i) / cells, y = static_cast<double>(j) / cells;
      mesh.vertices.push_back({x, y, -steepest * std::max(0.0, 1 - x / 1.5) * std::abs(y)});
    }
  }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i + (2 * cells + 1) * j); };
  for (int j = 0; j < 2 * cells; ++j) {
    for (int i = 0; i < 2 * cells; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

}  // namespace crossgrain
