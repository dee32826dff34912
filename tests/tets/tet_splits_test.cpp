// SPDX-License-Identifier: Apache-2.0
#include "tets/tet_splits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include "base/ascending.hpp"
#include "tets/tet_meshes.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

using Tet = std::array<std::uint32_t, 4>;
using Triangle = std::array<std::uint32_t, 3>;
using Edge = std::array<std::uint32_t, 2>;

constexpr TetBox kBox{{3, 2, 2}};

/// All tets positive, two regions, tagged faces inside and outside, tagged edges, repeated and stray tags.
TetMesh tagged_box() {
  TetMesh mesh =
      with_regions(solid_of(kBox.mesh(0.2)).mesh, [](const Vector3& p) { return p[0] < 1 ? 7 : -2; });
  const std::uint32_t a = kBox.at(1, 1, 1), b = kBox.at(2, 1, 1), c = kBox.at(2, 2, 1), d = kBox.at(3, 2, 1);
  mesh.feature_faces = {{{a, b, c}, 4}, {{c, b, d}, 5}, {{a, c, b}, 6}, {{0, 1, kBox.at(3, 2, 2)}, 8}};
  for (std::uint32_t x = 0; x < 3; ++x)
    for (std::uint32_t y = 0; y < 2; ++y)
      for (const auto& [u, v] : {Edge{1, 0}, Edge{0, 1}})
        mesh.feature_faces.push_back(
            {{kBox.at(x, y, 0), kBox.at(x + u, y + v, 0), kBox.at(x + 1, y + 1, 0)}, 9});
  mesh.feature_edges = {{{a, b}, 1}, {{c, b}, 2, false}, {{b, a}, 3}, {{0, kBox.at(3, 2, 2)}, 4}};
  return mesh;
}

/// A tet as its vertices and the sign of their order: equal for orders of the same orientation.
std::pair<Tet, bool> unordered(const Tet& tet) {
  Tet sorted = tet;
  bool even = true;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (sorted[j] < sorted[i]) {
        std::swap(sorted[i], sorted[j]);
        even = !even;
      }
  return {sorted, even};
}

/// The mesh as plain lists in which a split looks at every element.
struct PlainSplits {
  struct Tagged {
    std::vector<std::uint32_t> vertices;
    std::size_t given;
  };

  explicit PlainSplits(const TetMesh& mesh) : points(mesh.vertices) {
    add(
        mesh.tets, [](const Tet& tet) { return tet; }, tets);
    add(
        mesh.feature_faces, [](const TetMesh::Face& face) { return face.vertices; }, faces);
    add(
        mesh.feature_edges, [](const TetMesh::Edge& edge) { return edge.vertices; }, edges);
  }

  void split(const std::vector<std::uint32_t>& around) {
    Vector3 mean{0, 0, 0};
    for (const std::uint32_t v : around) mean += (1.0 / double(around.size())) * points[v];
    const auto centre = std::uint32_t(points.size());
    points.push_back(mean);
    for (std::vector<Tagged>* list : {&tets, &faces, &edges}) split_all(around, centre, *list);
  }

  static void split_all(const std::vector<std::uint32_t>& around, std::uint32_t centre,
                        std::vector<Tagged>& list) {
    std::vector<Tagged> next;
    for (const Tagged& element : list) {
      const auto has = [&](std::uint32_t v) { return std::ranges::count(element.vertices, v) > 0; };
      if (!std::ranges::all_of(around, has)) {
        next.push_back(element);
        continue;
      }
      for (const std::uint32_t v : around) {
        next.push_back(element);
        std::ranges::replace(next.back().vertices, v, centre);
      }
    }
    list = next;
  }

  std::vector<Vector3> points;
  std::vector<Tagged> tets, faces, edges;

 private:
  template <class Element, class VerticesOf>
  static void add(const std::vector<Element>& elements, const VerticesOf& vertices_of,
                  std::vector<Tagged>& list) {
    for (std::size_t k = 0; k < elements.size(); ++k) {
      const auto vertices = vertices_of(elements[k]);
      list.push_back({{vertices.begin(), vertices.end()}, k});
    }
  }
};

