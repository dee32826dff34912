// SPDX-License-Identifier: Apache-2.0
#include "solve/tet_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "harmonics/frame.hpp"
#include "measure/made_tets.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

double squared_distance(const Quaternion& a, const Quaternion& b) {
  return squared_norm(difference(frame_coefficients<4>(a), frame_coefficients<4>(b)));
}

std::vector<bool> tets_with_faces(const TetSolid& solid) {
  std::vector<bool> has_face(solid.mesh.tets.size(), false);
  for (const std::uint32_t tet : solid.boundary_tets) has_face[tet] = true;
  return has_face;
}

TEST(TetField, HasTheCommonFrameOfTheFourVerticesOnATet) {
  const TetSolid solid = solid_of(tet_box({3, 3, 3}));
  const Quaternion frame = from_rotation_vector({0.3, -0.4, 0.2});
  const auto on_tets = tet_frames_of(solid, {}, std::vector<Quaternion>(solid.mesh.vertices.size(), frame));
  const std::vector<bool> has_face = tets_with_faces(solid);
  for (std::size_t t = 0; t < on_tets.size(); ++t) {
    if (has_face[t]) continue;
    EXPECT_NEAR(squared_distance(on_tets[t], frame), 0, 1e-25);
  }
}

TEST(TetField, HasTheFrameHalfWayBetweenTwoPairsOnATet) {
  const TetSolid solid = solid_of(tet_box({3, 3, 3}));
  const std::vector<bool> has_face = tets_with_faces(solid);
  const auto inside =
      static_cast<std::size_t>(std::find(has_face.begin(), has_face.end(), false) - has_face.begin());
  ASSERT_LT(inside, has_face.size());
  // 70 degrees are 20 the other way round.
  std::vector<Quaternion> frames(solid.mesh.vertices.size(), turn_about_z(0));
  for (const std::size_t k : {1, 3}) frames[solid.mesh.tets[inside][k]] = turn_about_z(70);
  EXPECT_NEAR(squared_distance(tet_frames_of(solid, {}, frames)[inside], turn_about_z(-10)), 0, 1e-16);
}

TEST(TetField, IsTheBestFrameInsideOnTetsWhateverTheVerticesHave) {
  const TetSolid solid = solid_of(tet_box({5, 5, 5}));
  const TetMesh& mesh = solid.mesh;
  const std::vector<bool> has_face = tets_with_faces(solid);
  for (const double spread_rad : {0.2, 0.5, 3.0}) {
    const auto frames = scattered_frames(mesh.vertices.size(), spread_rad);
    const auto on_tets = tet_frames_of(solid, {}, frames);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      if (has_face[t]) continue;
      Coefficients<4> sum{};
      for (const std::uint32_t v : mesh.tets[t]) add_scaled(sum, 1.0, frame_coefficients<4>(frames[v]));
      const double best = dot(sum, frame_coefficients<4>(nearest_frame<4>(sum)));
      EXPECT_NEAR(dot(sum, frame_coefficients<4>(on_tets[t])), best, 1e-10);
    }
  }
}

}  // namespace
}  // namespace crossgrain
