// SPDX-License-Identifier: Apache-2.0
#include "repair/moved_vertices.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "matching/made_matchings.hpp"
#include "tets/tet_meshes.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

using testing::frames_at_centroids;
using testing::TurningLine;

double worst_tet(const TetMesh& mesh, const std::vector<Vector3>& v) {
  double worst = 1;
  for (const auto& [a, b, c, d] : mesh.tets) worst = std::min(worst, mean_ratio({v[a], v[b], v[c], v[d]}));
  return worst;
}

std::vector<Quaternion> line_along_z(const TetSolid& solid) {
  return frames_at_centroids(solid, TurningLine{{2.03, 2.04, 0}, {0, 0, 1}, {0, 0, 1}, 0.25});
}

TEST(MovedVertices, StraightenAnArcAndKeepEverySideInItsPlane) {
  const TetSolid box = solid_of(TetBox{{4, 4, 4}}.mesh(0.2));
  const TetComplex complex(box);
  const auto frames = line_along_z(box);
  const MatchedField field(complex, frames);
  const std::vector<Vector3> moved = moved_vertices(field, /*sweeps=*/30);
  double before = 0, after = 0;
  for (std::uint32_t e = 0; e < complex.edges().size(); ++e) {
    const TetComplex::Edge& edge = complex.edges()[e];
    if (edge.is_on_boundary() || !field.is_singular(e)) continue;
    before += edge.length;
    after += norm(moved[edge.ends[1]] - moved[edge.ends[0]]);
  }
  EXPECT_GT(before, 4.01);
  EXPECT_NEAR(after, 4, 1e-3);
  EXPECT_GE(worst_tet(box.mesh, moved), std::min(worst_tet(box.mesh, box.mesh.vertices), 0.2));
  for (std::size_t v = 0; v < moved.size(); ++v) {
    int sides = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double at = box.mesh.vertices[v][k];
      if (at != 0 && at != 4) continue;
      EXPECT_EQ(moved[v][k], at);
      ++sides;
    }
    if (sides > 1) {
      EXPECT_EQ(moved[v], box.mesh.vertices[v]);
    }
  }
  EXPECT_NEAR(volume_of_tets({moved, box.mesh.tets}), 64, 1e-12);
}

TEST(MovedVertices, LeaveTheCurvedSurface) {
  const TetSolid cylinder = solid_of(tet_cylinder(6));
  const TetComplex complex(cylinder);
  const std::vector<Quaternion> frames(cylinder.mesh.tets.size(), Quaternion{1, 0, 0, 0});
  const std::vector<Vector3> moved = moved_vertices(MatchedField(complex, frames));
  for (std::size_t v = 0; v < moved.size(); ++v) {
    const Vector3& p = cylinder.mesh.vertices[v];
    if (std::hypot(p[0], p[1]) > 1 - 1e-9) {
      EXPECT_EQ(moved[v], p);
    }
  }
}

TEST(MovedVertices, LeaveWallsAndTaggedEdgesAndBordersOfTags) {
  TetMesh mesh = TetBox{{6, 4, 4}}.mesh(0.1);
  const TetBox box{{6, 4, 4}};
  for (std::uint32_t y = 0; y <= 4; ++y)
    for (std::uint32_t z = 0; z <= 4; ++z) mesh.vertices[box.at(3, y, z)] = {3, double(y), double(z)};
  mesh.vertices[box.at(2, 2, 0)] = {2.3, 2.1, 0};
  mesh = with_regions(mesh, [](const Vector3& p) { return p[0] < 3 ? 1 : 2; });
  mesh.feature_edges.push_back({{box.at(1, 1, 1), box.at(1, 1, 2)}, 5});
  mesh.feature_faces.push_back({{box.at(4, 1, 0), box.at(5, 1, 0), box.at(5, 2, 0)}, 7});
  const TetSolid solid = solid_of(mesh);
  const TetComplex complex(solid);
  const auto frames = frames_at_centroids(solid, TurningLine{{5.03, 2.04, 0}, {0, 0, 1}, {0, 0, 1}, 0.25});
  const std::vector<Vector3> moved = moved_vertices(MatchedField(complex, frames));
  const auto is_held = [&](std::uint32_t v) { return moved[v] == mesh.vertices[v]; };
  for (std::uint32_t y = 0; y <= 4; ++y)
    for (std::uint32_t z = 0; z <= 4; ++z) EXPECT_TRUE(is_held(box.at(3, y, z)));
  for (const std::uint32_t v :
       {box.at(1, 1, 1), box.at(1, 1, 2), box.at(4, 1, 0), box.at(5, 1, 0), box.at(5, 2, 0)})
    EXPECT_TRUE(is_held(v));
  EXPECT_FALSE(is_held(box.at(2, 1, 1)));
  const std::uint32_t on_side = box.at(2, 2, 0);
  EXPECT_FALSE(is_held(on_side));
  EXPECT_EQ(moved[on_side][2], 0);
  EXPECT_NEAR(norm(moved[on_side] - Vector3{2, 2, 0}), 0, 0.05);
}

TEST(MovedVertices, LeaveTheVerticesOfInnerTaggedFacesWhateverElseIsTagged) {
  const TetBox box{{4, 4, 4}};
  TetMesh mesh = box.mesh(0.1);
  std::vector<std::uint32_t> wall;
  for (std::uint32_t x = 0; x <= 4; ++x)
    for (std::uint32_t y = 0; y <= 4; ++y) wall.push_back(box.at(x, y, 2));
  for (const std::uint32_t v : wall) mesh.vertices[v][2] = 2;
  const TetSolid plain = solid_of(mesh);
  const auto tag = [&](const std::array<std::uint32_t, 3>& face) { mesh.feature_faces.push_back({face, 9}); };
  for (const TetSolid::InnerFace& face : plain.inner_faces) {
    const bool on_wall = std::all_of(face.vertices.begin(), face.vertices.end(),
                                     [&](std::uint32_t v) { return mesh.vertices[v][2] == 2; });
    for (int times = 0; on_wall && times < 2; ++times) tag(face.vertices);
  }
  for (std::size_t f = 0; f < plain.boundary.size(); f += 2) tag(plain.boundary[f]);
  const TetSolid solid = solid_of(mesh);
  const TetComplex complex(solid);
  const auto frames = line_along_z(solid);
  const std::vector<Vector3> moved = moved_vertices(MatchedField(complex, frames));
  EXPECT_NE(moved, mesh.vertices);
  for (const std::uint32_t v : wall) EXPECT_EQ(moved[v], mesh.vertices[v]);
}

TEST(MovedVertices, StayWhereNoLineIs) {
  const TetSolid box = solid_of(TetBox{{4, 4, 4}}.mesh(0.2));
  const TetComplex complex(box);
  const std::vector<Quaternion> frames(box.mesh.tets.size(), Quaternion{1, 0, 0, 0});
  EXPECT_EQ(moved_vertices(MatchedField(complex, frames)), box.mesh.vertices);
}

}  // namespace
}  // namespace crossgrain