/// Splits random edges, faces and tets of the present mesh.
void split_at_random(TetSplits& splits, std::size_t count, unsigned seed, PlainSplits* plain = nullptr) {
  std::mt19937 random(seed);
  for (std::size_t k = 0; k < count; ++k) {
    const auto t = std::uint32_t(random() % splits.tets().size());
    Tet tet = splits.tets()[t];
    std::shuffle(tet.begin(), tet.end(), random);
    const std::size_t corners = 2 + random() % 3;
    const std::optional<std::uint32_t> centre = corners == 2   ? splits.split_edge(tet[0], tet[1])
                                                : corners == 3 ? splits.split_face({tet[0], tet[1], tet[2]})
                                                               : splits.split_tet(t);
    ASSERT_EQ(centre, splits.vertices().size() - 1);
    if (plain) plain->split({tet.begin(), tet.begin() + std::ptrdiff_t(corners)});
  }
}

SplitTetMesh split_box(unsigned seed) {
  TetSplits splits(tagged_box());
  split_at_random(splits, 60, seed);
  return splits.result();
}

double six_volumes(const TetMesh& mesh, const Tet& tet) {
  const auto& v = mesh.vertices;
  return dot(cross(v[tet[1]] - v[tet[0]], v[tet[2]] - v[tet[0]]), v[tet[3]] - v[tet[0]]);
}

/// Whether a point is in a tet, up to rounding.
bool is_in(const TetMesh& mesh, const Tet& tet, const Vector3& point) {
  TetMesh with = mesh;
  with.vertices.push_back(point);
  for (std::size_t corner = 0; corner < 4; ++corner) {
    Tet part = tet;
    part[corner] = std::uint32_t(mesh.vertices.size());
    if (six_volumes(with, part) < -1e-12) return false;
  }
  return true;
}

double area_of(const TetMesh& mesh, const Triangle& face) {
  const auto& v = mesh.vertices;
  return 0.5 * norm(cross(v[face[1]] - v[face[0]], v[face[2]] - v[face[0]]));
}

/// Whether a point is on a triangle: the parts around it have the same area.
bool is_on(const TetMesh& mesh, const Triangle& face, const Vector3& point) {
  TetMesh with = mesh;
  with.vertices.push_back(point);
  double sum = 0;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    Triangle part = face;
    part[corner] = std::uint32_t(mesh.vertices.size());
    sum += area_of(with, part);
  }
  return std::abs(sum - area_of(mesh, face)) < 1e-12;
}

/// How many tets have all these vertices.
template <class Vertices>
std::size_t tets_around(const TetSplits& splits, const Vertices& vertices) {
  const auto has_all = [&](const Tet& tet) {
    return std::all_of(vertices.begin(), vertices.end(),
                       [&](std::uint32_t v) { return std::find(tet.begin(), tet.end(), v) != tet.end(); });
  };
  return static_cast<std::size_t>(std::count_if(splits.tets().begin(), splits.tets().end(), has_all));
}

TEST(TetSplits, ReplaceTheTetsAroundAnEdge) {
  TetSplits splits(solid_of(kBox.mesh()).mesh);
  const Edge edge{kBox.at(1, 1, 1), kBox.at(2, 1, 1)};
  const std::size_t tets = splits.tets().size(), around = tets_around(splits, edge);
  ASSERT_EQ(around, 6u);
  const std::optional<std::uint32_t> middle = splits.split_edge(edge[1], edge[0]);
  ASSERT_EQ(middle, kBox.mesh().vertices.size());
  EXPECT_EQ(splits.vertices()[*middle], (Vector3{1.5, 1, 1}));
  EXPECT_EQ(splits.tets().size(), tets + around);
  EXPECT_EQ(tets_around(splits, std::array{*middle}), 2 * around);
  EXPECT_EQ(tets_around(splits, edge), 0u);
}

