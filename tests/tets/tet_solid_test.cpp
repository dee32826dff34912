// SPDX-License-Identifier: Apache-2.0
#include "tets/tet_solid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "crossgrain/error.hpp"
#include "crossgrain/thread_limit.hpp"
#include "surface/topology.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

double enclosed_volume(const TriangleMesh& mesh) {
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    volume += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c])) / 6;
  return volume;
}

void expect_error(const TetMesh& mesh, const std::string& part) {
  std::vector<Warning> warnings;
  try {
    prepare_tets(mesh, warnings);
    ADD_FAILURE() << "no error about " << part;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    const std::string message = error.what();
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

/// The solid; expects exactly one warning, which holds `part`.
TetSolid warned(const TetMesh& mesh, const std::string& part) {
  std::vector<Warning> warnings;
  TetSolid solid = prepare_tets(mesh, warnings);
  EXPECT_EQ(warnings.size(), 1u);
  for (const Warning& warning : warnings)
    EXPECT_NE(warning.text.find(part), std::string::npos) << warning.text;
  return solid;
}

/// A box with all its tets positive.
TetMesh tidy_box(const TetBox& box) {
  return solid_of(box.mesh(0.1)).mesh;
}

TEST(TetSolid, LeavesATidyMeshAsItIs) {
  const TetMesh mesh = tidy_box({{2, 3, 4}});
  std::vector<Warning> warnings;
  const TetSolid solid = prepare_tets(mesh, warnings);
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(solid.mesh.vertices, mesh.vertices);
  EXPECT_EQ(solid.mesh.tets, mesh.tets);
  EXPECT_EQ(solid.components, 1u);
}

TEST(TetSolid, HasAClosedBoundaryThatFacesOutward) {
  const TetSolid solid = solid_of(TetBox{{2, 3, 4}}.mesh(0.1));
  EXPECT_EQ(solid.boundary.size(), 2u * 2 * (2 * 3 + 3 * 4 + 4 * 2));
  const TriangleMesh surface = boundary_surface(solid);
  EXPECT_TRUE(analyse_topology(surface).watertight);
  EXPECT_NEAR(enclosed_volume(surface), 24, 1e-12);
}

TEST(TetSolid, NamesTheTetsOnBothSidesOfEachFace) {
  const TetSolid solid = solid_of(TetBox{{2, 3, 4}}.mesh());
  EXPECT_EQ(2 * solid.inner_faces.size() + solid.boundary.size(), 4 * solid.mesh.tets.size());
  const auto has = [&](std::uint32_t tet, std::uint32_t vertex) {
    return std::ranges::count(solid.mesh.tets[tet], vertex) == 1;
  };
  for (const auto& face : solid.inner_faces) {
    EXPECT_LT(face.tets[0], face.tets[1]);
    for (const std::uint32_t tet : face.tets)
      for (const std::uint32_t v : face.vertices) EXPECT_TRUE(has(tet, v));
  }
  for (std::size_t f = 0; f < solid.boundary.size(); ++f)
    for (const std::uint32_t v : solid.boundary[f]) EXPECT_TRUE(has(solid.boundary_tets[f], v));
}

TEST(TetSolid, SortsItsFaces) {
  const TetSolid solid = solid_of(TetBox{{2, 3, 4}}.mesh());
  EXPECT_TRUE(std::ranges::is_sorted(solid.inner_faces, {}, &TetSolid::InnerFace::vertices));
  auto boundary = solid.boundary;
  for (auto& face : boundary) std::ranges::sort(face);
  EXPECT_TRUE(std::ranges::is_sorted(boundary));
}

TEST(TetSolid, TurnsInvertedTets) {
  TetMesh mesh = tidy_box({{2, 2, 2}});
  for (const std::size_t t : {7u, 5u, 30u}) std::swap(mesh.tets[t][0], mesh.tets[t][1]);
  const TetSolid solid = warned(mesh, "inverted tets, reoriented: 3; the first is tet 5 ");
  EXPECT_EQ(solid.inverted_tets, 3u);
  EXPECT_EQ(solid.mesh.tets.size(), 48u);
  EXPECT_NEAR(volume_of_tets(solid.mesh), 8, 1e-13);
}

/// A square pyramid on the square 0 1 2 3 with its tip, 4, above, cut along 0 2; the flat tet 0 1 2 3 below.
TetMesh pyramid_on_a_flat_tet() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}},
          {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 2, 3, 4}}};
}

