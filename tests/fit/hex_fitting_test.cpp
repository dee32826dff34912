// SPDX-License-Identifier: Apache-2.0
#include "fit/hex_fitting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/parallel.hpp"
#include "base/quaternion.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/thread_limit.hpp"
#include "fit/fitted_shapes.hpp"
#include "fit/fitting_targets.hpp"
#include "fit/vertex_moves.hpp"
#include "measure/hex_quality.hpp"
#include "measure/hex_validity.hpp"

namespace crossgrain {
namespace {

using testing::block_in_cylinder;
using testing::FittedShape;
using testing::lattice_in_box;

std::size_t count_invalid(const HexMesh& mesh) {
  const std::vector<std::uint8_t> invalid = inverted_hexahedra(mesh);
  return static_cast<std::size_t>(std::count(invalid.begin(), invalid.end(), 1));
}

double worst_of(const HexMesh& mesh) {
  return std::ranges::min(scaled_jacobians(mesh));
}

void disturb(HexMesh& mesh, double reach, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> move(-reach, reach);
  for (Vector3& place : mesh.vertices)
    for (double& coordinate : place) coordinate += move(random);
}

/// Disturbed as far as all hexahedra stay valid.
void disturb_validly(HexMesh& mesh, double reach, unsigned seed) {
  const HexMesh before = mesh;
  for (;; reach *= 0.8) {
    mesh = before;
    disturb(mesh, reach, seed);
    if (count_invalid(mesh) == 0) return;
  }
}

double furthest_apart(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, norm(a[k] - b[k]));
  return most;
}

TEST(HexFitting, PutsADisturbedLatticeBackIntoItsBox) {
  FittedShape shape = lattice_in_box({5, 4, 3});
  const std::vector<Vector3> lattice = shape.mesh.vertices;
  disturb_validly(shape.mesh, 0.3, 1);
  const HexFittingResult result = fit_onto(shape.mesh, shape.complex, shape.carriers, 1);
  EXPECT_EQ(result.off, 0u);
  EXPECT_GT(worst_of(shape.mesh), 0.999);
  EXPECT_LT(furthest_apart(shape.mesh.vertices, lattice), 0.01);
  for (std::size_t v = 0; v < lattice.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (lattice[v][axis] == 0) {
        EXPECT_NEAR(shape.mesh.vertices[v][axis], 0, 1e-12);
      }
    }
}

TEST(HexFitting, PutsABlockOntoACylinder) {
  FittedShape shape = block_in_cylinder();
  ASSERT_EQ(count_invalid(shape.mesh), 0u);
  const HexFittingResult result = fit_onto(shape.mesh, shape.complex, shape.carriers, 1);
  EXPECT_EQ(result.off, 0u);
  EXPECT_EQ(count_invalid(shape.mesh), 0u);
  EXPECT_GT(worst_of(shape.mesh), 0.4);
  for (std::size_t v = 0; v < shape.mesh.vertices.size(); ++v) {
    const Vector3& p = shape.mesh.vertices[v];
    const double radius = std::hypot(p[0], p[1]);
    const HexCarrier::Kind kind = shape.carriers.of_vertex[v].kind;
    if (kind == HexCarrier::Kind::kInside) continue;
    const double off_side = std::abs(radius - 3), off_caps = std::min(std::abs(p[2]), std::abs(p[2] - 4));
    // A chord of 96 around is 1.6e-3 below the circle.
    const bool is_on_curve = kind == HexCarrier::Kind::kCurve;
    EXPECT_LT(is_on_curve ? std::max(off_side, off_caps) : std::min(off_side, off_caps), 2e-3);
  }
}

TEST(HexFitting, IsValidWhereverItIsInterrupted) {
  for (unsigned seed = 0; seed < 7; ++seed) {
    FittedShape shape = block_in_cylinder();
    disturb_validly(shape.mesh, 0.6, seed);
    unsigned told = 0;
    Monitor* asked = nullptr;
    Monitor monitor([&](const Progress&) {
      if (++told == seed + 1) asked->cancel();
    });
    asked = &monitor;
    {
      const WatchedLoops watched(monitor, Stops::kHeeded);
      EXPECT_THROW(fit_onto(shape.mesh, shape.complex, shape.carriers, 1), Error);
    }
    EXPECT_EQ(count_invalid(shape.mesh), 0u) << seed;
  }
}

TEST(VertexMoves, RaiseTheWorstHexahedraAndLowerNone) {
  FittedShape shape = lattice_in_box({5, 4, 3});
  disturb_validly(shape.mesh, 0.6, 7);
  const FittingTargets targets(shape.complex, shape.carriers, 1);
  VertexMoves moves(shape.mesh, targets);
  moves.snap(0.02);
  double worst = worst_of(shape.mesh);
  const double before = worst;
  for (int sweep = 0; sweep < 10; ++sweep) {
    moves.raise(0.3, sweep);
    const double now = worst_of(shape.mesh);
    EXPECT_GE(now, worst) << sweep;
    worst = now;
  }
  EXPECT_LT(before, 0.1);
  EXPECT_GT(worst, before + 0.1);
  EXPECT_EQ(count_invalid(shape.mesh), 0U);
  for (std::uint32_t v = 0; v < shape.mesh.vertices.size(); ++v) {
    if (shape.carriers.of_vertex[v].kind == HexCarrier::Kind::kInside || !moves.is_on_carrier(v)) continue;
    const Vector3& at = shape.mesh.vertices[v];
    EXPECT_LT(norm(targets.nearest(v, at, targets.normals_of(shape.mesh)[v]).point - at), 1e-9);
  }
}

TEST(HexFitting, NeverMakesAValidMeshInvalid) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    FittedShape shape = lattice_in_box({3, 3, 2});
    disturb_validly(shape.mesh, 2, seed);
    // Carriers that hexahedra cannot follow.
    std::rotate(shape.carriers.of_vertex.begin(), shape.carriers.of_vertex.begin() + 5,
                shape.carriers.of_vertex.end());
    for (auto& path : shape.carriers.path_of_curve) path.clear();
    for (HexCarrier& carrier : shape.carriers.of_vertex)
      if (carrier.kind == HexCarrier::Kind::kCurve) carrier = {};
    fit_onto(shape.mesh, shape.complex, shape.carriers, 1);
    EXPECT_EQ(count_invalid(shape.mesh), 0u) << seed;
  }
}

