// SPDX-License-Identifier: Apache-2.0
#include "solve/tet_field.hpp"

#include <gtest/gtest.h>

#include "harmonics/frame.hpp"
#include "measure/made_tets.hpp"

namespace crossgrain {
namespace {

double squared_distance(const Quaternion& a, const Quaternion& b) {
  return squared_norm(difference(frame_coefficients<4>(a), frame_coefficients<4>(b)));
}

TEST(TetField, HasTheCommonFrameOfTheFourVerticesOnATet) {
  const TetMesh mesh = tet_box({1, 1, 1});
  const Quaternion frame = from_rotation_vector({0.3, -0.4, 0.2});
  for (const Quaternion& on_tet : tet_frames_of(mesh, std::vector<Quaternion>(8, frame)))
    EXPECT_NEAR(squared_distance(on_tet, frame), 0, 1e-25);
}

TEST(TetField, HasTheFrameHalfWayBetweenTwoPairsOnATet) {
  const TetMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}};
  // 70 degrees are 20 the other way round.
  const std::vector<Quaternion> frames{turn_about_z(0), turn_about_z(70), turn_about_z(0), turn_about_z(70)};
  EXPECT_NEAR(squared_distance(tet_frames_of(mesh, frames)[0], turn_about_z(-10)), 0, 1e-16);
}

TEST(TetField, IsTheBestFrameEverywhereOnTetsWhateverTheVerticesHave) {
  const TetMesh mesh = tet_box({4, 4, 4});
  for (const double spread_rad : {0.2, 0.5, 3.0}) {
    const auto frames = scattered_frames(mesh.vertices.size(), spread_rad);
    const auto on_tets = tet_frames_of(mesh, frames);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      Coefficients<4> sum{};
      for (const std::uint32_t v : mesh.tets[t]) add_scaled(sum, 1.0, frame_coefficients<4>(frames[v]));
      const double best = dot(sum, frame_coefficients<4>(nearest_frame<4>(sum)));
      EXPECT_NEAR(dot(sum, frame_coefficients<4>(on_tets[t])), best, 1e-10);
    }
  }
}

}  // namespace
}  // namespace crossgrain
