// SPDX-License-Identifier: Apache-2.0
#include "fit/near_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/vector3.hpp"
#include "fit/fitted_shapes.hpp"
#include "fit/hex_fitting.hpp"
#include "measure/hex_quality.hpp"

namespace crossgrain {
namespace {

using testing::FittedShape;
using testing::lattice_in_box;

constexpr int kCells = 16, kLayers = 4, kInside = kCells - 2 * kLayers;
constexpr double kPoor = 0.4;

std::size_t cubed(std::size_t n) {
  return n * n * n;
}

/// Whether a vertex of the lattice is further inside than the layers, or on their inner border.
bool is_inside(const Vector3& place) {
  return std::ranges::all_of(place, [](double x) { return x >= kLayers && x <= kCells - kLayers; });
}

TEST(NearSurface, IsNoneOfASmallMesh) {
  const FittedShape shape = lattice_in_box({9, 9, 9});
  EXPECT_FALSE(near_surface(shape.mesh, shape.carriers, kPoor));
}

TEST(NearSurface, HasTheLayersAndHoldsTheirInnerBorder) {
  const FittedShape shape = lattice_in_box({kCells, kCells, 4 * kCells});
  const auto part = near_surface(shape.mesh, shape.carriers, kPoor);
  ASSERT_TRUE(part);
  const int length = 4 * kCells - 2 * kLayers;
  EXPECT_EQ(part->mesh.hexahedra.size(), 4 * cubed(kCells) - kInside * kInside * length);
  const auto held = std::ranges::count_if(part->carriers.of_vertex, [](const HexCarrier& carrier) {
    return carrier.kind == HexCarrier::Kind::kHeld;
  });
  const int n = kInside + 1;
  EXPECT_EQ(held, n * n * (length + 1) - (n - 2) * (n - 2) * (length - 1));
  for (std::size_t v = 0; v < part->vertices.size(); ++v)
    EXPECT_EQ(part->mesh.vertices[v], shape.mesh.vertices[part->vertices[v]]);
  EXPECT_EQ(part->carriers.quads.size(), shape.carriers.quads.size());
  for (const auto& path : part->carriers.path_of_curve)
    for (const std::uint32_t v : path) EXPECT_TRUE(part->carriers.of_vertex[v].is_on_surface());
}

TEST(NearSurface, ReachesPoorHexahedraInside) {
  FittedShape shape = lattice_in_box({kCells, kCells, 6 * kCells});
  const auto before = near_surface(shape.mesh, shape.carriers, kPoor);
  const Vector3 middle{kCells / 2.0, kCells / 2.0, 3.0 * kCells};
  for (Vector3& p : shape.mesh.vertices)
    if (norm(p - middle) < 0.1) p += Vector3{0.9, 0.9, 0.9};
  const auto after = near_surface(shape.mesh, shape.carriers, kPoor);
  ASSERT_TRUE(before && after);
  EXPECT_EQ(after->mesh.hexahedra.size(),
            before->mesh.hexahedra.size() + kInside * kInside * 2 * (kLayers + 1))
      << "the eight around the vertex, the layers around these, and nothing of the surface twice";
}

TEST(NearSurface, IsAllThatFittingMoves) {
  FittedShape shape = lattice_in_box({kCells, kCells, 4 * kCells});
  const std::vector<Vector3> lattice = shape.mesh.vertices;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> move(-0.2, 0.2);
  for (std::size_t v = 0; v < lattice.size(); ++v)
    if (shape.carriers.of_vertex[v].is_on_surface())
      for (double& coordinate : shape.mesh.vertices[v]) coordinate += move(random);
  const HexFittingResult result = fit_onto(shape.mesh, shape.complex, shape.carriers, 1);
  EXPECT_EQ(result.invalid, 0U);
  EXPECT_EQ(result.off, 0U);
  EXPECT_GT(std::ranges::min(scaled_jacobians(shape.mesh)), 0.99);
  std::size_t stayed = 0;
  for (std::size_t v = 0; v < lattice.size(); ++v)
    if (lattice[v][2] >= kLayers && lattice[v][2] <= 4 * kCells - kLayers &&
        is_inside({lattice[v][0], lattice[v][1], kLayers})) {
      EXPECT_EQ(shape.mesh.vertices[v], lattice[v]);
      ++stayed;
    }
  EXPECT_GT(stayed, 1000U);
}

}  // namespace
}  // namespace crossgrain