TEST(HexFitting, UntanglesAnInvertedMesh) {
  FittedShape shape = lattice_in_box({4, 4, 3});
  disturb(shape.mesh, 0.9, 3);
  ASSERT_GT(count_invalid(shape.mesh), 10u);
  const HexFittingResult result = fit_onto(shape.mesh, shape.complex, shape.carriers, 1);
  EXPECT_EQ(result.invalid, 0u);
  EXPECT_EQ(count_invalid(shape.mesh), 0u);
  EXPECT_GT(worst_of(shape.mesh), 0.99);
}

TEST(HexFitting, FitsTheRestWhereAnEdgeOfTwoHexahedraCannotBeValid) {
  FittedShape shape = lattice_in_box({4, 4, 4});
  // Two hexahedra in place of one, with two faces in common.
  const std::array<std::uint32_t, 8> cut = shape.mesh.hexahedra[21];
  const auto middle = static_cast<std::uint32_t>(shape.mesh.vertices.size());
  shape.mesh.vertices.push_back(0.5 * (shape.mesh.vertices[cut[0]] + shape.mesh.vertices[cut[2]]));
  shape.mesh.vertices.push_back(0.5 * (shape.mesh.vertices[cut[4]] + shape.mesh.vertices[cut[6]]));
  shape.carriers.of_vertex.resize(shape.mesh.vertices.size());
  shape.mesh.hexahedra[21] = {cut[0], cut[1], cut[2], middle, cut[4], cut[5], cut[6], middle + 1};
  shape.mesh.hexahedra.push_back({cut[0], middle, cut[2], cut[3], cut[4], middle + 1, cut[6], cut[7]});
  disturb(shape.mesh, 0.1, 2);
  const HexFittingResult result = fit_onto(shape.mesh, shape.complex, shape.carriers, 1);
  EXPECT_GE(result.invalid, 1u);
  EXPECT_LE(result.invalid, 2u);
  EXPECT_EQ(result.off, 0u);
}

TEST(HexFitting, KeepsToASurfaceWithoutFeatures) {
  FittedShape shape;
  shape.complex = feature_complex(prepare_surface(make_sphere(2, 4)));
  shape.mesh = testing::lattice_mesh({4, 4, 4}, [](int, int, int) { return 1; });
  for (Vector3& p : shape.mesh.vertices) p = 0.8 * (p - Vector3{2, 2, 2});
  const HexCarriers carriers = carriers_without_features(shape.mesh, shape.complex);
  fit_onto(shape.mesh, shape.complex, carriers, 1);
  EXPECT_EQ(count_invalid(shape.mesh), 0u);
  for (std::size_t v = 0; v < shape.mesh.vertices.size(); ++v) {
    if (carriers.of_vertex[v].kind != HexCarrier::Kind::kFace) continue;
    EXPECT_NEAR(norm(shape.mesh.vertices[v]), 2, 0.1) << v;
  }
}

/// The shape turned and four times as large.
FittedShape moved(FittedShape shape) {
  const Quaternion turn = normalised(Quaternion{0.5, 0.3, -0.4, 0.7});
  const auto move = [&](Vector3& p) { p = 4.0 * rotate(turn, p); };
  std::ranges::for_each(shape.mesh.vertices, move);
  std::ranges::for_each(shape.complex.vertices, move);
  for (auto& corner : shape.complex.corners) move(corner.point);
  for (auto& face : shape.complex.faces) face.area *= 16;
  for (auto& curve : shape.complex.curves) curve.length *= 4;
  return shape;
}

TEST(HexFitting, TurnsAndScalesWithItsInput) {
  FittedShape plain = lattice_in_box({4, 3, 3});
  disturb_validly(plain.mesh, 0.3, 4);
  FittedShape turned = moved(plain);
  fit_onto(plain.mesh, plain.complex, plain.carriers, 1);
  fit_onto(turned.mesh, turned.complex, turned.carriers, 4);
  EXPECT_LT(furthest_apart(moved(plain).mesh.vertices, turned.mesh.vertices), 0.02);
  // Around an axis there are many meshes of nearly the same energy.
  FittedShape round = block_in_cylinder(), turned_round = moved(round);
  fit_onto(round.mesh, round.complex, round.carriers, 1);
  fit_onto(turned_round.mesh, turned_round.complex, turned_round.carriers, 4);
  EXPECT_NEAR(worst_of(round.mesh), worst_of(turned_round.mesh), 0.02);
}

TEST(HexFitting, HasTheSameBitsForAnyNumberOfThreads) {
  const auto places = [](int threads) {
    const ThreadLimit limit(threads);
    FittedShape shape = block_in_cylinder();
    disturb_validly(shape.mesh, 0.3, 5);
    fit_onto(shape.mesh, shape.complex, shape.carriers, 1);
    return shape.mesh.vertices;
  };
  EXPECT_EQ(places(1), places(2));
}

}  // namespace
}  // namespace crossgrain
