// SPDX-License-Identifier: Apache-2.0
#include "tets/map_preparation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/ascending.hpp"
#include "tets/boundary_vertices.hpp"
#include "tets/inner_walls.hpp"
#include "tets/tet_meshes.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

using Edge = std::array<std::uint32_t, 2>;
using Triangle = std::array<std::uint32_t, 3>;

constexpr TetBox kBox{{3, 2, 2}};
constexpr MapPreparationTuning kNoLayer{{}, true, /*layer_spread_deg=*/180};

TetSolid prepared_solid(const TetMesh& mesh, const MapPreparationTuning& options = {}) {
  return solid_of(prepared_for_map(solid_of(mesh), options).split.mesh);
}

/// What frames follow, as sets of vertices.
struct Held {
  std::set<std::uint32_t> vertices;
  std::set<Edge> edges;
  std::set<Triangle> faces;

  explicit Held(const TetSolid& solid, bool unite = false) {
    std::vector<Warning> warnings;
    const std::vector<InnerWall> walls = find_inner_walls(solid, warnings);
    for (const Triangle& face : solid.boundary) add(face);
    for (const Triangle& face : features_of(solid, walls, unite).faces) add(face);
    for (const Edge& edge : features_of(solid, walls, unite).edges) add_edge(edge);
  }

  void add(const Triangle& face) {
    faces.insert(ascending(face));
    for (std::size_t k = 0; k < 3; ++k) add_edge({face[k], face[(k + 1) % 3]});
  }
  void add_edge(const Edge& edge) {
    edges.insert(ascending(edge));
    vertices.insert(edge.begin(), edge.end());
  }

  bool has(std::uint32_t v) const { return vertices.count(v) > 0; }
};

/// Number of edges, faces and tets that have all their vertices in what is held and are no part of it.
std::size_t faults_of(const TetSolid& solid, bool unite = false) {
  const Held held(solid, unite);
  std::set<Edge> edges;
  std::set<Triangle> faces;
  std::size_t tets = 0;
  for (const auto& tet : solid.mesh.tets) {
    std::size_t on = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      on += held.has(tet[i]);
      const Triangle face{tet[kFaceCorners[i][0]], tet[kFaceCorners[i][1]], tet[kFaceCorners[i][2]]};
      if (held.has(face[0]) && held.has(face[1]) && held.has(face[2]) && !held.faces.count(ascending(face)))
        faces.insert(ascending(face));
      for (std::size_t j = i + 1; j < 4; ++j) {
        const Edge edge = ascending(Edge{tet[i], tet[j]});
        if (held.has(edge[0]) && held.has(edge[1]) && !held.edges.count(edge)) edges.insert(edge);
      }
    }
    tets += on == 4;
  }
  return edges.size() + faces.size() + tets;
}

std::size_t most_boundary_faces(const TetSolid& solid) {
  std::vector<std::size_t> faces(solid.mesh.tets.size(), 0);
  for (const std::uint32_t tet : solid.boundary_tets) ++faces[tet];
  return *std::ranges::max_element(faces);
}

TetMesh with_inner_features() {
  TetMesh mesh = TetBox{{4, 3, 3}}.mesh(0.2);
  const TetBox box{{4, 3, 3}};
  const auto at = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) { return box.at(x, y, z); };
  mesh.feature_faces = {{{at(1, 1, 1), at(2, 1, 1), at(2, 2, 1)}, 1},
                        {{at(1, 1, 1), at(1, 2, 1), at(2, 2, 1)}, 1}};
  mesh.feature_edges = {{{at(2, 2, 2), at(3, 2, 2)}, 2}, {{at(3, 2, 2), at(4, 2, 2)}, 2}};
  return mesh;
}

TEST(MapPreparation, LeavesNoEdgeFaceOrTetBesidesTheSurfaceWithAllVerticesOnIt) {
  const auto half = [](const Vector3& p) { return p[0] < 2 ? 1 : 2; };
  for (const TetMesh& mesh : {TetBox{{1, 1, 1}}.mesh(), kBox.mesh(0.2), tet_cylinder(2), tet_cylinder(6),
                              with_regions(kBox.mesh(0.2), half), with_inner_features(), corner_tet()}) {
    EXPECT_GT(faults_of(solid_of(mesh)), 0u);
    const TetSolid prepared = prepared_solid(mesh);
    EXPECT_EQ(faults_of(prepared), 0u);
    EXPECT_EQ(most_boundary_faces(prepared), 1u);
    EXPECT_NEAR(volume_of_tets(prepared.mesh), volume_of_tets(solid_of(mesh).mesh), 1e-12);
  }
}

