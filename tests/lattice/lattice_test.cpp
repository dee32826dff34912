// SPDX-License-Identifier: Apache-2.0
#include "lattice/lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/vector3.hpp"
#include "crossgrain/thread_limit.hpp"
#include "measure/hex_quality.hpp"
#include "support/shapes.hpp"
#include "surface/shells.hpp"

namespace crossgrain {
namespace {

Surface surface_of(TriangleMesh mesh) {
  return prepare_surface(CheckedMesh::derived(std::move(mesh)));
}

TEST(Lattice, OfATurnedBoxFillsItExactly) {
  const Quaternion turn = from_rotation_vector({0.5, 0.3, -0.2});
  const Lattice lattice = lattice_of(surface_of(rotate_mesh(make_box({4, 3, 2}), turn)), 0.5);
  EXPECT_EQ(lattice.mesh.hexahedra.size(), 8u * 6 * 4);
  EXPECT_EQ(lattice.mesh.boundary.size(), 2u * (48 + 32 + 24));
  EXPECT_EQ(lattice.shells, std::vector<int>{2});
  for (const double shape : scaled_jacobians(lattice.mesh)) EXPECT_NEAR(shape, 1, 1e-9);
}

TEST(Lattice, HasTheTopologyOfItsSurface) {
  const Surface torus = surface_of(make_torus(2, 0.7, 64, 32));
  EXPECT_EQ(lattice_of(torus, 0.3).shells, euler_numbers_of_shells(torus.mesh.triangles));
  const Surface hollow = surface_of(join_meshes(make_sphere(2, 4), flip_mesh(make_sphere(1, 4))));
  EXPECT_EQ(lattice_of(hollow, 0.2).shells, (std::vector<int>{2, 2}));
}

TEST(Lattice, HasOtherPlanesWhereWallsAreThinAndHolesAreNarrow) {
  const auto has_other = [](const Surface& surface, double size, std::vector<Hole> holes = {}) {
    return has_other_planes(surface, size, {.holes = std::move(holes)}, NarrowLevel::kHoles);
  };
  const Surface plate = surface_of(make_box({10, 8, 5}));
  EXPECT_FALSE(has_other(plate, 1));
  const Surface hollow = surface_of(join_meshes(make_box({10, 8, 5}), flip_mesh(make_box({9.6, 7.6, 4.6}))));
  EXPECT_TRUE(has_other(hollow, 1));
  EXPECT_FALSE(has_other(hollow, 0.1)) << "its walls are two cells thick";
  EXPECT_TRUE(has_other(plate, 1, {{{{0.2, 0.3, -2.5}, {1.5, 1.6, 2.5}}}}));
}

TEST(Lattice, IsTheSameForAnyNumberOfThreads) {
  const Surface surface = surface_of(rotate_mesh(make_bracket(24), from_rotation_vector({0.1, 0.2, 0.3})));
  const Lattice many = lattice_of(surface, 0.2);
  const ThreadLimit limit(1);
  const Lattice one = lattice_of(surface, 0.2);
  EXPECT_EQ(one.mesh.vertices, many.mesh.vertices);
  EXPECT_EQ(one.mesh.hexahedra, many.mesh.hexahedra);
}

}  // namespace
}  // namespace crossgrain
