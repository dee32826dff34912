// SPDX-License-Identifier: Apache-2.0
#include "fit/embedding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "base/disjoint_sets.hpp"
#include "base/quaternion.hpp"
#include "base/vector3.hpp"
#include "fit/hex_lattice.hpp"
#include "fit/lattice_features.hpp"
#include "support/extrusion.hpp"

namespace crossgrain {
namespace {

using testing::features_of;
using testing::lattice_mesh;
using Edge = std::array<std::uint32_t, 2>;

constexpr std::uint32_t kNone = Embedding::kNone;

Edge edge_of(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

/// Vertices - edges + polygons of a set of polygons, with all that is on their borders.
template <class Polygons>
int closed_euler(const Polygons& polygons) {
  std::set<std::uint32_t> vertices;
  std::set<Edge> edges;
  int count = 0;
  for (const auto& polygon : polygons) {
    ++count;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      vertices.insert(polygon[k]);
      edges.insert(edge_of(polygon[k], polygon[(k + 1) % polygon.size()]));
    }
  }
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) + count;
}

/// Checks that paths are disjoint and connected, that quads have faces, that these meet along paths only and
/// as in the model, and that each group of faces is connected and of the model's Euler number.
void expect_topology(const HexMesh& mesh, const FeatureComplex& features, const Embedding& embedding) {
  const QuadComplex surface = surface_of(mesh, features);
  std::set<std::uint32_t> taken;
  std::map<Edge, std::pair<std::uint32_t, bool>> curve_of;  // with whether it runs upwards
  for (const std::uint32_t vertex : embedding.vertex_of_corner) EXPECT_TRUE(taken.insert(vertex).second);
  for (std::uint32_t c = 0; c < features.curves.size(); ++c) {
    const auto& path = embedding.path_of_curve[c];
    ASSERT_GE(path.size(), 2u);
    const auto& corners = features.curves[c].corners;
    if (corners[0] != kNone) {
      EXPECT_EQ(path.front(), embedding.vertex_of_corner[corners[0]]);
      EXPECT_EQ(path.back(), embedding.vertex_of_corner[corners[1]]);
    } else {
      EXPECT_EQ(path.front(), path.back());
      EXPECT_TRUE(taken.insert(path.front()).second);
    }
    for (std::size_t k = 1; k + 1 < path.size(); ++k) EXPECT_TRUE(taken.insert(path[k]).second);
    for (std::size_t k = 1; k < path.size(); ++k) {
      EXPECT_TRUE(
          curve_of.emplace(edge_of(path[k - 1], path[k]), std::pair(c, path[k - 1] < path[k])).second);
      ASSERT_NE(surface.edge_between(path[k - 1], path[k]), kNone);
    }
  }
  std::vector<std::uint32_t> group_of_quad;
  for (const std::uint32_t face : embedding.face_of_quad) {
    ASSERT_NE(face, kNone);
    group_of_quad.push_back(embedding.group_of_face[face]);
  }
  DisjointSets connected(surface.quads().size());
  for (std::uint32_t e = 0; e < surface.edges().size(); ++e) {
    const auto uses = surface.uses_of_edge(e);
    const auto on_path = curve_of.find(surface.edges()[e]);
    if (on_path == curve_of.end()) {
      ASSERT_EQ(uses.size(), 2u);
      EXPECT_EQ(group_of_quad[uses[0].quad], group_of_quad[uses[1].quad]);
      connected.join(uses[0].quad, uses[1].quad);
      continue;
    }
    std::multiset<std::pair<std::uint32_t, bool>> sides, wanted;
    const auto [curve, is_upwards] = on_path->second;
    for (const auto& use : uses) sides.emplace(group_of_quad[use.quad], use.is_left == is_upwards);
    for (const auto& side : features.curves[curve].sides)
      wanted.emplace(embedding.group_of_face[side.face], side.is_left);
    EXPECT_EQ(sides, wanted);
  }
  std::map<std::uint32_t, std::vector<std::array<std::uint32_t, 4>>> quads;
  std::map<std::uint32_t, std::vector<std::array<std::uint32_t, 3>>> triangles;
  std::map<std::uint32_t, std::set<std::uint32_t>> pieces;
  for (std::uint32_t q = 0; q < surface.quads().size(); ++q) {
    quads[group_of_quad[q]].push_back(surface.quads()[q].vertices);
    pieces[group_of_quad[q]].insert(connected.root(q));
  }
  for (std::size_t t = 0; t < features.triangles.size(); ++t)
    triangles[embedding.group_of_face[features.face_of[t]]].push_back(features.triangles[t]);
  ASSERT_EQ(quads.size(), triangles.size());
  for (const auto& [group, of_group] : triangles) {
    EXPECT_EQ(pieces[group].size(), 1u);
    EXPECT_EQ(closed_euler(quads[group]), closed_euler(of_group));
  }
}

void expect_embedded(HexMesh mesh, FeatureComplex features, double size = 1) {
  const std::size_t before = mesh.hexahedra.size();
  const Embedding embedding = embedded(mesh, features, size);
  for (const Embedding::Fault& fault : embedding.faults)
    ADD_FAILURE() << "fault " << int(fault.kind) << " of " << fault.index << " at " << fault.place[0] << " "
                  << fault.place[1] << " " << fault.place[2];
  if (embedding.faults.empty()) expect_topology(mesh, features, embedding);
  EXPECT_EQ(mesh.hexahedra.size(), before);
}

HexMesh l_shape(int scale) {
  return lattice_mesh({3 * scale, 3 * scale, 2 * scale},
                      [=](int x, int y, int) { return x < scale || y < scale ? 1 : 0; });
}

HexMesh scaled(HexMesh mesh, double factor) {
  for (Vector3& vertex : mesh.vertices) vertex = factor * vertex;
  return mesh;
}

/// Each vertex by up to `reach` along each axis.
HexMesh shaken(HexMesh mesh, double reach, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> off(-reach, reach);
  for (Vector3& vertex : mesh.vertices)
    for (double& x : vertex) x += off(random);
  return mesh;
}

TEST(Embedding, OfASurfaceIntoItselfTakesItsOwnVertices) {
  const HexMesh mesh = l_shape(2);
  FeatureComplex features = features_of(mesh, [](std::uint32_t) { return 0; });
  HexMesh same = mesh;
  const Embedding embedding = embedded(same, features, 1);
  ASSERT_EQ(features.corners.size(), 12u);
  for (std::size_t c = 0; c < features.corners.size(); ++c)
    EXPECT_EQ(embedding.vertex_of_corner[c], features.corners[c].vertex);
  for (std::size_t c = 0; c < features.curves.size(); ++c)
    EXPECT_EQ(embedding.path_of_curve[c], features.curves[c].vertices);
  expect_embedded(mesh, features);
}

TEST(Embedding, FindsFeaturesOfAMeshThatIsCoarserFinerAndDisturbed) {
  const FeatureComplex features = features_of(scaled(l_shape(3), 1. / 3), [](std::uint32_t) { return 0; });
  for (const int scale : {1, 2, 5})
    expect_embedded(shaken(scaled(l_shape(scale), 1. / scale), 0.25 / scale, 4), features, 1. / scale);
}

TEST(Embedding, PutsRoundRimsOntoTheStepsOfALattice) {
  const TriangleMesh plate =
      extrude({{0, 0}, {12, 0}, {12, 12}, {0, 12}}, {round_hole({6, 6}, 3.3, 48)}, 0, {3});
  const FeatureComplex features = feature_complex(prepare_surface(CheckedMesh(plate)));
  EXPECT_EQ(std::ranges::count_if(features.curves, [](const auto& curve) { return curve.is_closed(); }), 2);
  expect_embedded(lattice_mesh({12, 12, 3},
                               [](int x, int y, int) {
                                 return (x - 5.5) * (x - 5.5) + (y - 5.5) * (y - 5.5) < 3.3 * 3.3 ? 0 : 1;
                               }),
                  features);
}

TEST(Embedding, GoesAroundHolesOfOneCell) {
  const TriangleMesh plate =
      extrude({{0, 0}, {7, 0}, {7, 5}, {0, 5}},
              {round_hole({2.45, 2.5}, 0.4, 24), round_hole({4.65, 2.5}, 0.3, 24)}, 0, {2});
  const FeatureComplex features = feature_complex(prepare_surface(CheckedMesh(plate)));
  expect_embedded(
      shaken(lattice_mesh({7, 5, 2}, [](int x, int y, int) { return y == 2 && (x == 2 || x == 4) ? 0 : 1; }),
             0.15, 3),
      features);
}

TEST(Embedding, EndsADanglingCurveInAVertex) {
  const HexMesh mesh = lattice_mesh({6, 6, 6}, [](int, int, int) { return 1; });
  // A box whose top a crease enters from one side, ending in the middle: as a curve of the file.
  FeatureComplex features = features_of(mesh, [](std::uint32_t) { return 0; });
  ASSERT_EQ(features.corners.size(), 8u);
  const QuadComplex quads(mesh);
  TriangleMesh surface;
  surface.vertices = mesh.vertices;
  for (const QuadComplex::Quad& quad : quads.quads()) {
    const auto& [a, b, c, d] = quad.vertices;
    surface.triangles.push_back({a, b, c});
    surface.triangles.push_back({a, c, d});
  }
  CreaseCurve crease;
  for (int x = 0; x <= 3; ++x) {
    crease.points.push_back({double(x), 3, 6});
    crease.tangents.push_back({1, 0, 0});
  }
  for (const FeatureComplex::Curve& curve : features.curves) {
    CreaseCurve edge;
    for (const std::uint32_t v : curve.vertices) edge.points.push_back(features.vertices[v]);
    edge.tangents.assign(edge.points.size(), normalised(edge.points.back() - edge.points.front()));
    surface.creases.push_back(edge);
  }
  surface.creases.push_back(crease);
  features = feature_complex(prepare_surface(CheckedMesh(std::move(surface))));
  for (FeatureComplex::Curve& curve : features.curves) curve.is_soft = false;
  const auto dangling =
      std::ranges::find_if(features.corners, [](const auto& c) { return c.ends.size() == 1; });
  ASSERT_NE(dangling, features.corners.end());
  const auto end = static_cast<std::size_t>(dangling - features.corners.begin());
  HexMesh disturbed = shaken(mesh, 0.2, 9);
  const Embedding embedding = embedded(disturbed, features, 1);
  EXPECT_TRUE(embedding.faults.empty());
  EXPECT_EQ(embedding.path_of_curve[features.corners[end].ends[0].curve].size(), 4u);
  expect_topology(disturbed, features, embedding);
}

/// Cubes of a block whose surface is closed and has no pinched vertex, some of them left out at random.
HexMesh random_cubes(std::mt19937& random) {
  for (;;) {
    HexMesh mesh = lattice_mesh({4, 4, 3}, [&](int, int, int) { return random() % 12 > 0 ? 1 : 0; });
    const QuadComplex surface(mesh);
    bool is_manifold = true;
    for (std::uint32_t e = 0; e < surface.edges().size(); ++e)
      is_manifold = is_manifold && surface.uses_of_edge(e).size() == 2;
    for (const std::uint32_t v : surface.vertices()) {
      std::uint32_t last = 0;
      const auto fan = surface.around(
          v, surface.quads_of(v)[0], [](std::uint32_t) { return false; }, last);
      is_manifold = is_manifold && fan.size() == surface.quads_of(v).size();
    }
    if (is_manifold || random() % 50 == 0) return mesh;
  }
}

TEST(Embedding, WithoutFaultsHasTheTopologyOfRandomFeatures) {
  std::mt19937 random(21);
  int right = 0;
  constexpr int kTrials = 12;
  for (int trial = 0; trial < kTrials; ++trial) {
    const HexMesh mesh = random_cubes(random);
    std::map<std::uint32_t, int> numbers;
    const int kinds = 1 + static_cast<int>(random() % 3);
    const bool are_sharp = trial % 2 == 0;
    FeatureComplex features = features_of(
        mesh, [&](std::uint32_t q) { return numbers.try_emplace(q, int(random()) % kinds).first->second; },
        are_sharp);
    HexMesh other = shaken(mesh, trial % 3 == 0 ? 0.3 : 0.05, static_cast<unsigned>(trial));
    const Embedding embedding = embedded(other, features, 1);
    if (!embedding.faults.empty()) continue;
    ++right;
    expect_topology(other, features, embedding);
  }
  EXPECT_GE(right, kTrials / 2);
}

TEST(Embedding, TurnsWithTheModel) {
  const Quaternion turn = normalised(Quaternion{0.7, 0.3, -0.5, 0.2});
  HexMesh mesh = shaken(scaled(l_shape(4), 0.25), 0.05, 2);
  FeatureComplex features = features_of(l_shape(1), [](std::uint32_t) { return 0; });
  const Embedding upright = embedded(mesh, features, 0.25);
  for (Vector3& vertex : mesh.vertices) vertex = rotate(turn, vertex);
  for (Vector3& vertex : features.vertices) vertex = rotate(turn, vertex);
  for (auto& corner : features.corners) corner.point = rotate(turn, corner.point);
  const Embedding turned = embedded(mesh, features, 0.25);
  EXPECT_EQ(turned.vertex_of_corner, upright.vertex_of_corner);
  EXPECT_EQ(turned.path_of_curve, upright.path_of_curve);
  EXPECT_EQ(turned.face_of_quad, upright.face_of_quad);
}

TEST(Embedding, DropsSoftCurvesForWhichThereIsNoPath) {
  // Borders of faces two and a half cells of the mesh apart, and one between its lines.
  const HexMesh model = scaled(lattice_mesh({16, 8, 8}, [](int, int, int) { return 1; }), 0.5);
  const QuadComplex quads(model);
  const auto strip = [&](std::uint32_t q) {
    double x = 0;
    for (const std::uint32_t v : quads.quads()[q].vertices) x += 0.25 * model.vertices[v][0];
    return x < 2 ? 0 : x < 4.5 ? 1 : 2;
  };
  FeatureComplex features = features_of(model, strip);
  HexMesh mesh = lattice_mesh({8, 4, 4}, [](int, int, int) { return 1; });
  const Embedding embedding = embedded(mesh, features, 1);
  EXPECT_TRUE(embedding.faults.empty());
  expect_topology(mesh, features, embedding);
  EXPECT_EQ(std::ranges::count_if(features.curves, [](const auto& curve) { return curve.is_soft; }), 4);
}

TEST(Embedding, MakesRoomForCurvesBetweenTwoLinesOfTheMesh) {
  // Two creases across the top, of which the mesh has one line.
  const HexMesh model = scaled(lattice_mesh({8, 12, 4}, [](int, int, int) { return 1; }), 0.5);
  const QuadComplex quads(model);
  const auto strip = [&](std::uint32_t q) {
    Vector3 centre{};
    for (const std::uint32_t v : quads.quads()[q].vertices) centre += 0.25 * model.vertices[v];
    return centre[2] < 1.9 ? 0 : centre[1] < 2.5 ? 0 : centre[1] < 3.5 ? 1 : 2;
  };
  FeatureComplex features = features_of(model, strip, true);
  HexMesh mesh = lattice_mesh({4, 2, 2}, [](int, int, int) { return 1; });
  for (Vector3& vertex : mesh.vertices) vertex[1] *= 3;
  const Embedding embedding = embedded(mesh, features, 1);
  EXPECT_TRUE(embedding.faults.empty());
  EXPECT_GT(mesh.hexahedra.size(), 16u);
  if (embedding.faults.empty()) expect_topology(mesh, features, embedding);
}

TEST(Embedding, TellsOfACurveWithoutAPath) {
  HexMesh mesh = lattice_mesh({1, 1, 1}, [](int, int, int) { return 1; });
  FeatureComplex features = features_of(
      scaled(lattice_mesh({3, 3, 3}, [](int, int, int) { return 1; }), 1. / 3),
      [](std::uint32_t q) { return static_cast<int>(q); }, true);
  const Embedding embedding = embedded(mesh, features, 1, {.makes_room = false});
  EXPECT_GT(std::ranges::count(embedding.faults, Embedding::FaultKind::kCorner, &Embedding::Fault::kind), 0);
  EXPECT_GT(std::ranges::count(embedding.faults, Embedding::FaultKind::kCurve, &Embedding::Fault::kind), 0);
}

}  // namespace
}  // namespace crossgrain
