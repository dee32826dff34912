// SPDX-License-Identifier: Apache-2.0
#include "matching/tet_complex.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/vector3.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

const TetSolid kBox = solid_of(TetBox{{3, 4, 3}}.mesh(0.2));
const TetComplex kComplex(kBox);

std::uint32_t third_of(const std::array<std::uint32_t, 3>& face, const std::array<std::uint32_t, 2>& edge) {
  return *std::find_if(face.begin(), face.end(),
                       [&](std::uint32_t v) { return v != edge[0] && v != edge[1]; });
}

/// Angle about an edge from one vertex to another, right-handed, from 0 to 2 pi.
double angle_rad(const std::array<std::uint32_t, 2>& edge, std::uint32_t from, std::uint32_t to) {
  const std::vector<Vector3>& v = kBox.mesh.vertices;
  const Vector3 along = normalised(v[edge[1]] - v[edge[0]]);
  const auto across = [&](std::uint32_t vertex) {
    const Vector3 out = v[vertex] - v[edge[0]];
    return out - dot(out, along) * along;
  };
  const double angle = std::atan2(dot(cross(across(from), across(to)), along), dot(across(from), across(to)));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

TEST(TetComplex, HasEveryEdgeOfTheTetsOnce) {
  std::set<std::array<std::uint32_t, 2>> edges;
  for (const auto& tet : kBox.mesh.tets)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) edges.insert({std::min(tet[i], tet[j]), std::max(tet[i], tet[j])});
  ASSERT_EQ(kComplex.edges().size(), edges.size());
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    const auto& ends = kComplex.edges()[e].ends;
    EXPECT_EQ(edges.count(ends), 1u);
    EXPECT_EQ(kComplex.edge_between(ends[1], ends[0]), e);
  }
}

TEST(TetComplex, GoesOnceAroundEachInnerEdgeRightHanded) {
  for (std::uint32_t e = 0; e < kComplex.edges().size(); ++e) {
    const TetComplex::Edge& edge = kComplex.edges()[e];
    if (edge.is_on_boundary()) continue;
    const auto around = kComplex.around(e);
    double turned = 0;
    std::uint32_t tet = edge.first_tet;
    for (std::size_t k = 0; k < around.size(); ++k) {
      const TetSolid::InnerFace& face = kBox.inner_faces[around[k].face];
      EXPECT_EQ(face.tets[around[k].reversed], tet);
      tet = face.tets[!around[k].reversed];
      const TetSolid::InnerFace& next = kBox.inner_faces[around[(k + 1) % around.size()].face];
      turned += angle_rad(edge.ends, third_of(face.vertices, edge.ends), third_of(next.vertices, edge.ends));
    }
    EXPECT_EQ(tet, edge.first_tet);
    EXPECT_NEAR(turned, 2 * std::numbers::pi, 1e-9);
  }
}

TEST(TetComplex, GoesThroughTheSolidFromTheFirstFaceToTheSecondAtAnEdgeOfTheBoundary) {
  std::size_t creases = 0;
  for (std::uint32_t e = 0; e < kComplex.edges().size(); ++e) {
    const TetComplex::Edge& edge = kComplex.edges()[e];
    if (!edge.is_on_boundary()) continue;
    const auto& [first, last] = edge.boundary_faces;
    std::uint32_t tet = kBox.boundary_tets[first];
    EXPECT_EQ(tet, edge.first_tet);
    for (const Crossing& crossing : kComplex.around(e)) {
      EXPECT_EQ(kBox.inner_faces[crossing.face].tets[crossing.reversed], tet);
      tet = kBox.inner_faces[crossing.face].tets[!crossing.reversed];
    }
    EXPECT_EQ(tet, kBox.boundary_tets[last]);
    const double angle = angle_rad(edge.ends, third_of(kBox.boundary[first], edge.ends),
                                   third_of(kBox.boundary[last], edge.ends));
    const bool is_crease = norm(kComplex.boundary_normals()[first] - kComplex.boundary_normals()[last]) > 0.5;
    EXPECT_NEAR(angle, (is_crease ? 0.5 : 1.0) * std::numbers::pi, 1e-9);
    creases += is_crease;
  }
  EXPECT_EQ(creases, 4u * (3 + 4 + 3));
}

TEST(TetComplex, RunsAroundBoundaryVerticesCounterClockwiseSeenFromOutside) {
  for (std::uint32_t v = 0; v < kBox.mesh.vertices.size(); ++v) {
    const auto ring = kComplex.ring(v);
    const Vector3& p = kBox.mesh.vertices[v];
    const bool is_outside = p[0] == 0 || p[0] == 3 || p[1] == 0 || p[1] == 4 || p[2] == 0 || p[2] == 3;
    EXPECT_EQ(!ring.empty(), is_outside);
    EXPECT_EQ(kComplex.is_on_boundary(v), is_outside);
    double angle = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const TetComplex::RingFace &here = ring[k], &next = ring[(k + 1) % ring.size()];
      const TetComplex::Edge& edge = kComplex.edges()[here.edge];
      // The way through the solid from a face to the next is right-handed about the edge away from the
      // vertex.
      const std::size_t at = edge.ends[0] == v ? 0 : 1;
      EXPECT_EQ(edge.boundary_faces[at], here.face);
      EXPECT_EQ(edge.boundary_faces[1 - at], next.face);
      angle += here.angle_rad;
    }
    if (is_outside) {
      const int sides = (p[0] == 0 || p[0] == 3) + (p[1] == 0 || p[1] == 4) + (p[2] == 0 || p[2] == 3);
      EXPECT_NEAR(angle, (sides == 3 ? 1.5 : 2.0) * std::numbers::pi, 1e-9);
    }
  }
}

TEST(TetComplex, ListsTheEdgesAndInnerFacesOfEachVertex) {
  for (std::uint32_t e = 0; e < kComplex.edges().size(); ++e) {
    for (const std::uint32_t v : kComplex.edges()[e].ends) {
      const auto at = kComplex.edges_at(v);
      EXPECT_EQ(std::count(at.begin(), at.end(), e), 1);
    }
  }
  for (std::uint32_t f = 0; f < kBox.inner_faces.size(); ++f) {
    for (const std::uint32_t v : kBox.inner_faces[f].vertices) {
      const auto at = kComplex.faces_at(v);
      EXPECT_EQ(std::count(at.begin(), at.end(), f), 1);
    }
    for (const std::uint32_t e : kComplex.edges_of_face(f)) {
      const auto around = kComplex.around(e);
      EXPECT_EQ(std::count_if(around.begin(), around.end(), [&](const Crossing& c) { return c.face == f; }),
                1);
    }
  }
}

TEST(TetComplex, KnowsVerticesWhereTwoPartsTouch) {
  // Two tets that share one vertex.
  const TetSolid solid =
      solid_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
                {{0, 1, 2, 3}, {0, 5, 4, 6}}});
  const TetComplex complex(solid);
  EXPECT_TRUE(complex.is_pinched(0));
  EXPECT_TRUE(complex.is_on_boundary(0));
  EXPECT_FALSE(complex.is_pinched(1));
}

}  // namespace
}  // namespace crossgrain
