// SPDX-License-Identifier: Apache-2.0
#include "matching/matched_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "matching/made_matchings.hpp"
#include "singularity/surface_hexahedra.hpp"
#include "singularity/tet_matchings.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

using testing::frames_at_centroids;
using testing::random_tet_frames;
using testing::turn_random_faces;
using testing::TurningLine;
using Ends = std::array<std::uint32_t, 2>;

const TetSolid kBox = solid_of(TetBox{{4, 4, 4}}.mesh(0.1));
const TetComplex kComplex(kBox);

std::vector<Quaternion> straight_frames(const TetSolid& solid) {
  return std::vector<Quaternion>(solid.mesh.tets.size(), Quaternion{1, 0, 0, 0});
}

TEST(MatchedField, HasTheSingularEdgesOfTheNearestMatchings) {
  const std::vector<Quaternion> frames = random_tet_frames(kBox, 5);
  const MatchedField field(kComplex, frames);
  std::set<Ends> expected, found;
  const SingularEdges singular = singular_tet_edges(kBox, frames);
  for (const SingularEdge& edge : singular.edges) {
    const auto a = static_cast<std::uint32_t>(singular.points[edge.ends[0]].name),
               b = static_cast<std::uint32_t>(singular.points[edge.ends[1]].name);
    expected.insert({std::min(a, b), std::max(a, b)});
  }
  for (std::uint32_t e = 0; e < kComplex.edges().size(); ++e)
    if (!kComplex.edges()[e].is_on_boundary() && field.is_singular(e)) found.insert(kComplex.edges()[e].ends);
  EXPECT_EQ(found, expected);
  EXPECT_EQ(field.matchings(), tet_matchings(kBox, frames));
}

TEST(MatchedField, TurnsAroundAnArcOfThreeOrFiveHexahedra) {
  for (const double turns : {0.25, -0.25}) {
    const auto frames = frames_at_centroids(kBox, TurningLine{{2.03, 2.04, 0}, {0, 0, 1}, {0, 0, 1}, turns});
    const MatchedField field(kComplex, frames);
    std::size_t singular = 0;
    for (std::uint32_t e = 0; e < kComplex.edges().size(); ++e) {
      if (kComplex.edges()[e].is_on_boundary() || !field.is_singular(e)) continue;
      const EdgeTurn turn = field.turn_around(e);
      EXPECT_EQ(turn.kind, EdgeTurn::Kind::kQuarter);
      EXPECT_EQ(turn.valence(), turns > 0 ? 3 : 5);
      ++singular;
    }
    EXPECT_GE(singular, 4u);
  }
}

TEST(MatchedField, CountsQuarterTurnsAtTheBoundaryAsFramesDo) {
  const std::vector<Quaternion> frames = random_tet_frames(kBox, 8);
  const MatchedField field(kComplex, frames);
  std::array<std::size_t, 5> counts{};
  for (std::uint32_t e = 0; e < kComplex.edges().size(); ++e) {
    const TetComplex::Edge& edge = kComplex.edges()[e];
    if (!edge.is_on_boundary()) continue;
    std::vector<Quaternion> way{frames[edge.first_tet]};
    for (const Crossing& crossing : kComplex.around(e))
      way.push_back(frames[kBox.inner_faces[crossing.face].tets[!crossing.reversed]]);
    const auto& [first, last] = edge.boundary_faces;
    const Vector3 along = kBox.mesh.vertices[edge.ends[1]] - kBox.mesh.vertices[edge.ends[0]];
    const BoundaryTurn turn = field.boundary_turn(e);
    const int expected = quarter_turns(
        way, {kComplex.boundary_normals()[first], kComplex.boundary_normals()[last]}, along, turn.angle_deg);
    // Where one axis goes on as another, a sharp edge is convex by its geometry, whatever random frames say.
    if (turn.angle_deg < 100 && expected % 2 == 1)
      EXPECT_EQ(turn.hexahedra, 1);
    else
      EXPECT_EQ(turn.hexahedra, expected);
    ++counts[static_cast<std::size_t>(turn.hexahedra)];
  }
  for (const std::size_t k : {0, 1, 2, 3}) EXPECT_GT(counts[k], 0u);
}