TEST(TetSplits, ReplaceTheTetsOnBothSidesOfAFaceAndATet) {
  TetSplits splits(solid_of(kBox.mesh()).mesh);
  const std::size_t tets = splits.tets().size();
  const Tet tet = splits.tets()[0];
  const Triangle inner{kBox.at(0, 0, 0), kBox.at(1, 1, 1), kBox.at(1, 0, 0)},
      outer{kBox.at(0, 0, 0), kBox.at(1, 0, 0), kBox.at(1, 1, 0)};
  ASSERT_EQ(tets_around(splits, inner), 2u);
  ASSERT_EQ(tets_around(splits, outer), 1u);
  EXPECT_TRUE(splits.split_face(inner));
  EXPECT_EQ(splits.tets().size(), tets + 4);
  EXPECT_TRUE(splits.split_face(outer));
  EXPECT_EQ(splits.tets().size(), tets + 6);
  EXPECT_TRUE(splits.split_tet(20));
  EXPECT_EQ(splits.tets().size(), tets + 9);
  EXPECT_NE(splits.tets()[0], tet);
}

TEST(TetSplits, KeepVolumeAndOrientationAndNeverNeedRepair) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const SplitTetMesh split = split_box(seed);
    std::vector<Warning> warnings;
    const TetSolid solid = prepare_tets(split.mesh, warnings);
    EXPECT_TRUE(warnings.empty()) << warnings[0].text;
    EXPECT_EQ(solid.mesh.tets, split.mesh.tets);
    EXPECT_EQ(solid.components, 1u);
    EXPECT_NEAR(volume_of_tets(split.mesh), 12, 1e-12);
  }
}

TEST(TetSplits, EqualABruteForceOverAllElements) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const TetMesh given = tagged_box();
    TetSplits splits(given);
    PlainSplits plain(given);
    split_at_random(splits, 80, seed, &plain);
    const SplitTetMesh split = splits.result();
    std::multiset<std::tuple<std::pair<Tet, bool>, std::size_t>> tets, plain_tets;
    for (std::size_t t = 0; t < split.mesh.tets.size(); ++t)
      tets.insert({unordered(split.mesh.tets[t]), split.parents[t]});
    for (const auto& [v, given_tet] : plain.tets)
      plain_tets.insert({unordered({v[0], v[1], v[2], v[3]}), given_tet});
    EXPECT_EQ(tets, plain_tets);
    std::multiset<std::tuple<Triangle, std::int32_t>> faces, plain_faces;
    for (const TetMesh::Face& face : split.mesh.feature_faces) faces.insert({face.vertices, face.tag});
    for (const auto& [v, face] : plain.faces)
      plain_faces.insert({{v[0], v[1], v[2]}, given.feature_faces[face].tag});
    EXPECT_EQ(faces, plain_faces);
    std::multiset<std::tuple<Edge, std::int32_t, bool>> edges, plain_edges;
    for (const TetMesh::Edge& edge : split.mesh.feature_edges)
      edges.insert({edge.vertices, edge.tag, edge.is_stated});
    for (const auto& [v, edge] : plain.edges)
      plain_edges.insert({{v[0], v[1]}, given.feature_edges[edge].tag, given.feature_edges[edge].is_stated});
    EXPECT_EQ(edges, plain_edges);
    for (std::size_t v = 0; v < plain.points.size(); ++v)
      EXPECT_LT(norm(plain.points[v] - split.mesh.vertices[v]), 1e-14);
  }
}

