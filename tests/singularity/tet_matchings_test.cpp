// SPDX-License-Identifier: Apache-2.0
#include "singularity/tet_matchings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>

#include "field/field_state.hpp"
#include "field/made_grid.hpp"
#include "singularity/singularity_graph.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

using testing::TurningLine;
using Edge = std::array<std::uint32_t, 2>;

const TetSolid kBox = solid_of(TetBox{{8, 7, 9}}.mesh(0.2));

Vector3 centroid(const TetMesh& mesh, const std::array<std::uint32_t, 4>& tet) {
  Vector3 sum{0, 0, 0};
  for (const std::uint32_t v : tet) sum += mesh.vertices[v];
  return 0.25 * sum;
}

template <class Field>
std::vector<Quaternion> frames_at_tets(const TetSolid& solid, const Field& field) {
  std::vector<Quaternion> frames;
  for (const auto& tet : solid.mesh.tets) frames.push_back(field(centroid(solid.mesh, tet)));
  return frames;
}

std::vector<Quaternion> random_tet_frames(const TetSolid& solid, std::uint64_t seed) {
  std::vector<Quaternion> frames;
  for (const StoredQuaternion& q : random_frames(solid.mesh.tets.size(), seed))
    frames.push_back(from_stored(q));
  return frames;
}

std::vector<CubeRotation> all_cube_rotations() {
  std::vector<CubeRotation> all{{}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (const CubeRotation& turn : {CubeRotation{1, 1, 0, 0}, CubeRotation{1, 0, 1, 0}}) {
      const CubeRotation next = turn * all[k];
      if (std::find(all.begin(), all.end(), next) == all.end()) all.push_back(next);
    }
  }
  return all;
}

/// Sum of the squared distances of axes.
double distance(const Quaternion& p, const Quaternion& q) {
  const auto a = axes_of(p), b = axes_of(q);
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += dot(a[k] - b[k], a[k] - b[k]);
  return sum;
}

TEST(TetMatchings, AreTheNearestOfAllTwentyFourAndTheirInversesLeadBack) {
  const std::vector<CubeRotation> all = all_cube_rotations();
  ASSERT_EQ(all.size(), 24u);
  const std::vector<Quaternion> frames = random_tet_frames(kBox, 3);
  const std::vector<CubeRotation> matchings = tet_matchings(kBox, frames);
  ASSERT_EQ(matchings.size(), kBox.inner_faces.size());
  for (std::size_t f = 0; f < matchings.size(); ++f) {
    const Quaternion &from = frames[kBox.inner_faces[f].tets[0]], &to = frames[kBox.inner_faces[f].tets[1]];
    double nearest = std::numeric_limits<double>::infinity();
    for (const CubeRotation& g : all) nearest = std::min(nearest, distance(from, to * to_quaternion(g)));
    EXPECT_NEAR(distance(from, to * to_quaternion(matchings[f])), nearest, 1e-12);
    EXPECT_NEAR(distance(to, from * to_quaternion(inverse(matchings[f]))), nearest, 1e-12);
  }
}

/// The singular edges, found by sorting the tets at each edge by their angle about it.
std::set<Edge> edges_by_brute_force(const TetSolid& solid, std::span<const Quaternion> frames) {
  std::map<Edge, std::vector<std::size_t>> tets_at;
  for (std::size_t t = 0; t < solid.mesh.tets.size(); ++t)
    for (const std::uint32_t a : solid.mesh.tets[t])
      for (const std::uint32_t b : solid.mesh.tets[t])
        if (a < b) tets_at[{a, b}].push_back(t);
  std::set<Edge> on_boundary;
  for (const auto& face : solid.boundary)
    for (const std::uint32_t a : face)
      for (const std::uint32_t b : face)
        if (a < b) on_boundary.insert({a, b});
  std::set<Edge> singular;
  for (auto& [edge, tets] : tets_at) {
    if (on_boundary.contains(edge)) continue;
    const Vector3 from = solid.mesh.vertices[edge[0]], way = normalised(solid.mesh.vertices[edge[1]] - from);
    const Vector3 u = orthogonal_unit(way), v = cross(way, u);
    const auto angle_rad = [&](std::size_t t) {
      const Vector3 p = centroid(solid.mesh, solid.mesh.tets[t]) - from;
      return std::atan2(dot(p, v), dot(p, u));
    };
    std::sort(tets.begin(), tets.end(),
              [&](std::size_t a, std::size_t b) { return angle_rad(a) < angle_rad(b); });
    CubeRotation product;
    for (std::size_t k = 0; k < tets.size(); ++k)
      product = matching(frames[tets[k]], frames[tets[(k + 1) % tets.size()]]) * product;
    if (!product.is_identity()) singular.insert(edge);
  }
  return singular;
}

