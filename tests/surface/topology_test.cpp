// SPDX-License-Identifier: Apache-2.0
#include "surface/topology.hpp"

#include <gtest/gtest.h>

#include "support/shapes.hpp"

namespace crossgrain {
namespace {

TEST(Weld, OfASoupGivesBackTheMeshItCameFrom) {
  const TriangleMesh mesh = make_torus(0.6, 0.25, 12, 8);
  const TriangleMesh welded = weld(to_soup(mesh));
  EXPECT_EQ(welded.vertices.size(), mesh.vertices.size());
  ASSERT_EQ(welded.triangles.size(), mesh.triangles.size());
  EXPECT_EQ(to_soup(welded).vertices, to_soup(mesh).vertices);
}

TEST(Weld, TakesZeroAndMinusZeroForEqual) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, -0.0}, {0, 0, 1}},
                          {{0, 1, 2}, {3, 2, 4}}};
  EXPECT_EQ(weld(mesh).vertices.size(), 4u);
}

TEST(Weld, KeepsVerticesApartThatDifferInTheLastBit) {
  const double next = std::nextafter(1.0, 2.0);
  const TriangleMesh mesh{{{1, 0, 0}, {next, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(weld(mesh).vertices, mesh.vertices);
}

TEST(Weld, DropsVerticesThatNoTriangleUsesAndKeepsTheOrderOfTheOthers) {
  const TriangleMesh mesh{{{9, 9, 9}, {3, 0, 0}, {8, 8, 8}, {2, 0, 0}, {1, 1, 0}}, {{4, 3, 1}}};
  const TriangleMesh welded = weld(mesh);
  EXPECT_EQ(welded.vertices, (std::vector<Vector3>{{3, 0, 0}, {2, 0, 0}, {1, 1, 0}}));
  EXPECT_EQ(welded.triangles[0], (std::array<std::uint32_t, 3>{2, 1, 0}));
}

TEST(Weld, KeepsATriangleWhoseCornersFallTogether) {
  const TriangleMesh mesh{{{0, 0, 0}, {0, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(weld(mesh).triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 0, 1}}));
}

TEST(Weld, KeepsWhatAFileKnowsOfTriangles) {
  TriangleMesh mesh = to_soup(make_box({1, 1, 1}));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto number = static_cast<std::int32_t>(t);
    mesh.faces.push_back(number);
    mesh.solids.push_back(-number);
    mesh.corner_normals.push_back({Vector3{1, 0, 0}, {0, 1, 0}, {0, 0, 1.0 * number}});
  }
  mesh.creases = {{{{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}, 7}};
  mesh.unit = "mm";
  mesh.file_unit = "inch";
  mesh.warnings = {{WarningKind::kMissingFaces, "a face is missing"}};
  const TriangleMesh welded = weld(mesh);
  EXPECT_EQ(welded.faces, mesh.faces);
  EXPECT_EQ(welded.solids, mesh.solids);
  EXPECT_EQ(welded.corner_normals, mesh.corner_normals);
  ASSERT_EQ(welded.creases.size(), 1u);
  EXPECT_EQ(welded.creases[0].points, mesh.creases[0].points);
  EXPECT_EQ(welded.creases[0].tag, 7);
  EXPECT_EQ(welded.unit, "mm");
  EXPECT_EQ(welded.file_unit, "inch");
  EXPECT_EQ(welded.warnings, mesh.warnings);
}

TEST(Topology, OfATetrahedronIsWatertight) {
  const SurfaceTopology topology = analyse_topology(
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
  EXPECT_TRUE(topology.watertight);
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.degenerate_triangles, 0u);
}

TEST(Topology, OfASurfaceInsideOutIsWatertightToo) {
  EXPECT_TRUE(analyse_topology(flip_mesh(make_box({1, 1, 1}))).watertight);
}

TEST(Topology, CountsTheEdgesOfAHole) {
  TriangleMesh mesh = make_sphere(1, 2);
  mesh.triangles.pop_back();
  const SurfaceTopology topology = analyse_topology(mesh);
  EXPECT_FALSE(topology.watertight);
  EXPECT_EQ(topology.open_edges, 3u);
}

TEST(Topology, CountsTheEdgesOfATurnedTriangle) {
  TriangleMesh mesh = make_sphere(1, 2);
  std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
  const SurfaceTopology topology = analyse_topology(mesh);
  EXPECT_FALSE(topology.watertight);
  EXPECT_EQ(topology.misoriented_edges, 3u);
  EXPECT_EQ(topology.open_edges, 0u);
}

TEST(Topology, OfTwoTetrahedraGluedOnAFaceHasThreeNonManifoldEdges) {
  // Eight triangles, the shared face twice, once each way: every shared edge has four triangles.
  const TriangleMesh mesh{
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 2}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}}};
  const SurfaceTopology topology = analyse_topology(mesh);
  EXPECT_FALSE(topology.watertight);
  EXPECT_EQ(topology.nonmanifold_edges, 3u);
  EXPECT_EQ(topology.open_edges, 0u);
  EXPECT_EQ(topology.components, 1u);
}