TEST(TetSplits, KeepTheRegionAndTagsOfWhatIsSplit) {
  TetSplits splits(tagged_box());
  const std::uint32_t a = kBox.at(1, 1, 1), b = kBox.at(2, 1, 1), c = kBox.at(2, 2, 1);
  const std::optional<std::uint32_t> on_edge = splits.split_edge(a, b);
  const std::optional<std::uint32_t> in_face = splits.split_face({*on_edge, c, b});
  const SplitTetMesh split = splits.result();
  std::multiset<std::tuple<Edge, std::int32_t, bool>> edges;
  for (const TetMesh::Edge& edge : split.mesh.feature_edges)
    edges.insert({ascending(edge.vertices), edge.tag, edge.is_stated});
  const std::uint32_t e = *on_edge;
  for (const Edge& part : {Edge{a, e}, Edge{b, e}})
    for (const std::int32_t tag : {1, 3}) EXPECT_EQ(edges.count({part, tag, true}), 1u);
  EXPECT_EQ(edges.count({{b, c}, 2, false}), 1u);
  EXPECT_EQ(edges.size(), 6u);
  std::map<std::int32_t, std::size_t> faces_of_tag;
  for (const TetMesh::Face& face : split.mesh.feature_faces) ++faces_of_tag[face.tag];
  // Face a b c is there twice, as 4 and 6: halved, and one half cut in three.
  EXPECT_EQ(faces_of_tag, (std::map<std::int32_t, std::size_t>{{4, 4}, {5, 1}, {6, 4}, {8, 1}, {9, 12}}));
  EXPECT_TRUE(in_face);
  for (std::size_t t = 0; t < split.mesh.tets.size(); ++t)
    EXPECT_EQ(split.mesh.regions[t], tagged_box().regions[split.parents[t]]);
}

TEST(TetSplits, LeaveTheNumbersOfAllElsAsTheyWere) {
  const TetMesh given = tagged_box();
  const SplitTetMesh split = split_box(3);
  for (std::size_t v = 0; v < given.vertices.size(); ++v)
    EXPECT_EQ(split.mesh.vertices[v], given.vertices[v]);
  std::vector<std::size_t> parts(given.tets.size(), 0);
  for (const std::uint32_t parent : split.parents) ++parts[parent];
  EXPECT_GT(std::ranges::count(parts, 1u), 0);
  for (std::size_t t = 0; t < given.tets.size(); ++t) {
    EXPECT_EQ(split.parents[t], t);
    if (parts[t] == 1) {
      EXPECT_EQ(split.mesh.tets[t], given.tets[t]);
    }
  }
}

TEST(TetSplits, NameAParentThatHoldsEveryCornerOfATet) {
  const TetMesh given = tagged_box();
  const SplitTetMesh split = split_box(5);
  std::vector<double> volumes(given.tets.size(), 0);
  for (std::size_t t = 0; t < split.mesh.tets.size(); ++t) {
    volumes[split.parents[t]] += six_volumes(split.mesh, split.mesh.tets[t]);
    for (const std::uint32_t v : split.mesh.tets[t])
      EXPECT_TRUE(is_in(given, given.tets[split.parents[t]], split.mesh.vertices[v]));
  }
  for (std::size_t t = 0; t < given.tets.size(); ++t)
    EXPECT_NEAR(volumes[t], six_volumes(given, given.tets[t]), 1e-13);
}

TEST(TetSplits, NameVerticesOfWhichEachNewOneIsTheMean) {
  const std::size_t given = tagged_box().vertices.size();
  const SplitTetMesh split = split_box(6);
  ASSERT_EQ(split.mesh.vertices.size(), given + split.new_vertices.size());
  std::set<std::uint8_t> counts;
  for (std::size_t k = 0; k < split.new_vertices.size(); ++k) {
    Vector3 mean{0, 0, 0};
    const std::span<const std::uint32_t> used = split.new_vertices[k].used();
    counts.insert(split.new_vertices[k].count);
    for (const std::uint32_t v : used) {
      EXPECT_LT(v, given + k);
      mean += (1.0 / double(used.size())) * split.mesh.vertices[v];
    }
    EXPECT_LT(norm(mean - split.mesh.vertices[given + k]), 1e-14);
  }
  EXPECT_EQ(counts, (std::set<std::uint8_t>{2, 3, 4}));
}