/// The same with another pyramid below, cut along 1 3, so that the flat tet lies inside.
TetMesh octahedron_with_a_flat_tet() {
  TetMesh mesh = pyramid_on_a_flat_tet();
  mesh.vertices.push_back({0.5, 0.5, -1});
  mesh.tets.push_back({0, 3, 1, 5});
  mesh.tets.push_back({1, 3, 2, 5});
  return mesh;
}

TEST(TetSolid, LeavesOutAFlatTetInsideWithoutOpeningASlit) {
  const TetSolid solid =
      warned(octahedron_with_a_flat_tet(), "without volume, left out: 1; the first is tet 0 ");
  EXPECT_EQ(solid.left_out_tets, 1u);
  EXPECT_EQ(solid.flat_tets, (std::vector{octahedron_with_a_flat_tet().tets[0]}));
  EXPECT_EQ(solid.mesh.tets.size(), 4u);
  EXPECT_EQ(solid.boundary.size(), 8u);
  EXPECT_EQ(solid.components, 1u);
  const auto beside_flat = std::ranges::count_if(
      solid.inner_faces, [](const TetSolid::InnerFace& face) { return face.tets[1] == kNoTet; });
  EXPECT_EQ(beside_flat, 4);
  EXPECT_EQ(solid.inner_faces.size(), 6u);
  EXPECT_TRUE(analyse_topology(boundary_surface(solid)).watertight);
}

TEST(TetSolid, FacesOutwardWhereAFlatTetIsTheBoundary) {
  for (const bool other_way : {false, true}) {
    TetMesh mesh = pyramid_on_a_flat_tet();
    if (other_way) std::swap(mesh.tets[0][0], mesh.tets[0][1]);
    const TetSolid solid = warned(mesh, "without volume");
    const TriangleMesh surface = boundary_surface(solid);
    EXPECT_TRUE(analyse_topology(surface).watertight);
    EXPECT_NEAR(enclosed_volume(surface), 1.0 / 3, 1e-15);
    EXPECT_EQ(std::ranges::count(solid.boundary_tets, kNoTet), 2);
  }
}

TEST(TetSolid, LeavesOutTetsThatNameAVertexTwice) {
  TetMesh mesh = corner_tet();
  mesh.tets.push_back({0, 1, 2, 1});
  const TetSolid solid = warned(mesh, "without volume, left out: 1; the first is tet 1 ");
  EXPECT_EQ(solid.boundary.size(), 4u);
}

TEST(TetSolid, LeavesOutRepeatedTets) {
  TetMesh mesh = tidy_box({{1, 1, 2}});
  mesh.tets.push_back({mesh.tets[3][1], mesh.tets[3][2], mesh.tets[3][0], mesh.tets[3][3]});
  mesh.tets.push_back(mesh.tets[3]);
  const TetSolid solid = warned(mesh, "earlier one, left out: 2; the first is tet 12 ");
  EXPECT_EQ(solid.left_out_tets, 2u);
  EXPECT_NEAR(enclosed_volume(boundary_surface(solid)), 2, 1e-14);
}

TEST(TetSolid, KeepsTheRegionsOfTheTetsThatStay) {
  TetMesh mesh = octahedron_with_a_flat_tet();
  mesh.tets.push_back(mesh.tets[2]);
  mesh.regions = {1, 2, 3, 4, 5, 6};
  std::vector<Warning> warnings;
  EXPECT_EQ(prepare_tets(mesh, warnings).mesh.regions, (std::vector<std::int32_t>{2, 3, 4, 5}));
}

