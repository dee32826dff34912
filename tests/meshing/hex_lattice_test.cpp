// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/hex_lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <string>
#include <vector>

#include "support/shapes.hpp"

namespace crossgrain {
namespace {

/// Vertices in another order, so that curves around are not numbered around.
TriangleMesh mixed(TriangleMesh mesh) {
  constexpr std::size_t kStep = 7;
  const std::vector<Vector3> vertices = mesh.vertices;
  const std::size_t count = vertices.size();
  EXPECT_EQ(std::gcd(kStep, count), 1U);
  for (std::size_t v = 0; v < count; ++v) mesh.vertices[kStep * v % count] = vertices[v];
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& v : triangle) v = static_cast<std::uint32_t>(kStep * v % count);
  return mesh;
}

/// A disc of `walls` numbered faces around, and a face on either side.
TriangleMesh disc(int walls, double radius, double thickness) {
  TriangleMesh mesh = mixed(make_cylinder(radius, 0.5 * thickness, walls));
  for (const auto& triangle : mesh.triangles) {
    const Vector3 &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]],
                  &c = mesh.vertices[triangle[2]];
    const double z = a[2] + b[2] + c[2];
    if (std::abs(z) > 1.4 * thickness) {
      mesh.faces.push_back(z > 0 ? 1 : 2);
      continue;
    }
    const double turn = std::atan2(a[1] + b[1] + c[1], a[0] + b[0] + c[0]) / (2 * M_PI);
    const int wall = static_cast<int>(std::floor((turn + 1) * walls)) % walls;
    mesh.faces.push_back(3 + wall);
  }
  return mesh;
}

TEST(LatticeHexahedra, AreOneAcrossAThinPlateWhoseWallsMeetNearlyStraight) {
  constexpr double kThickness = 0.05;
  HexMeshingOptions options;
  options.hexahedra.size = 0.13;
  const FittedHexahedra made = lattice_hexahedra(disc(24, 1, kThickness), options);
  EXPECT_EQ(made.hexahedra().outcome, HexOutcome::kAllHex);
  EXPECT_GT(made.hexahedra().quality.least, 0.2);
  for (const Vector3& vertex : made.mesh.vertices)
    EXPECT_NEAR(std::abs(vertex[2]), 0.5 * kThickness, 1e-9) << "layers are under walls only";
}

TEST(LatticeHexahedra, AreForecastBeforeEachLatticeWithinAFactorOfTwo) {
  double forecast = 0;
  std::size_t fitted = 0, skipped = 0;
  HexMeshingOptions options;
  options.hexahedra.size = 0.26;
  options.on_expected = [&](const HexExpectation& expected) {
    EXPECT_EQ(fitted + skipped, 0U);
    EXPECT_EQ(expected.tets, 0U);
    EXPECT_EQ(expected.size, 0.26);
    forecast = expected.hexahedra;
  };
  options.on_attempt_end = [&](const HexAttemptEnd& end) {
    if (end.outcome == HexOutcome::kNone) {
      ++skipped;
    } else {
      ++fitted;
      EXPECT_GT(static_cast<double>(end.hexahedra), forecast / 2) << end.text;
      EXPECT_LT(static_cast<double>(end.hexahedra), forecast * 2) << end.text;
    }
    const std::size_t about = end.next.find("about ");
    forecast = about == std::string::npos ? 0 : std::atof(end.next.c_str() + about + 6);
  };
  // The first lattice has no cell inside.
  const FittedHexahedra made = lattice_hexahedra(make_torus(1, 0.1, 48, 16), options);
  EXPECT_GE(skipped, 1U);
  EXPECT_GE(fitted, 1U);
  EXPECT_EQ(made.hexahedra().attempts.size(), fitted + skipped);
}

}  // namespace
}  // namespace crossgrain