TEST(MatchedField, FindsHexahedraEverywhereInABoxThatFramesFollow) {
  const auto frames = straight_frames(kBox);
  const MatchedField field(kComplex, frames);
  for (std::uint32_t v = 0; v < kBox.mesh.vertices.size(); ++v)
    EXPECT_EQ(field.vertex_state(v), VertexState::kPossible);
}

TEST(MatchedField, FindsHexahedraAtAnArcFromFaceToFaceAndNotWhereItLeavesThroughTheSides) {
  // A quarter turn about z around a line along z fits the faces above and below. Nothing fits on the sides,
  // which the frames there do not follow.
  const auto frames = frames_at_centroids(kBox, TurningLine{{2.03, 2.04, 0}, {0, 0, 1}, {0, 0, 1}, 0.25});
  const MatchedField field(kComplex, frames);
  for (std::uint32_t v = 0; v < kBox.mesh.vertices.size(); ++v) {
    const Vector3& p = kBox.mesh.vertices[v];
    const bool is_on_side = p[0] == 0 || p[0] == 4 || p[1] == 0 || p[1] == 4;
    if (is_on_side) continue;
    EXPECT_EQ(field.vertex_state(v), VertexState::kPossible) << p[0] << " " << p[1] << " " << p[2];
  }
}

TEST(MatchedField, FindsNoHexahedraWhereAnArcTouchesTheSurface) {
  // One turned face with a vertex on the surface: an arc around it that comes to the surface and leaves it.
  const auto frames = straight_frames(kBox);
  std::size_t tried = 0;
  for (std::uint32_t f = 0; f < kBox.inner_faces.size(); ++f) {
    const auto& vertices = kBox.inner_faces[f].vertices;
    const auto outside = static_cast<std::size_t>(std::count_if(
        vertices.begin(), vertices.end(), [&](std::uint32_t v) { return kComplex.is_on_boundary(v); }));
    if (outside != 1) continue;
    for (std::uint8_t turn = 1; turn < CubeGroup::kCount; ++turn) {
      MatchedField field(kComplex, frames);
      field.set_matching(f, turn);
      for (const std::uint32_t v : vertices)
        EXPECT_TRUE(!kComplex.is_on_boundary(v) || field.vertex_state(v) == VertexState::kImpossible);
      ++tried;
    }
  }
  EXPECT_GT(tried, 100u);
}

TEST(MatchedField, FindsNoHexahedraWhereACreaseOfTheMapEndsInAFace) {
  const auto frames = straight_frames(kBox);
  std::size_t tried = 0;
  for (std::uint32_t e = 0; e < kComplex.edges().size(); ++e) {
    const TetComplex::Edge& edge = kComplex.edges()[e];
    const auto is_in_a_face = [&](std::uint32_t v) {
      const Vector3& p = kBox.mesh.vertices[v];
      return (p[0] == 0 || p[0] == 4) + (p[1] == 0 || p[1] == 4) + (p[2] == 0 || p[2] == 4) == 1;
    };
    if (!edge.is_on_boundary() || !is_in_a_face(edge.ends[0]) || !is_in_a_face(edge.ends[1])) continue;
    for (std::uint8_t turn = 1; turn < CubeGroup::kCount; ++turn) {
      MatchedField field(kComplex, frames);
      field.set_matching(kComplex.around(e)[0].face, turn);
      if (field.boundary_turn(e).hexahedra == 2) continue;
      for (const std::uint32_t v : edge.ends) EXPECT_EQ(field.vertex_state(v), VertexState::kImpossible);
      ++tried;
    }
  }
  EXPECT_GT(tried, 100u);
}

