// SPDX-License-Identifier: Apache-2.0
#include "tets/inner_walls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "base/vector3.hpp"
#include "surface/surface.hpp"
#include "surface/topology.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

constexpr TetBox kBox{{4, 2, 2}};

/// Region 5 up to x = 1 and region -2 beyond.
TetMesh two_regions() {
  return with_regions(kBox.mesh(), [](const Vector3& p) { return p[0] < 1 ? 5 : -2; });
}

TEST(InnerWalls, AreTheFacesBetweenRegionsOutwardOfTheLowerOne) {
  const TetSolid solid = solid_of(two_regions());
  std::vector<Warning> warnings;
  const std::vector<InnerWall> walls = find_inner_walls(solid, warnings);
  EXPECT_EQ(walls.size(), 8u);
  for (const InnerWall& wall : walls) {
    EXPECT_TRUE(wall.separates_regions);
    EXPECT_EQ(solid.mesh.regions[wall.tets[0]], -2);
    EXPECT_EQ(solid.mesh.regions[wall.tets[1]], 5);
    const auto& v = solid.mesh.vertices;
    const TriangleShape shape = shape_of({v[wall.vertices[0]], v[wall.vertices[1]], v[wall.vertices[2]]});
    EXPECT_EQ(shape.normal, (Vector3{-1, 0, 0}));
  }
  EXPECT_TRUE(warnings.empty());
}

TEST(InnerWalls, AreTaggedFacesInsideToo) {
  TetMesh mesh = kBox.mesh();
  const auto at = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) { return kBox.at(x, y, z); };
  mesh.feature_faces = {{{at(2, 1, 1), at(2, 0, 0), at(2, 1, 0)}, 1},   // inside
                        {{at(0, 0, 0), at(0, 1, 0), at(0, 1, 1)}, 2},   // on the boundary
                        {{at(0, 0, 0), at(4, 2, 2), at(1, 1, 0)}, 3}};  // of no tet
  const TetSolid solid = solid_of(mesh);
  std::vector<Warning> warnings;
  const std::vector<InnerWall> walls = find_inner_walls(solid, warnings);
  ASSERT_EQ(walls.size(), 1u);
  EXPECT_FALSE(walls[0].separates_regions);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].kind, WarningKind::kStrayTags);
  EXPECT_EQ(warnings[0].text, "tagged triangles that are not a face of any tet, ignored: 1 of 3");
}

TEST(ModelFacesOfTets, AreTheTaggedOnesWithTheSolidsThatTheyBound) {
  TetMesh mesh = two_regions();
  const auto at = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) { return kBox.at(x, y, z); };
  mesh.feature_faces = {{{at(2, 1, 1), at(2, 0, 0), at(2, 1, 0)}, 3},  // inside a region
                        {{at(1, 1, 1), at(1, 0, 0), at(1, 1, 0)}, 2},  // between two
                        {{at(0, 0, 0), at(0, 1, 0), at(0, 1, 1)}, 9},  // on the boundary
                        {{at(0, 0, 0), at(0, 0, 1), at(0, 1, 1)}, 9}};
  const TetSolid solid = solid_of(mesh);
  std::vector<Warning> warnings;
  const std::vector<ModelFace> faces = model_faces(solid, find_inner_walls(solid, warnings));
  ASSERT_EQ(faces.size(), 3u);
  EXPECT_EQ(faces[0].number, 2);
  EXPECT_EQ(faces[0].solids, 2u);
  EXPECT_EQ(faces[1].solids, 0u);
  EXPECT_EQ(faces[2].solids, 1u);
  EXPECT_EQ(faces[2].kind, FaceKind::kTagged);
  EXPECT_DOUBLE_EQ(faces[2].area, 1);
  EXPECT_LT(norm(faces[2].centre - Vector3{0, 0.5, 0.5}), 1e-12);
}

