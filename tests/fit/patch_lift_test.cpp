// SPDX-License-Identifier: Apache-2.0
#include "fit/patch_lift.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/thread_limit.hpp"
#include "fit/fitted_shapes.hpp"
#include "fit/fitting_targets.hpp"
#include "fit/hex_fitting.hpp"
#include "fit/hex_patch.hpp"
#include "fit/shape_energy.hpp"
#include "measure/hex_quality.hpp"
#include "measure/hex_validity.hpp"

namespace crossgrain {
namespace {

using testing::block_in_cylinder;
using testing::FittedShape;
using testing::lattice_in_box;

bool are_all_valid(const HexMesh& mesh) {
  return std::ranges::count(inverted_hexahedra(mesh), 1) == 0;
}

/// Moves vertices by up to `reach`, or as much less as keeps hexahedra valid: all, or those inside.
void disturb(FittedShape& shape, double reach, unsigned seed, bool all) {
  const HexMesh before = shape.mesh;
  for (;; reach *= 0.9) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> move(-reach, reach);
    shape.mesh = before;
    for (std::size_t v = 0; v < before.vertices.size(); ++v) {
      const Vector3 by{move(random), move(random), move(random)};
      if (all || !shape.carriers.of_vertex[v].is_on_surface()) shape.mesh.vertices[v] += by;
    }
    if (are_all_valid(shape.mesh)) return;
  }
}

double furthest_off_box(const FittedShape& shape, const Vector3& sides) {
  double furthest = 0;
  for (std::size_t v = 0; v < shape.mesh.vertices.size(); ++v) {
    if (!shape.carriers.of_vertex[v].is_on_surface()) continue;
    const Vector3& place = shape.mesh.vertices[v];
    double off = INFINITY;
    for (std::size_t axis = 0; axis < 3; ++axis)
      off = std::min({off, std::abs(place[axis]), std::abs(place[axis] - sides[axis])});
    furthest = std::max(furthest, off);
  }
  return furthest;
}

TEST(PatchLift, RaisesTheWorstOfADisturbedBox) {
  for (unsigned seed = 1; seed < 6; ++seed) {
    FittedShape shape = lattice_in_box({5, 5, 5});
    disturb(shape, 2, seed, false);
    ASSERT_LT(worst_scaled_jacobian(shape.mesh), 0.2) << seed;
    EXPECT_GT(lift_patches(shape.mesh, shape.complex, shape.carriers, 1), 0u) << seed;
    EXPECT_TRUE(are_all_valid(shape.mesh)) << seed;
    EXPECT_GT(worst_scaled_jacobian(shape.mesh), 0.2) << seed;
    EXPECT_LT(furthest_off_box(shape, {5, 5, 5}), 1e-9) << seed;
  }
}

TEST(PatchLift, KeepsVerticesOnACylinderAndHexahedraValid) {
  for (unsigned seed = 1; seed < 6; ++seed) {
    FittedShape shape = block_in_cylinder();
    fit_onto(shape.mesh, shape.complex, shape.carriers, 1);
    disturb(shape, 1, seed, false);
    const double before = worst_scaled_jacobian(shape.mesh);
    lift_patches(shape.mesh, shape.complex, shape.carriers, 1);
    EXPECT_TRUE(are_all_valid(shape.mesh)) << seed;
    EXPECT_GE(worst_scaled_jacobian(shape.mesh), before) << seed;
    for (std::size_t v = 0; v < shape.mesh.vertices.size(); ++v) {
      if (shape.carriers.of_vertex[v].kind != HexCarrier::Kind::kCurve) continue;
      const Vector3& p = shape.mesh.vertices[v];
      EXPECT_NEAR(std::hypot(p[0], p[1]), 3, 2e-3) << seed;
    }
  }
}

TEST(PatchLift, PutsVerticesOntoTheirCarriersWhereThereIsRoom) {
  FittedShape shape = lattice_in_box({5, 5, 5});
  disturb(shape, 0.6, 2, true);
  lift_patches(shape.mesh, shape.complex, shape.carriers, 1);
  EXPECT_TRUE(are_all_valid(shape.mesh));
  EXPECT_LT(furthest_off_box(shape, {5, 5, 5}), 1e-9);
}

TEST(PatchLift, LeavesGoodHexahedraAsTheyAre) {
  FittedShape shape = lattice_in_box({4, 4, 4});
  const std::vector<Vector3> before = shape.mesh.vertices;
  EXPECT_EQ(lift_patches(shape.mesh, shape.complex, shape.carriers, 1), 0u);
  EXPECT_EQ(shape.mesh.vertices, before);
}

TEST(PatchLift, EndsWithAValidMeshWhereItIsInterrupted) {
  FittedShape shape = lattice_in_box({7, 7, 7});
  disturb(shape, 2, 4, true);
  Monitor monitor;
  monitor.cancel();
  {
    const WatchedLoops watched(monitor, Stops::kHeeded);
    EXPECT_THROW(lift_patches(shape.mesh, shape.complex, shape.carriers, 1), Error);
  }
  EXPECT_TRUE(are_all_valid(shape.mesh));
}

TEST(PatchLift, HasTheSameBitsForAnyNumberOfThreads) {
  const auto lifted = [](unsigned threads) {
    const ThreadLimit limit(threads);
    FittedShape shape = lattice_in_box({7, 7, 7});
    disturb(shape, 2, 4, true);
    lift_patches(shape.mesh, shape.complex, shape.carriers, 1);
    return shape.mesh.vertices;
  };
  EXPECT_EQ(lifted(1), lifted(3));
}

TEST(HexPatch, IsTheHexahedraWithinItsLayers) {
  const FittedShape shape = lattice_in_box({7, 7, 7});
  const Lists<std::uint32_t> uses = corner_uses(shape.mesh.vertices.size(), shape.mesh.hexahedra);
  const auto at = [&](const Vector3& centre) {
    return static_cast<std::uint32_t>(
        std::ranges::find_if(
            shape.mesh.hexahedra,
            [&](const auto& corners) {
              return norm(0.5 * (shape.mesh.vertices[corners[0]] + shape.mesh.vertices[corners[6]]) -
                          centre) < 0.1;
            }) -
        shape.mesh.hexahedra.begin());
  };
  const HexPatch inside = patch_around(at({3.5, 3.5, 3.5}), 2, shape.mesh, uses);
  EXPECT_EQ(inside.hexahedra.size(), 125u);
  EXPECT_EQ(inside.vertices.size(), 216u);
  EXPECT_EQ(std::ranges::count(inside.is_free, 1), 64);
  // At a corner of the box its faces are free.
  const HexPatch corner = patch_around(at({0.5, 0.5, 0.5}), 2, shape.mesh, uses);
  EXPECT_EQ(corner.hexahedra.size(), 27u);
  EXPECT_EQ(std::ranges::count(corner.is_free, 1), 27);
}

TEST(HexPatch, HasThePoornessOfCubesAndTheGradientOfItsDifferences) {
  FittedShape shape = lattice_in_box({2, 1, 1});
  std::vector<Vector3> gradient;
  // Of 16 corners and 48 edges at them.
  EXPECT_NEAR(poorness(shape.mesh, shape.mesh.vertices, 2, 0.5, gradient), std::log(16 + 48 * 0.25) / 2,
              1e-14);
  disturb(shape, 0.3, 1, true);
  for (const int power : {2, 8}) {
    poorness(shape.mesh, shape.mesh.vertices, power, 0.7, gradient);
    for (std::size_t v = 0; v < shape.mesh.vertices.size(); ++v)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        constexpr double kStep = 1e-6;
        std::vector<Vector3> none, places = shape.mesh.vertices;
        places[v][axis] += kStep;
        const double above = poorness(shape.mesh, places, power, 0.7, none);
        places[v][axis] -= 2 * kStep;
        const double below = poorness(shape.mesh, places, power, 0.7, none);
        EXPECT_NEAR(gradient[v][axis], (above - below) / (2 * kStep), 1e-7) << power;
      }
  }
}

TEST(FittingTargets, LetVerticesSlideOnCurvesAboutWhereTheyAre) {
  FittedShape shape = lattice_in_box({4, 3, 3});
  FittingTargets targets(shape.complex, shape.carriers, 1);
  targets.spread(shape.mesh);
  const auto second = static_cast<std::uint32_t>(std::ranges::find(shape.mesh.vertices, Vector3{2, 0, 0}) -
                                                 shape.mesh.vertices.begin());
  const auto reach = [&] { return targets.nearest(second, {4, 0, 0}, {0, 0, 0}).point[0]; };
  EXPECT_NEAR(reach(), 2.35, 1e-12);
  shape.mesh.vertices[second] = {2.3, 0, 0};
  targets.slide_from(shape.mesh);
  // The next vertex is at 3: 0.35 of what is between.
  EXPECT_NEAR(reach(), 2.3 + 0.35 * 0.7, 1e-12);
  targets.slide_from(shape.mesh);
  EXPECT_NEAR(reach(), 2.3 + 0.35 * 0.7, 1e-12);
}

}  // namespace
}  // namespace crossgrain