TEST(TetSolid, KeepsTheNumberingOfUnusedVertices) {
  TetMesh mesh = corner_tet();
  mesh.vertices.insert(mesh.vertices.begin() + 1, Vector3{9, 9, 9});
  mesh.tets[0] = {0, 2, 3, 4};
  const TetSolid solid =
      warned(mesh, "vertices of no tet, which keep their numbers: 1; the first is vertex 1 ");
  EXPECT_EQ(solid.unused_vertices, 1u);
  EXPECT_EQ(solid.mesh.vertices.size(), 5u);
  EXPECT_EQ(solid.vertex_components, (std::vector<std::uint32_t>{0, kNoComponent, 0, 0, 0}));
  EXPECT_EQ(boundary_surface(solid).vertices.size(), 4u);
}

/// The corner tet, and its image through the origin but for the vertices in `shared`, which both have.
TetMesh mirrored_pair(const std::vector<std::uint32_t>& shared) {
  TetMesh mesh = corner_tet();
  std::array<std::uint32_t, 4> image{};
  for (std::uint32_t v = 0; v < 4; ++v) {
    image[v] = v;
    if (std::ranges::count(shared, v) > 0) continue;
    image[v] = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(-mesh.vertices[v]);
  }
  mesh.tets.push_back(image);
  return mesh;
}

TEST(TetSolid, CountsComponentsThroughFaces) {
  TetMesh mesh = tidy_box({{1, 1, 1}});
  const TetMesh other = corner_tet();
  for (const Vector3& v : other.vertices) mesh.vertices.push_back(v + Vector3{5, 5, 5});
  mesh.tets.push_back({8, 9, 10, 11});
  const TetSolid solid = solid_of(mesh);
  EXPECT_EQ(solid.components, 2u);
  EXPECT_EQ(solid.tet_components, (std::vector<std::uint32_t>{0, 0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(solid.vertex_components, (std::vector<std::uint32_t>{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1}));
}

TEST(TetSolid, WarnsOfAVertexAtWhichItTouchesItself) {
  std::vector<Warning> warnings;
  const TetSolid solid = prepare_tets(mirrored_pair({0}), warnings);
  EXPECT_EQ(solid.components, 2u);
  EXPECT_EQ(warnings.back().kind, WarningKind::kTouchingVertices);
  EXPECT_EQ(warnings.back().text,
            "vertices where the solid touches itself: 1; the first is vertex 0 (counted from 0) at 0 0 0");
}

TEST(TetSolid, WarnsOfAnEdgeAlongWhichItTouchesItself) {
  std::vector<Warning> warnings;
  const TetSolid solid = prepare_tets(mirrored_pair({0, 2}), warnings);
  EXPECT_EQ(solid.components, 2u);
  EXPECT_EQ(warnings.back().kind, WarningKind::kTouchingEdges);
  EXPECT_NE(warnings.back().text.find("two boundary faces): 1; the first joins vertices 0 and 2 "),
            std::string::npos)
      << warnings.back().text;
}

TEST(TetSolid, WarnsOfTetsOnTheSameSideOfTheirFace) {
  TetMesh mesh = corner_tet();
  mesh.vertices.push_back({0.1, 0.1, 2});
  mesh.tets.push_back({0, 1, 2, 4});
  warned(mesh, "overlaps itself: 1; the first is a face of tet 0 ");
}

TEST(TetSolid, RefusesAFaceOfThreeTets) {
  TetMesh mesh = corner_tet();
  mesh.vertices.push_back({0.1, 0.1, 2});
  mesh.vertices.push_back({0.1, 0.1, -2});
  mesh.tets.push_back({0, 1, 2, 4});
  mesh.tets.push_back({0, 2, 1, 5});
  expect_error(mesh,
               "face of vertices 0, 1 and 2 (counted from 0): belongs to 3 tets, among them 0, 1 and 2, ");
}

TEST(TetSolid, RefusesCoordinatesThatAreNoNumbers) {
  for (const double bad : {std::nan(""), double{INFINITY}, -double{INFINITY}, 1e101}) {
    TetMesh mesh = tidy_box({{1, 1, 1}});
    mesh.vertices[6][1] = bad;
    expect_error(mesh, "vertex 6 ");
  }
}

TEST(TetSolid, RefusesAnIndexOutOfRange) {
  TetMesh mesh = corner_tet();
  mesh.tets.push_back({0, 1, 2, 4});
  expect_error(mesh, "tet 1 (counted from 0): vertex index 4 is out of range");
}

TEST(TetSolid, RefusesAMeshWithoutTetsOrVolume) {
  expect_error({}, "no tets");
  expect_error({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2, 3}, {1, 1, 2, 3}}},
               "none of the 2 tets has volume");
}

TEST(TetSolid, RefusesAMeshWithoutABoundary) {
  // All five tets of five vertices: the boundary of a simplex in four dimensions, folded into three.
  TetMesh mesh = corner_tet();
  mesh.vertices.push_back({0.2, 0.2, 0.2});
  mesh.tets = {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}};
  expect_error(mesh, "no boundary");
}