TEST(MapPreparation, MakesASplitForEachFaultAndNoOther) {
  for (const TetMesh& mesh : {TetBox{{1, 1, 1}}.mesh(), kBox.mesh(0.2), with_inner_features()}) {
    const TetSolid solid = solid_of(mesh);
    const PreparedTets prepared = prepared_for_map(solid, kNoLayer);
    const MapPreparation& counts = prepared.counts;
    EXPECT_EQ(counts.split_edges + counts.split_faces + counts.split_tets,
              prepared.split.new_vertices.size());
    EXPECT_LE(prepared.split.new_vertices.size(), faults_of(solid));
    EXPECT_EQ(counts.tets_before, solid.mesh.tets.size());
    EXPECT_EQ(counts.vertices_before, solid.mesh.vertices.size());
    EXPECT_EQ(counts.refused_splits, 0u);
  }
}

TEST(MapPreparation, LeavesTheSurfaceAsItIsWhereNothingCutsOffACrease) {
  const TetSolid before = solid_of(with_inner_features()), after = prepared_solid(with_inner_features());
  EXPECT_EQ(after.boundary, before.boundary);
  EXPECT_GT(after.mesh.tets.size(), before.mesh.tets.size());
}

TEST(MapPreparation, SplitsALoneTetAtItsCentroid) {
  const PreparedTets prepared = prepared_for_map(solid_of(corner_tet()), {});
  EXPECT_EQ(prepared.counts.split_tets, 1u);
  EXPECT_EQ(prepared.split.mesh.tets.size(), 4u);
  EXPECT_EQ(prepared.split.new_vertices.size(), 1u);
}

TEST(MapPreparation, SplitsATetOfThreeBoundaryFacesInTheFourth) {
  // Two tets with a common face.
  const TetMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, {{0, 1, 2, 3}, {1, 3, 2, 4}}};
  const PreparedTets prepared = prepared_for_map(solid_of(mesh), {});
  EXPECT_EQ(prepared.counts.split_faces, 1u);
  EXPECT_EQ(prepared.counts.split_edges + prepared.counts.split_tets, 0u);
  EXPECT_EQ(prepared.split.mesh.tets.size(), 6u);
}

TEST(MapPreparation, SplitsLongEdgesFirst) {
  const PreparedTets prepared = prepared_for_map(solid_of(kBox.mesh(0.2)), kNoLayer);
  double last = INFINITY;
  for (const MeanOfVertices& mean : prepared.split.new_vertices) {
    if (mean.count != 2) break;
    const auto& v = prepared.split.mesh.vertices;
    const double length = norm(v[mean.vertices[0]] - v[mean.vertices[1]]);
    EXPECT_LE(length, last + 1e-15);
    last = length;
  }
  EXPECT_LT(last, 2);
}

TEST(MapPreparation, LeavesNoFaceThatCutsOffACrease) {
  // At two corners of the square that becomes a circle, a face of the cap has two edges of the rim.
  const TetMesh mesh = tet_cylinder(4);
  const auto cut_off = [](const TetSolid& solid) {
    const std::vector<Edge> creases = crease_edges(solid);
    const auto is_crease = [&](std::uint32_t a, std::uint32_t b) {
      return std::ranges::binary_search(creases, ascending(Edge{a, b}));
    };
    return std::ranges::count_if(solid.boundary, [&](const Triangle& f) {
      return is_crease(f[0], f[1]) + is_crease(f[1], f[2]) + is_crease(f[2], f[0]) >= 2;
    });
  };
  EXPECT_EQ(cut_off(solid_of(mesh)), 4);
  EXPECT_EQ(cut_off(prepared_solid(mesh)), 0);
  EXPECT_EQ(cut_off(prepared_solid(mesh, {{}, /*cut_off_creases=*/false})), 4);
}

TEST(MapPreparation, KeepsFacesInTheCornersOfABox) {
  EXPECT_EQ(prepared_solid(TetBox{{1, 1, 1}}.mesh()).boundary.size(), 12u);
}