TEST(TetSplits, LeaveTheBoundaryTheSameSetOfPoints) {
  const TetSolid before = solid_of(tagged_box());
  const TetSolid after = solid_of(split_box(8).mesh);
  ASSERT_GT(after.boundary.size(), before.boundary.size());
  std::vector<double> areas(before.boundary.size(), 0);
  for (const Triangle& part : after.boundary) {
    const auto holds = [&](const Triangle& face) {
      return std::ranges::all_of(
          part, [&](std::uint32_t v) { return is_on(before.mesh, face, after.mesh.vertices[v]); });
    };
    const auto at = std::ranges::find_if(before.boundary, holds);
    ASSERT_NE(at, before.boundary.end());
    areas[std::size_t(at - before.boundary.begin())] += area_of(after.mesh, part);
  }
  for (std::size_t f = 0; f < areas.size(); ++f)
    EXPECT_NEAR(areas[f], area_of(before.mesh, before.boundary[f]), 1e-12);
}

TEST(TetSplits, DoNotDependOnTheOrderInWhichAnEdgeOrFaceIsNamed) {
  const TetMesh given = tagged_box();
  TetSplits one(given), other(given);
  const std::uint32_t a = kBox.at(1, 1, 1), b = kBox.at(2, 1, 1), c = kBox.at(2, 2, 1);
  one.split_face({a, b, c});
  other.split_face({c, a, b});
  one.split_edge(a, b);
  other.split_edge(b, a);
  EXPECT_EQ(one.result().mesh.tets, other.result().mesh.tets);
  EXPECT_EQ(one.result().mesh.vertices, other.result().mesh.vertices);
}

TEST(TetSplits, RefuseToLeaveATetFlat) {
  TetMesh mesh = corner_tet();
  // Half of it is below the limit of flatness, whole it is above: 1.5 for the longest edge cubed, 2 sqrt 2.
  mesh.vertices[3] = {0.3, 0.3, 1.5 * kFlatness * 2 * std::sqrt(2.0)};
  ASSERT_EQ(shape_of_tet(mesh.vertices, mesh.tets[0]), TetShape::kPositive);
  TetSplits splits(mesh);
  EXPECT_FALSE(splits.split_edge(0, 3));
  EXPECT_FALSE(splits.split_face({0, 1, 3}));
  EXPECT_FALSE(splits.split_tet(0));
  const SplitTetMesh split = splits.result();
  EXPECT_EQ(split.mesh.vertices, mesh.vertices);
  EXPECT_EQ(split.mesh.tets, mesh.tets);
  EXPECT_TRUE(split.new_vertices.empty());
}

TEST(TetSplits, RefuseWhatIsNotThere) {
  TetSplits splits(kBox.mesh());
  EXPECT_FALSE(splits.split_edge(kBox.at(0, 0, 0), kBox.at(3, 2, 2)));
  EXPECT_FALSE(splits.split_edge(kBox.at(1, 1, 1), kBox.at(1, 1, 1)));
  EXPECT_FALSE(splits.split_face({kBox.at(0, 0, 0), kBox.at(1, 0, 0), kBox.at(2, 0, 0)}));
  EXPECT_EQ(splits.vertices().size(), kBox.mesh().vertices.size());
}

TEST(TetSplits, SplitFlatTetsWithTheirNeighbours) {
  // Two tets with a flat one between them, of four points of their common plane.
  TetMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}, {0.5, 0.5, -1}},
               {{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 1, 2, 3}, {1, 0, 3, 5}, {2, 1, 3, 5}}};
  TetSplits splits(mesh);
  EXPECT_TRUE(splits.split_edge(0, 2));
  EXPECT_TRUE(splits.split_edge(1, 3));
  const TetSolid before = solid_of(mesh), after = solid_of(splits.result().mesh);
  EXPECT_EQ(before.left_out_tets, 1u);
  EXPECT_EQ(after.left_out_tets, 4u);
  EXPECT_EQ(after.mesh.tets.size(), 8u);
  EXPECT_EQ(after.boundary.size(), before.boundary.size());
  EXPECT_EQ(after.components, 1u);
}

}  // namespace
}  // namespace crossgrain
