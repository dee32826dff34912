// SPDX-License-Identifier: Apache-2.0
#include "lattice/volume_shares.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "crossgrain/thread_limit.hpp"
#include "lattice/lattice_planes.hpp"
#include "support/shapes.hpp"
#include "surface/bvh.hpp"
#include "surface/winding_number.hpp"

namespace crossgrain {
namespace {

Surface surface_of(TriangleMesh mesh) {
  return prepare_surface(CheckedMesh::derived(std::move(mesh)));
}

double volume_of(const std::vector<float>& shares, const LatticePlanes& planes) {
  double volume = 0;
  std::size_t cell = 0;
  const auto side = [&](std::size_t axis, std::size_t k) {
    return planes.at[axis][k + 1] - planes.at[axis][k];
  };
  for (std::size_t i = 0; i < planes.cells(0); ++i)
    for (std::size_t j = 0; j < planes.cells(1); ++j)
      for (std::size_t k = 0; k < planes.cells(2); ++k)
        volume += static_cast<double>(shares[cell++]) * side(0, i) * side(1, j) * side(2, k);
  return volume;
}

TEST(VolumeShares, OfABoxOnPlanesAreOneInsideAndNothingOutside) {
  const Surface surface = surface_of(make_box({4, 3, 2}));
  const LatticePlanes planes = lattice_planes(surface, 0.5);
  const std::vector<float> shares = volume_shares(surface, planes);
  std::size_t inside = 0;
  for (const float share : shares) {
    EXPECT_TRUE(share == 0 || std::abs(share - 1) < 1e-6F) << share;
    inside += share > 0.5F;
  }
  EXPECT_EQ(inside, 8u * 6 * 4);
}

TEST(VolumeShares, AddUpToTheVolumeOfASphereAndOfATorus) {
  const Surface sphere = surface_of(make_sphere(1, 5));
  const LatticePlanes around = lattice_planes(sphere, 0.13);
  EXPECT_NEAR(volume_of(volume_shares(sphere, around), around), enclosed_volume(sphere), 2e-3);
  const Surface torus =
      surface_of(rotate_mesh(make_torus(1, 0.4, 64, 32), from_rotation_vector({0.4, 0.7, 0.2})));
  const LatticePlanes of_torus = lattice_planes(torus, 0.1);
  EXPECT_NEAR(volume_of(volume_shares(torus, of_torus), of_torus), enclosed_volume(torus), 4e-3);
}

TEST(VolumeShares, OfSolidsThatOverlapAreThoseOfTheirUnion) {
  const Surface surface =
      surface_of(join_meshes(make_box({2, 2, 2}), translate_mesh(make_box({2, 2, 2}), {1, 0, 0})));
  const LatticePlanes planes = lattice_planes(surface, 0.5);
  EXPECT_NEAR(volume_of(volume_shares(surface, planes), planes), 12, 1e-5);
}

TEST(VolumeShares, AreWholeWhereRaysGoThroughEdgesAndVertices) {
  // A box whose faces are cut into triangles at places of the rays: a ray that is lost or counted twice in
  // one of their edges would fill or empty a row of cells.
  TriangleMesh mesh = make_sphere(1, 2);
  for (Vector3& p : mesh.vertices)
    for (double& x : p) x = std::round(8 * x) / 8;
  const Surface surface = surface_of(std::move(mesh));
  LatticePlanes planes;
  for (auto& at : planes.at)
    for (int k = -3; k <= 3; ++k) at.push_back(0.5 * k + 1.0 / 16);
  EXPECT_NEAR(volume_of(volume_shares(surface, planes), planes), enclosed_volume(surface), 0.03);
  for (const float share : volume_shares(surface, planes)) {
    EXPECT_GE(share, 0);
    EXPECT_LE(share, 1.00001F);
  }
}

TEST(VolumeShares, AreNearThoseOfRandomPoints) {
  const Surface surface = surface_of(rotate_mesh(make_bracket(16), from_rotation_vector({0.2, 0.1, -0.4})));
  const LatticePlanes planes = lattice_planes(surface, 0.5);
  const std::vector<float> shares = volume_shares(surface, planes);
  const TriangleBvh bvh(surface);
  const WindingNumber winding(bvh);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(0, 1);
  for (int k = 0; k < 60; ++k) {
    std::array<std::size_t, 3> cell;
    for (std::size_t axis = 0; axis < 3; ++axis)
      cell[axis] = static_cast<std::size_t>(part(random) * static_cast<double>(planes.cells(axis)));
    int inside = 0;
    constexpr int kPoints = 400;
    for (int n = 0; n < kPoints; ++n) {
      Vector3 p;
      for (std::size_t axis = 0; axis < 3; ++axis)
        p[axis] = std::lerp(planes.at[axis][cell[axis]], planes.at[axis][cell[axis] + 1], part(random));
      inside += winding.inside(p);
    }
    const float share = shares[(cell[0] * planes.cells(1) + cell[1]) * planes.cells(2) + cell[2]];
    EXPECT_NEAR(share, static_cast<double>(inside) / kPoints, 0.12);
  }
}

TEST(VolumeShares, AreTheSameForAnyNumberOfThreads) {
  const Surface surface = surface_of(make_sphere(1, 4));
  const LatticePlanes planes = lattice_planes(surface, 0.1);
  const std::vector<float> many = volume_shares(surface, planes);
  const ThreadLimit one(1);
  EXPECT_EQ(volume_shares(surface, planes), many);
}

}  // namespace
}  // namespace crossgrain
