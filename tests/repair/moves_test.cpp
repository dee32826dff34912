// SPDX-License-Identifier: Apache-2.0
#include "repair/moves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "matching/made_matchings.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

using testing::random_tet_frames;

const TetSolid kBox = solid_of(TetBox{{3, 3, 3}}.mesh(0.1));
const TetComplex kComplex(kBox);

/// A way in the link of a vertex: its vertices, one more than faces.
struct LinkWay {
  std::vector<std::uint32_t> vertices, faces;
};

/// A random way of at most four faces that visits no vertex twice and passes only edges inside.
LinkWay random_way(std::uint32_t vertex, std::mt19937_64& random) {
  LinkWay way;
  const auto faces = kComplex.faces_at(vertex);
  if (faces.empty()) return way;
  const auto others = [&](std::uint32_t face) {
    std::vector<std::uint32_t> rest;
    for (const std::uint32_t v : kBox.inner_faces[face].vertices)
      if (v != vertex) rest.push_back(v);
    return rest;
  };
  way.vertices.push_back(others(faces[random() % faces.size()])[random() % 2]);
  for (int k = 0; k < 4; ++k) {
    std::vector<std::array<std::uint32_t, 2>> next;
    for (const std::uint32_t f : faces) {
      const auto ends = others(f);
      for (std::size_t side = 0; side < 2; ++side) {
        const bool is_new =
            std::find(way.vertices.begin(), way.vertices.end(), ends[1 - side]) == way.vertices.end();
        if (ends[side] == way.vertices.back() && is_new) next.push_back({f, ends[1 - side]});
      }
    }
    const bool may_pass =
        k == 0 || !kComplex.edges()[kComplex.edge_between(vertex, way.vertices.back())].is_on_boundary();
    if (next.empty() || !may_pass) break;
    const auto [face, to] = next[random() % next.size()];
    way.faces.push_back(face);
    way.vertices.push_back(to);
  }
  return way;
}

std::vector<std::uint8_t> holonomies(const MatchedField& field) {
  std::vector<std::uint8_t> all;
  for (std::uint32_t e = 0; e < kComplex.edges().size(); ++e) all.push_back(field.holonomy(e));
  return all;
}

TEST(Moves, PushAnArcFromAVertexAndChangeNoOtherEdgesThanTheySay) {
  std::mt19937_64 random(17);
  std::size_t tried = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const std::vector<Quaternion> frames = random_tet_frames(kBox, seed);
    for (std::uint32_t v = 0; v < kBox.mesh.vertices.size(); ++v) {
      MatchedField field(kComplex, frames);
      const LinkWay way = random_way(v, random);
      if (way.faces.empty()) continue;
      const std::vector<std::uint8_t> before = holonomies(field);
      const std::vector<FaceChange> changes = push_changes(field, v, way.vertices, way.faces);
      for (const FaceChange& change : changes) field.set_matching(change.face, change.matching);
      const std::vector<std::uint8_t> after = holonomies(field);
      std::set<std::uint32_t> may_change;
      for (std::size_t k = 0; k < changes.size(); ++k) {
        EXPECT_EQ(changes[k].face, way.faces[k]);
        const std::uint32_t spoke = kComplex.edge_between(v, way.vertices[k]);
        if (kComplex.edges()[spoke].is_on_boundary()) {
          const BoundaryTurn turn = field.boundary_turn(spoke);
          EXPECT_EQ(turn.hexahedra, turn.angle_deg < 100 ? 1 : 2);
        } else {
          EXPECT_EQ(after[spoke], CubeGroup::kIdentity);
        }
        may_change.insert(spoke);
        may_change.insert(kComplex.edge_between(way.vertices[k], way.vertices[k + 1]));
        may_change.insert(kComplex.edge_between(v, way.vertices[k + 1]));
      }
      for (std::uint32_t e = 0; e < before.size(); ++e)
        EXPECT_TRUE(may_change.count(e) > 0 || before[e] == after[e]);
      ++tried;
    }
  }
  EXPECT_GT(tried, 200u);
}

TEST(Moves, TakeOutTheArcAroundATurnedFace) {
  // An arc of one edge line: from -z to +z through a vertex inside; pushed from one edge to the other, it
  // goes along the way instead, and its turn is the same but for the names of axes.
  const std::vector<Quaternion> frames(kBox.mesh.tets.size(), Quaternion{1, 0, 0, 0});
  std::size_t tried = 0;
  for (std::uint32_t v = 0; v < kBox.mesh.vertices.size(); ++v) {
    if (kComplex.is_on_boundary(v)) continue;
    for (const std::uint32_t f : kComplex.faces_at(v)) {
      // Turning a face makes an arc along its three edges; pushed over it, nothing is left.
      MatchedField field(kComplex, frames);
      const std::uint8_t turn = CubeGroup::instance().number_of({1, 0, 0, 1});
      field.set_matching(f, turn);
      std::vector<std::uint32_t> rest;
      for (const std::uint32_t w : kBox.inner_faces[f].vertices)
        if (w != v) rest.push_back(w);
      const std::vector<FaceChange> changes = push_changes(field, v, rest, std::vector{f});
      ASSERT_EQ(changes.size(), 1u);
      for (const FaceChange& change : changes) field.set_matching(change.face, change.matching);
      for (std::uint32_t e = 0; e < kComplex.edges().size(); ++e)
        EXPECT_EQ(field.holonomy(e), CubeGroup::kIdentity);
      ++tried;
    }
  }
  EXPECT_GT(tried, 50u);
}

TEST(Moves, GiveACreaseTheQuarterTurnsOfItsGeometry) {
  std::size_t tried = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const std::vector<Quaternion> frames = random_tet_frames(kBox, seed);
    for (std::uint32_t e = 0; e < kComplex.edges().size(); ++e) {
      if (!kComplex.edges()[e].is_on_boundary()) continue;
      for (const Crossing& crossing : kComplex.around(e)) {
        MatchedField field(kComplex, frames);
        const auto& [v, w] = kComplex.edges()[e].ends;
        std::array<std::uint32_t, 2> way{w, w};
        for (const std::uint32_t other : kBox.inner_faces[crossing.face].vertices)
          if (other != v && other != w) way[1] = other;
        const std::vector<FaceChange> changes = push_changes(field, v, way, std::array{crossing.face});
        if (changes.empty()) continue;
        const BoundaryTurn before = field.boundary_turn(e);
        field.set_matching(crossing.face, changes[0].matching);
        const BoundaryTurn after = field.boundary_turn(e);
        EXPECT_EQ(after.hexahedra, before.angle_deg < 100 ? 1 : 2);
        ++tried;
      }
    }
  }
  EXPECT_GT(tried, 100u);
}

}  // namespace
}  // namespace crossgrain
