// SPDX-License-Identifier: Apache-2.0
#include "measure/tet_evaluation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "measure/made_tets.hpp"
#include "singularity/matching.hpp"

namespace crossgrain {
namespace {

/// The corner of the unit cube, and another on the other side of the face that looks away from the corner.
TetMesh corner_tets(bool both) {
  TetMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}};
  if (both) {
    mesh.vertices.push_back({1, 1, 1});
    mesh.tets.push_back({4, 1, 3, 2});
  }
  return mesh;
}

/// Names the axes of every frame anew.
std::vector<Quaternion> renamed(std::vector<Quaternion> frames) {
  std::mt19937 random(13);
  std::normal_distribution<double> normal;
  for (Quaternion& frame : frames) {
    const Quaternion any{normal(random), normal(random), normal(random), normal(random)};
    frame = frame * to_quaternion(nearest_cube_rotation(any));
  }
  return frames;
}

TEST(TetEvaluation, OfOneTurnedVertexIsWhatTheGradientsSay) {
  // |h_i - h_j|^2 = 5/3 (3 - sum of cosines^4) is 5/3 for an eighth of a turn; the three edges at the corner
  // have weight 1/6, the others 0.
  const auto result = evaluate(solid_of(corner_tets(false)), {turn_about_z(45), {}, {}, {}});
  EXPECT_NEAR(result.dirichlet, 0.5 * 3 * (1.0 / 6) * (5.0 / 3), 1e-14);
  EXPECT_NEAR(result.edge_sum, 3 * (5.0 / 3), 1e-14);
}

TEST(TetEvaluation, OfEqualFramesIsZeroWhateverTheirNames) {
  const TetSolid solid = solid_of(tet_box({3, 2, 2}));
  const auto result = evaluate(solid, renamed(std::vector<Quaternion>(solid.mesh.vertices.size())));
  EXPECT_NEAR(result.dirichlet, 0, 1e-25);
  EXPECT_NEAR(result.edge_sum, 0, 1e-25);
  EXPECT_EQ(result.singular.interior_faces, 0u);
  EXPECT_EQ(result.singular.boundary_faces, 0u);
}

TEST(TetEvaluation, DoesNotDependOnTheNamesOfAxes) {
  const TetSolid solid = solid_of(tet_box({4, 4, 4}, 0.2));
  const auto frames = scattered_frames(solid.mesh.vertices.size(), 0.5);
  const auto as_given = evaluate(solid, frames), anew = evaluate(solid, renamed(frames));
  EXPECT_GT(as_given.singular.interior_faces, 10u);
  EXPECT_EQ(anew.singular.interior_faces, as_given.singular.interior_faces);
  EXPECT_EQ(anew.singular.boundary_faces, as_given.singular.boundary_faces);
  EXPECT_NEAR(anew.dirichlet, as_given.dirichlet, 1e-12 * as_given.dirichlet);
  EXPECT_NEAR(*anew.normal_deg.mean, *as_given.normal_deg.mean, 1e-10);
}

TEST(TetEvaluation, FindsTheFacesAroundWhichFramesMakeAQuarterTurn) {
  // Vertices 1, 2, 3 turn by a third of a quarter from one to the next.
  std::vector<Quaternion> frames{turn_about_z(30), turn_about_z(0), turn_about_z(30), turn_about_z(60)};
  auto result = evaluate(solid_of(corner_tets(false)), frames);
  EXPECT_EQ(result.singular.interior_faces, 0u);
  EXPECT_EQ(result.singular.boundary_faces, 2u) << "what goes in comes out";
  frames.push_back(turn_about_z(30));
  result = evaluate(solid_of(corner_tets(true)), frames);
  EXPECT_EQ(result.singular.interior_faces, 1u);
  EXPECT_EQ(result.singular.boundary_faces, 2u);
}

TEST(TetEvaluation, TakesNormalsAtSmoothVerticesAndFacesAtCreases) {
  // Two cubes a side: one smooth vertex in the middle of each face.
  const TetSolid solid = solid_of(tet_box({2, 2, 2}));
  const auto result = evaluate(solid, std::vector<Quaternion>(solid.mesh.vertices.size(), turn_about_z(10)));
  EXPECT_NEAR(*result.normal_deg.mean, 40.0 / 6, 1e-6);
  EXPECT_NEAR(*result.normal_deg.max, 10, 1e-6);
  // 48 triangles have 144 corners, of which 36 are at smooth vertices. A third of the others looks along z.
  EXPECT_NEAR(*result.crease_deg.mean, 20.0 / 3, 1e-6);
}

TEST(TetEvaluation, InterpolatesThePercentileBetweenRanks) {
  // Six smooth vertices: 95 % is at rank 4.75 from 0.
  const TetSolid solid = solid_of(tet_box({2, 2, 2}));
  std::vector<Quaternion> frames(solid.mesh.vertices.size());
  frames[4] = from_rotation_vector({0.1, 0, 0});   // the middle of the face z = 0
  frames[10] = from_rotation_vector({0.2, 0, 0});  // of y = 0
  const auto result = evaluate(solid, frames);
  EXPECT_NEAR(*result.normal_deg.p95, (0.25 * 0.1 + 0.75 * 0.2) * 180 / std::numbers::pi, 1e-6);
}

TEST(TetEvaluation, HasNoAnglesWhereThereIsNoSuchVertex) {
  const auto result = evaluate(solid_of(corner_tets(false)), std::vector<Quaternion>(4));
  EXPECT_FALSE(result.normal_deg.mean || result.normal_deg.p95 || result.normal_deg.max);
  EXPECT_TRUE(result.crease_deg.mean && result.crease_deg.p95 && result.crease_deg.max);
}

TEST(TetEvaluation, OfAFieldOnCellsIsWhatFacesAndCentroidsSay) {
  // The face has area sqrt(3)/2; the centroids (1,1,1)/4 and (1,1,1)/2 are sqrt(3)/4 apart.
  const TetSolid solid = solid_of(corner_tets(true));
  const auto result = evaluate_cell_field(solid, std::vector<Quaternion>{{}, turn_about_z(45)});
  EXPECT_NEAR(result.dirichlet, 0.5 * 2 * (5.0 / 3), 1e-14);
  EXPECT_NEAR(evaluate_cell_field(solid, std::vector<Quaternion>{{}, turn_about_z(90)}).dirichlet, 0, 1e-25);
  const auto along =
      evaluate_cell_field(solid_of(tet_box({1, 1, 1})), std::vector<Quaternion>(6, turn_about_z(10)));
  EXPECT_NEAR(*along.normal_deg.mean, 20.0 / 3, 1e-6);
}

TEST(TetEvaluation, IsTheSameToTheBitForAnyNumberOfThreads) {
  const TetSolid solid = solid_of(tet_box({6, 6, 6}, 0.2));
  const auto frames = scattered_frames(solid.mesh.vertices.size(), 0.5);
  const auto with_threads = [&](int threads) {
    const ThreadLimit limit(threads);
    return evaluate(solid, frames);
  };
  const auto one = with_threads(1), three = with_threads(3);
  EXPECT_EQ(one.dirichlet, three.dirichlet);
  EXPECT_EQ(one.edge_sum, three.edge_sum);
  EXPECT_EQ(one.singular.interior_faces, three.singular.interior_faces);
}

}  // namespace
}  // namespace crossgrain