TEST(ModelFacesOfTets, AreThoseOfTheModelThatTheTetsWereMadeOf) {
  TetMesh mesh = kBox.mesh();
  mesh.feature_faces = {{{kBox.at(0, 0, 0), kBox.at(0, 1, 0), kBox.at(0, 1, 1)}, 2}};
  mesh.given =
      std::make_shared<const GivenModel>(GivenModel{ModelSource::kCad, {{5, FaceKind::kSphere, 2}}, {}});
  const std::vector<ModelFace> faces = model_faces(solid_of(mesh), {});
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_EQ(faces[0].kind, FaceKind::kSphere);
}

TEST(InnerWalls, AreNoneOfAPlainMesh) {
  std::vector<Warning> warnings;
  EXPECT_TRUE(find_inner_walls(solid_of(kBox.mesh()), warnings).empty());
  const TetMesh one_region = with_regions(kBox.mesh(), [](const Vector3&) { return 3; });
  EXPECT_FALSE(has_several_regions(one_region));
  EXPECT_TRUE(find_inner_walls(solid_of(one_region), warnings).empty());
}

TEST(FollowedEdges, AreStatedOnesAndThoseOfNoFace) {
  TetMesh mesh = two_regions();
  const std::uint32_t middle = kBox.at(1, 1, 1);
  const std::array inside{middle, kBox.at(2, 1, 1)}, on_boundary{kBox.at(0, 1, 1), kBox.at(0, 2, 1)},
      on_wall{middle, kBox.at(1, 1, 0)};
  for (const auto& vertices : {inside, on_boundary, on_wall}) {
    mesh.feature_edges.push_back({vertices, 3, /*is_stated=*/false});
    mesh.feature_edges.push_back({{vertices[1], vertices[0]}, 4, /*is_stated=*/false});
  }
  mesh.feature_edges.push_back({on_boundary, 5});
  const TetSolid solid = solid_of(mesh);
  std::vector<Warning> warnings;
  const auto followed = followed_edges(solid, find_inner_walls(solid, warnings));
  EXPECT_EQ(followed, (std::vector{inside, {inside[1], inside[0]}, on_boundary}));
}

TEST(ModelSurface, OfAPlainMeshIsItsBoundary) {
  const TetSolid solid = solid_of(kBox.mesh());
  const TriangleMesh surface = model_surface(solid, {}), boundary = boundary_surface(solid);
  EXPECT_EQ(surface.vertices, boundary.vertices);
  EXPECT_EQ(surface.triangles, boundary.triangles);
  EXPECT_TRUE(surface.solids.empty() && surface.creases.empty() && surface.inner_faces.empty());
}

TEST(ModelSurface, OfRegionsHasEachAsAClosedSolid) {
  const TetSolid solid = solid_of(two_regions());
  std::vector<Warning> warnings;
  const TriangleMesh surface = model_surface(solid, find_inner_walls(solid, warnings));
  for (const std::int32_t region : {-2, 5}) {
    TriangleMesh own{surface.vertices, {}};
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
      if (surface.solids[t] == region) own.triangles.push_back(surface.triangles[t]);
    EXPECT_TRUE(analyse_topology(own).watertight);
    double volume = 0;
    for (const auto& [a, b, c] : own.triangles) {
      const auto& v = own.vertices;
      volume += dot(v[a], cross(v[b], v[c])) / 6;
    }
    EXPECT_NEAR(volume, region == 5 ? 4 : 12, 1e-12);
  }
}

TEST(ModelSurface, HasTaggedEdgesAndSharpOnesForCreases) {
  TetMesh mesh = kBox.mesh();
  // Straight through the middle, along x.
  for (std::uint32_t x = 0; x < 4; ++x)
    mesh.feature_edges.push_back({{kBox.at(x, 1, 1), kBox.at(x + 1, 1, 1)}, 9});
  const TriangleMesh surface = model_surface(solid_of(mesh), {});
  const auto inside = [](const CreaseCurve& curve) {
    return std::all_of(curve.points.begin(), curve.points.end(),
                       [](const Vector3& p) { return p[1] == 1 && p[2] == 1; });
  };
  EXPECT_EQ(surface.creases.size(), 13u);
  EXPECT_EQ(std::count_if(surface.creases.begin(), surface.creases.end(), inside), 1);
}

}  // namespace
}  // namespace crossgrain
