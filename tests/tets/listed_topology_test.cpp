// SPDX-License-Identifier: Apache-2.0
#include "tets/listed_topology.hpp"

#include <gtest/gtest.h>

#include "tets/listed_meshes.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

constexpr TetBox kBox{{5, 4, 4}};

struct Dropped {
  TetMesh mesh;
  std::vector<Warning> warnings;
};

Dropped dropped(TetMesh mesh, const TetTagOptions& options = {}) {
  Dropped result;
  TetSolid solid = prepare_tets(std::move(mesh), result.warnings);
  drop_listed_topology(solid, options, result.warnings);
  result.mesh = std::move(solid.mesh);
  std::erase_if(result.warnings, [](const Warning& w) { return w.kind != WarningKind::kListedTopology; });
  return result;
}

/// 0 inside and 1 to 6 on the sides of kBox.
std::int32_t side_of(const Vector3& centre) {
  const std::array<double, 3> size{5, 4, 4};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (centre[axis] == 0) return static_cast<std::int32_t>(1 + 2 * axis);
    if (centre[axis] == size[axis]) return static_cast<std::int32_t>(2 + 2 * axis);
  }
  return 0;
}

TEST(ListedTopology, IsAllFacesInsideWhileThoseOfTheBoundaryKeepTheirTags) {
  const Dropped result = dropped(with_all_faces(kBox.mesh(), side_of));
  ASSERT_EQ(result.warnings.size(), 1u);
  // 6 tets a cube; 2 faces a square of the boundary.
  const std::size_t boundary = 2 * 2 * (5 * 4 + 5 * 4 + 4 * 4), inside = (4 * 6 * 80 - boundary) / 2;
  EXPECT_EQ(result.warnings[0].text,
            "lists and tags that name nearly everything are ignored: " + std::to_string(inside) + " of " +
                std::to_string(inside) + " faces inside");
  EXPECT_EQ(result.warnings[0].remedy, Remedy::kKeepTags);
  EXPECT_EQ(result.mesh.feature_faces.size(), boundary);
  for (const TetMesh::Face& face : result.mesh.feature_faces) EXPECT_NE(face.tag, 0);
}

TEST(ListedTopology, LeavesFacesInsideWithATagOfTheirOwn) {
  const auto tag_of = [](const Vector3& centre) { return centre[0] == 2 ? 7 : 0; };
  const Dropped result = dropped(with_all_faces(kBox.mesh(), tag_of));
  EXPECT_EQ(std::count_if(result.mesh.feature_faces.begin(), result.mesh.feature_faces.end(),
                          [](const TetMesh::Face& face) { return face.tag == 7; }),
            2 * 4 * 4);
  EXPECT_EQ(result.warnings.size(), 1u);
}

TEST(ListedTopology, IsAllFacesInsideWithRunningNumbersForTags) {
  std::int32_t next = 0;
  const Dropped result = dropped(with_all_faces(kBox.mesh(), [&](const Vector3&) { return next++; }));
  EXPECT_EQ(result.mesh.feature_faces.size(), 2u * 2 * (5 * 4 + 5 * 4 + 4 * 4));
  EXPECT_EQ(result.warnings.size(), 1u);
}

TEST(ListedTopology, IsNotTheBoundaryNorOneSurfaceInside) {
  TetMesh mesh = with_all_faces(kBox.mesh(), side_of);
  std::erase_if(mesh.feature_faces, [](const TetMesh::Face& face) { return face.tag == 0; });
  TetMesh wall = with_all_faces(kBox.mesh(), [](const Vector3& centre) { return centre[0] == 2 ? 7 : 0; });
  std::erase_if(wall.feature_faces, [](const TetMesh::Face& face) { return face.tag == 0; });
  for (const TetMesh& listed : {mesh, wall}) {
    const Dropped result = dropped(listed);
    EXPECT_EQ(result.mesh.feature_faces.size(), listed.feature_faces.size());
    EXPECT_TRUE(result.warnings.empty());
  }
}

TEST(ListedTopology, IsAllEdgesOfAllTets) {
  const Dropped result = dropped(with_all_edges(kBox.mesh()));
  EXPECT_TRUE(result.mesh.feature_edges.empty());
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_NE(result.warnings[0].text.find("edges inside"), std::string::npos);
  EXPECT_NE(result.warnings[0].text.find("edges of the surface"), std::string::npos);
}