/// Vertices inside at which no hexahedra can meet, about a line along z whose axis is tilted by so much.
template <class Tilt>
std::size_t impossible_vertices_inside(const Tilt& tilt_deg) {
  const TetSolid box = solid_of(TetBox{{4, 4, 7}}.mesh(0.02));
  const TetComplex complex(box);
  const TurningLine line{{2.03, 2.04, 0}, {0, 0, 1}, {0, 0, 1}, 0.25};
  const auto frames = frames_at_centroids(box, [&](const Vector3& p) {
    return from_rotation_vector({0, tilt_deg(p[2]) * std::numbers::pi / 180, 0}) * line(p);
  });
  const MatchedField field(complex, frames);
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < box.mesh.vertices.size(); ++v)
    count += !complex.is_on_boundary(v) && field.vertex_state(v) == VertexState::kImpossible;
  return count;
}

TEST(MatchedField, TakesTheSenseOfEdgesAcrossTheirAxisFromTheArc) {
  // Along the axis at one end, across it in the middle, against it at the other: a turning point, though no
  // two edges of other senses meet at a vertex.
  const auto to_across = [](double z) { return std::clamp(60 * (z - 1), 0.0, 90.0); };
  const auto from_across = [](double z) { return std::clamp(60 * (z - 4.5), 0.0, 90.0); };
  EXPECT_GT(impossible_vertices_inside([&](double z) { return to_across(z) + from_across(z); }), 0u);
  // Along the axis at both ends; across it everywhere, so that either sense is possible.
  EXPECT_EQ(impossible_vertices_inside([&](double z) { return to_across(z) - from_across(z); }), 0u);
  EXPECT_EQ(impossible_vertices_inside([](double) { return 90.0; }), 0u);
}

TEST(MatchedField, DoesNotDependOnTheNamesOfAxes) {
  const CubeGroup& group = CubeGroup::instance();
  const auto frames = frames_at_centroids(kBox, TurningLine{{2.03, 2.04, 0}, {0, 0, 1}, {0, 0, 1}, 0.25});
  MatchedField field(kComplex, frames);
  turn_random_faces(field, 12, 3);
  std::mt19937_64 random(4);
  std::vector<std::uint8_t> names;
  std::vector<Quaternion> renamed;
  for (const Quaternion& frame : frames) {
    names.push_back(static_cast<std::uint8_t>(random() % CubeGroup::kCount));
    renamed.push_back(frame * to_quaternion(group[names.back()]));
  }
  // R_from -> R_from a and R_to -> R_to b change a matching to inverse(b) g a.
  std::vector<CubeRotation> matchings;
  for (std::uint32_t f = 0; f < kBox.inner_faces.size(); ++f) {
    const auto& [from, to] = kBox.inner_faces[f].tets;
    matchings.push_back(inverse(group[names[to]]) * (group[field.matching(f)] * group[names[from]]));
  }
  const MatchedField other(kComplex, renamed, matchings);
  for (std::uint32_t v = 0; v < kBox.mesh.vertices.size(); ++v)
    EXPECT_EQ(field.vertex_state(v), other.vertex_state(v));
  for (std::uint32_t e = 0; e < kComplex.edges().size(); ++e) {
    if (kComplex.edges()[e].is_on_boundary()) {
      EXPECT_EQ(field.boundary_turn(e).hexahedra, other.boundary_turn(e).hexahedra);
    } else {
      EXPECT_EQ(field.turn_around(e).kind, other.turn_around(e).kind);
      // Frames that differ by half a turn give a half turn around an edge no sense.
      const bool has_sense = field.turn_around(e).kind != EdgeTurn::Kind::kHalf;
      const double own = field.turn_around(e).cosine, others = other.turn_around(e).cosine;
      EXPECT_NEAR(has_sense ? own : std::abs(own), has_sense ? others : std::abs(others), 1e-9);
    }
  }
}

}  // namespace
}  // namespace crossgrain
