// SPDX-License-Identifier: Apache-2.0
#include "measure/hex_quality.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/quaternion.hpp"
#include "measure/hex_faces.hpp"

namespace crossgrain {
namespace {

/// Bricks of a box along its sides, with edges of length 1.
HexMesh bricks(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz) {
  HexMesh mesh;
  const auto at = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return x + (nx + 1) * (y + (ny + 1) * z);
  };
  for (std::uint32_t z = 0; z <= nz; ++z)
    for (std::uint32_t y = 0; y <= ny; ++y)
      for (std::uint32_t x = 0; x <= nx; ++x) mesh.vertices.push_back({double(x), double(y), double(z)});
  for (std::uint32_t z = 0; z < nz; ++z)
    for (std::uint32_t y = 0; y < ny; ++y)
      for (std::uint32_t x = 0; x < nx; ++x)
        mesh.hexahedra.push_back({at(x, y, z), at(x + 1, y, z), at(x + 1, y + 1, z), at(x, y + 1, z),
                                  at(x, y, z + 1), at(x + 1, y, z + 1), at(x + 1, y + 1, z + 1),
                                  at(x, y + 1, z + 1)});
  return mesh;
}

TEST(HexQuality, OfACubeIsOneHoweverItLies) {
  HexMesh mesh = bricks(1, 1, 1);
  for (Vector3& p : mesh.vertices) p = 3.0 * rotate(from_rotation_vector({0.4, -1, 0.3}), p);
  EXPECT_NEAR(scaled_jacobians(mesh)[0], 1, 1e-14);
  EXPECT_NEAR(volumes_of(mesh)[0], 27, 1e-12);
}

TEST(HexQuality, OfAShearedCubeIsTheSineOfItsAngle) {
  HexMesh mesh = bricks(1, 1, 1);
  for (Vector3& p : mesh.vertices) p[0] += std::tan(0.3) * p[1];
  EXPECT_NEAR(scaled_jacobians(mesh)[0], std::cos(0.3), 1e-14);
  EXPECT_NEAR(volumes_of(mesh)[0], 1, 1e-14);
}

TEST(HexQuality, IsNegativeWhereACornerIsPushedThroughTheOppositeFace) {
  HexMesh mesh = bricks(1, 1, 1);
  mesh.vertices[0] = {1.5, 1.5, 1.5};
  EXPECT_LT(scaled_jacobians(mesh)[0], 0);
  mesh.vertices[0] = mesh.vertices[1];
  EXPECT_EQ(scaled_jacobians(mesh)[0], 0);
}

TEST(HexQuality, VolumesAreThoseOfTheTrilinearMap) {
  // (x + y z / 2, y, z + x y / 4) has the determinant 1 - y^2 / 8, of integral 1 - 1/24.
  HexMesh mesh = bricks(1, 1, 1);
  for (Vector3& p : mesh.vertices) p = {p[0] + p[1] * p[2] / 2, p[1], p[2] + p[0] * p[1] / 4};
  EXPECT_NEAR(volumes_of(mesh)[0], 1 - 1.0 / 24, 1e-14);
}

TEST(HexTopology, OfBricksHasTheBoundaryOfTheBoxAndItsValences) {
  HexMesh mesh = bricks(3, 2, 2);
  const HexTopology topology = topology_of(mesh);
  EXPECT_TRUE(topology.is_closed());
  EXPECT_EQ(topology.pinched_vertices, 0u);
  EXPECT_EQ(topology.boundary.size(), 2u * (6 + 6 + 4));
  // Edges inside have four, those of the faces two, those of the box one.
  EXPECT_EQ(topology.inner_valences, (std::vector<std::size_t>{0, 0, 0, 0, 3 + 4 * 1 + 4 * 1}));
  EXPECT_EQ(topology.boundary_valences[1], 4u * (3 + 2 + 2));
  for (const HexSide& side : topology.boundary) mesh.boundary.push_back({side.vertices, 0});
  EXPECT_NEAR(boundary_area(mesh), 32, 1e-12);
}

TEST(HexTopology, FindsAMissingJoinAndATwist) {
  HexMesh mesh = bricks(2, 1, 1);
  HexMesh twisted = mesh;
  twisted.hexahedra[1] = {twisted.hexahedra[1][4], twisted.hexahedra[1][5], twisted.hexahedra[1][6],
                          twisted.hexahedra[1][7], twisted.hexahedra[1][0], twisted.hexahedra[1][1],
                          twisted.hexahedra[1][2], twisted.hexahedra[1][3]};
  EXPECT_EQ(topology_of(twisted).crowded_faces, 1u);  // it lies on the same side of their face
  // A vertex of one's own at the common face: both halves are closed, and touch along an edge.
  mesh.vertices.push_back(mesh.vertices[mesh.hexahedra[1][0]]);
  mesh.hexahedra[1][0] = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  EXPECT_FALSE(topology_of(mesh).is_closed());
}

}  // namespace
}  // namespace crossgrain