/// Pairs of a smooth vertex of the surface and one inside, both given, with an edge between them.
std::size_t edges_under(const TetSolid& prepared, const TetMesh& given, bool on_flat_faces) {
  const BoundaryVertices boundary = classify_boundary_vertices(solid_of(given));
  std::set<std::uint32_t> wanted, on_boundary(boundary.vertices.begin(), boundary.vertices.end());
  for (std::size_t k = 0; k < boundary.size(); ++k)
    if (boundary.classes[k] == BoundaryClass::kSmooth && (boundary.spread_deg[k] < 1e-3) == on_flat_faces)
      wanted.insert(boundary.vertices[k]);
  std::set<Edge> edges;
  for (const auto& tet : prepared.mesh.tets) {
    for (const std::uint32_t a : tet)
      for (const std::uint32_t b : tet)
        if (wanted.count(a) && b < given.vertices.size() && !on_boundary.count(b)) edges.insert({a, b});
  }
  return edges.size();
}

TEST(MapPreparation, SplitsTheLayerUnderCurvedFacesOnly) {
  const TetMesh mesh = tet_cylinder(12);
  EXPECT_GT(edges_under(solid_of(mesh), mesh, /*on_flat_faces=*/false), 0u);
  EXPECT_EQ(edges_under(prepared_solid(mesh), mesh, /*on_flat_faces=*/false), 0u);
  EXPECT_GT(edges_under(prepared_solid(mesh), mesh, /*on_flat_faces=*/true), 0u);
  EXPECT_EQ(
      edges_under(prepared_solid(mesh, {{}, true, /*layer_spread_deg=*/0}), mesh, /*on_flat_faces=*/true),
      0u);
  EXPECT_GT(edges_under(prepared_solid(mesh, kNoLayer), mesh, /*on_flat_faces=*/false), 0u);
}

TEST(MapPreparation, CanIgnoreFacesBetweenRegions) {
  const auto half = [](const Vector3& p) { return p[0] < 2 ? 1 : 2; };
  const TetSolid plain = prepared_solid(kBox.mesh(0.2));
  const TetSolid united = prepared_solid(with_regions(kBox.mesh(0.2), half), {{.unite_solids = true}});
  EXPECT_EQ(united.mesh.tets, plain.mesh.tets);
  EXPECT_EQ(faults_of(united, /*unite=*/true), 0u);
  EXPECT_GT(faults_of(united, /*unite=*/false), 0u);
}

TEST(MapPreparation, SplitsFlatTetsToo) {
  // Two pairs of tets with a flat tet between them.
  const TetMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}, {0.5, 0.5, -1}},
                     {{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 1, 2, 3}, {1, 0, 3, 5}, {2, 1, 3, 5}},
                     {1, 1, 1, 1, 1}};
  const TetSolid before = solid_of(mesh);
  const PreparedTets prepared = prepared_for_map(before, {});
  std::vector<Warning> warnings;
  const TetSolid after = prepare_tets(prepared.split.mesh, warnings);
  EXPECT_EQ(after.boundary, before.boundary);
  EXPECT_EQ(after.components, 1u);
  EXPECT_EQ(std::size_t(std::ranges::count(prepared.split.parents, kNoTet)), after.left_out_tets);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].kind, WarningKind::kFlatTets);
}

TEST(MapPreparation, CountsTheSplitsThatWouldLeaveATetFlat) {
  // Halves of the tet in the middle are flat, but not the whole.
  const double thick = 2 * kFlatness;
  const TetMesh mesh{{{0, 0, 0}, {1, 0, thick}, {1, 1, 0}, {0, 1, thick}, {0.5, 0.5, 1}, {0.5, 0.5, -1}},
                     {{1, 2, 3, 4}, {0, 1, 3, 4}, {0, 2, 1, 3}, {0, 2, 1, 5}, {0, 3, 2, 5}}};
  const PreparedTets prepared = prepared_for_map(solid_of(mesh), {});
  EXPECT_GT(prepared.counts.refused_splits, 0u);
  EXPECT_EQ(solid_of(prepared.split.mesh).left_out_tets, 0u);
}

}  // namespace
}  // namespace crossgrain