TEST(TetSolid, FindsSmallAndLargeTetsAlike) {
  for (const double scale : {1e-90, 1e-3, 1e90}) {
    TetMesh mesh = tidy_box({{2, 2, 2}});
    for (Vector3& v : mesh.vertices) v = scale * v;
    EXPECT_EQ(solid_of(mesh).mesh.tets, mesh.tets) << scale;
  }
}

TEST(TetSolid, IsTheSameForAnyNumberOfThreads) {
  const TetMesh mesh = TetBox{{9, 8, 7}}.mesh(0.2);
  const auto with = [&](int threads) {
    const ThreadLimit limit(threads);
    return solid_of(mesh);
  };
  const TetSolid one = with(1), four = with(4);
  EXPECT_EQ(one.mesh.tets, four.mesh.tets);
  EXPECT_EQ(one.boundary, four.boundary);
  EXPECT_TRUE(std::ranges::equal(one.inner_faces, four.inner_faces, {}, &TetSolid::InnerFace::tets,
                                 &TetSolid::InnerFace::tets));
}

TEST(TetSolid, WarnsOfTetsThatLieFaceToFaceWithoutSharingVertices) {
  TetMesh mesh = TetBox{{2, 1, 1}}.mesh();
  const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
  const std::vector<Vector3> vertices = mesh.vertices;
  mesh.vertices.insert(mesh.vertices.end(), vertices.begin(), vertices.end());
  for (std::size_t t = 6; t < 12; ++t)
    for (std::uint32_t& v : mesh.tets[t]) v += count;
  std::vector<Warning> warnings;
  EXPECT_EQ(prepare_tets(mesh, warnings).components, 2u);
  const auto found = std::find_if(warnings.begin(), warnings.end(), [](const Warning& warning) {
    return warning.kind == WarningKind::kUnmergedVertices && warning.remedy == Remedy::kMergeVertices &&
           warning.text.starts_with(
               "pairs of tets that lie face to face without sharing vertices: 2; the first has ");
  });
  EXPECT_NE(found, warnings.end());
}

TEST(TetSolid, RefusesTagsOfVerticesThatAreNot) {
  TetMesh mesh = corner_tet();
  mesh.feature_edges = {{{0, 4}, 1}};
  std::vector<Warning> warnings;
  EXPECT_THROW(prepare_tets(mesh, warnings), Error);
  mesh.feature_edges.clear();
  mesh.feature_faces = {{{0, 1, 4}, 1}};
  EXPECT_THROW(prepare_tets(mesh, warnings), Error);
}

}  // namespace
}  // namespace crossgrain