TEST(Topology, OfThreeTrianglesOnOneEdgeIsAFan) {
  const TriangleMesh fan{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}},
                         {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
  const SurfaceTopology topology = analyse_topology(fan);
  EXPECT_EQ(topology.nonmanifold_edges, 1u);
  EXPECT_EQ(topology.open_edges, 6u);
  EXPECT_EQ(topology.components, 1u);
}

TEST(Topology, CountsComponents) {
  EXPECT_EQ(analyse_topology(make_plates(0.1)).components, 2u);
  EXPECT_EQ(analyse_topology(make_plates(0.1)).watertight, true);
}

TEST(Topology, TakesSolidsThatShareOnlyAVertexForTwoComponents) {
  const TriangleMesh mesh =
      weld(join_meshes(make_box({1, 1, 1}), translate_mesh(make_box({1, 1, 1}), {1, 1, 1})));
  ASSERT_EQ(mesh.vertices.size(), 15u);
  EXPECT_EQ(analyse_topology(mesh).components, 2u);
}

TEST(Topology, OfASoupIsAllOpenEdges) {
  const TriangleMesh soup = to_soup(make_box({1, 1, 1}));
  EXPECT_EQ(analyse_topology(soup).open_edges, 36u);
  EXPECT_EQ(analyse_topology(soup).components, 12u);
}

TEST(Topology, CollapsedTrianglesDoNotSpoilAClosedSurface) {
  TriangleMesh mesh = make_box({1, 1, 1});
  mesh.triangles.push_back({0, 0, 1});
  const SurfaceTopology topology = analyse_topology(mesh);
  EXPECT_TRUE(topology.watertight);
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.degenerate_triangles, 1u);
}

TEST(Topology, FlatTrianglesCountAsDegenerateAndStillCloseTheSurface) {
  // A vertex in the middle of an edge of a tetrahedron, on one side of it only, with a flat triangle to fill
  // the slit.
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {.5, 0, 0}},
                          {{0, 2, 4}, {4, 2, 1}, {0, 4, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  const SurfaceTopology topology = analyse_topology(mesh);
  EXPECT_TRUE(topology.watertight);
  EXPECT_EQ(topology.degenerate_triangles, 1u);
}

TEST(Topology, OfNothingIsNotWatertight) {
  EXPECT_FALSE(analyse_topology({}).watertight);
}

TEST(Topology, OfPartsThatTouchAlongAnEdgeIsBalanced) {
  const TriangleMesh box = make_box({1, 1, 1});
  TriangleMesh two = weld(join_meshes(box, translate_mesh(box, {1, 1, 0})));
  EXPECT_FALSE(analyse_topology(two).watertight);
  EXPECT_EQ(analyse_topology(two).unbalanced_edges, 0u);
  two.triangles.pop_back();
  EXPECT_EQ(analyse_topology(two).unbalanced_edges, 3u);
}

}  // namespace
}  // namespace crossgrain