TEST(ListedTopology, IsAllEdgesOfTheSurfaceAlone) {
  TetMesh mesh = with_all_edges(kBox.mesh());
  std::erase_if(mesh.feature_edges, [&](const TetMesh::Edge& edge) {
    const Vector3 middle = 0.5 * (mesh.vertices[edge.vertices[0]] + mesh.vertices[edge.vertices[1]]);
    return side_of(middle) == 0;
  });
  EXPECT_TRUE(dropped(mesh).mesh.feature_edges.empty());
  // Not stated, they count only where the surface is sharp.
  for (TetMesh::Edge& edge : mesh.feature_edges) edge.is_stated = false;
  const Dropped result = dropped(mesh);
  EXPECT_EQ(result.mesh.feature_edges.size(), mesh.feature_edges.size());
  EXPECT_TRUE(result.warnings.empty());
}

TEST(ListedTopology, LeavesEdgesWithATagOfTheirOwn) {
  TetMesh mesh = with_all_edges(kBox.mesh());
  std::size_t tagged = 0;
  for (TetMesh::Edge& edge : mesh.feature_edges) {
    // Straight through the middle, along x.
    const bool through = std::all_of(edge.vertices.begin(), edge.vertices.end(), [&](std::uint32_t v) {
      return mesh.vertices[v][1] == 2 && mesh.vertices[v][2] == 2;
    });
    edge.tag = through ? 9 : 0;
    tagged += through;
  }
  const Dropped result = dropped(mesh);
  EXPECT_EQ(tagged, 5u);
  EXPECT_EQ(result.mesh.feature_edges.size(), tagged);
  for (const TetMesh::Edge& edge : result.mesh.feature_edges) EXPECT_EQ(edge.tag, 9);
}

TEST(ListedTopology, IsARegionForEachTetOrEachCube) {
  for (const std::int32_t tets : {1, 6}) {
    TetMesh mesh = kBox.mesh();
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
      mesh.regions.push_back(static_cast<std::int32_t>(t) / tets);
    const Dropped result = dropped(mesh);
    EXPECT_TRUE(result.mesh.regions.empty());
    ASSERT_EQ(result.warnings.size(), 1u);
    EXPECT_NE(result.warnings[0].text.find(std::to_string(480 / tets) + " regions for 480 tets"),
              std::string::npos);
  }
}

TEST(ListedTopology, IsNotARegionForEachLayerOfCubes) {
  const TetBox layers{{24, 2, 2}};
  const TetMesh mesh =
      with_regions(layers.mesh(), [](const Vector3& p) { return static_cast<std::int32_t>(p[0]); });
  const Dropped result = dropped(mesh);
  EXPECT_EQ(result.mesh.regions, mesh.regions);
  EXPECT_TRUE(result.warnings.empty());
}

TEST(ListedTopology, IsNothingOfAFewTets) {
  TetMesh mesh = with_all_edges(with_all_faces(corner_tet(), [](const Vector3&) { return 0; }));
  mesh.regions = {3};
  const Dropped result = dropped(mesh);
  EXPECT_EQ(result.mesh.feature_edges.size(), 6u);
  EXPECT_EQ(result.mesh.feature_faces.size(), 4u);
  EXPECT_EQ(result.mesh.regions.size(), 1u);
  EXPECT_TRUE(result.warnings.empty());
}

TEST(ListedTopology, CountsIfAllTagsAreKept) {
  TetMesh mesh = with_all_edges(with_all_faces(kBox.mesh(), side_of));
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) mesh.regions.push_back(static_cast<std::int32_t>(t));
  const Dropped result = dropped(mesh, {.keep_all = true});
  EXPECT_EQ(result.mesh.feature_edges.size(), mesh.feature_edges.size());
  EXPECT_EQ(result.mesh.feature_faces.size(), mesh.feature_faces.size());
  EXPECT_EQ(result.mesh.regions, mesh.regions);
  EXPECT_TRUE(result.warnings.empty());
}

}  // namespace
}  // namespace crossgrain