std::set<Edge> edges_of(const SingularEdges& singular) {
  std::set<Edge> edges;
  for (const SingularEdge& edge : singular.edges) {
    Edge names{};
    for (std::size_t k = 0; k < 2; ++k)
      names[k] = static_cast<std::uint32_t>(singular.points[edge.ends[k]].name);
    std::sort(names.begin(), names.end());
    edges.insert(names);
  }
  EXPECT_EQ(edges.size(), singular.edges.size());
  return edges;
}

TEST(SingularTetEdges, AreThoseThatSortingByAnglesFinds) {
  for (const std::uint64_t seed : {1u, 2u}) {
    const std::vector<Quaternion> frames = random_tet_frames(kBox, seed);
    const std::set<Edge> found = edges_of(singular_tet_edges(kBox, frames));
    EXPECT_EQ(found, edges_by_brute_force(kBox, frames));
    EXPECT_GT(found.size(), 100u);
  }
}

TEST(SingularTetEdges, AreNoneOfASmoothField) {
  const Vector3 pole{3, 3, 4};
  const auto field = [&](const Vector3& p) { return from_rotation_vector(0.1 * (p - pole)); };
  EXPECT_TRUE(singular_tet_edges(kBox, frames_at_tets(kBox, field)).edges.empty());
}

TEST(SingularTetEdges, FollowALineWithItsIndexWhicheverNamesAxesHave) {
  const Vector3 direction = normalised(Vector3{0.2, -0.3, 1});
  const std::vector<CubeRotation> all = all_cube_rotations();
  std::mt19937 random(11);
  for (const double turns : {0.25, -0.25}) {
    std::vector<Quaternion> frames =
        frames_at_tets(kBox, TurningLine{{4.1, 3.4, 4.5}, direction, direction, turns});
    for (Quaternion& frame : frames) frame = frame * to_quaternion(all[random() % all.size()]);
    const SingularityGraph graph = singularity_graph(singular_tet_edges(kBox, frames));
    ASSERT_EQ(graph.arcs.size(), 1u);
    EXPECT_EQ(graph.arcs[0].index, turns);
    EXPECT_EQ(graph.nodes.size(), 2u);
    for (const SingularityGraph::Node& node : graph.nodes) EXPECT_TRUE(node.on_boundary);
    for (const Vector3& point : graph.arcs[0].points) {
      const Vector3 p = point - Vector3{4.1, 3.4, 4.5};
      EXPECT_LT(norm(p - dot(p, direction) * direction), 1);
    }
  }
}

TEST(SingularTetEdges, LeaveAnArcUndecidedAcrossWhichFramesTurn) {
  const Vector3 direction = normalised(Vector3{0.2, -0.3, 1});
  const auto frames =
      frames_at_tets(kBox, TurningLine{{4.1, 3.4, 4.5}, direction, orthogonal_unit(direction), 0.25});
  const SingularityGraph graph = singularity_graph(singular_tet_edges(kBox, frames));
  ASSERT_EQ(graph.arcs.size(), 1u);
  EXPECT_EQ(graph.arcs[0].oblique_length, graph.arcs[0].length);
  EXPECT_EQ(graph.arcs[0].verdict, Verdict::kUndecided);
}

}  // namespace
}  // namespace crossgrain
