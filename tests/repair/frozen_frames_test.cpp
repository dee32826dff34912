// SPDX-License-Identifier: Apache-2.0
#include "repair/frozen_frames.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "crossgrain/thread_limit.hpp"
#include "matching/made_matchings.hpp"
#include "measure/made_tets.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

using testing::frames_at_centroids;

const TetSolid kCylinder = solid_of(tet_cylinder(6));
const TetComplex kComplex(kCylinder);

/// sum of |q_a - q_b g|^2 over inner faces, with the sign of q_b that makes it least.
double roughness(const MatchedField& field, const std::vector<Quaternion>& frames) {
  double sum = 0;
  for (std::uint32_t f = 0; f < kCylinder.inner_faces.size(); ++f) {
    const auto& [from, to] = kCylinder.inner_faces[f].tets;
    const Quaternion named = frames[to] * to_quaternion(CubeGroup::instance()[field.matching(f)]);
    const Quaternion& own = frames[from];
    sum += 2 - 2 * std::abs(named.w * own.w + named.x * own.x + named.y * own.y + named.z * own.z);
  }
  return sum;
}

TEST(FrozenFrames, KeepAnAxisAlongTheNormalOfEachFaceOfTheSurface) {
  const auto frames = frames_at_centroids(kCylinder, [](const Vector3& p) {
    return from_rotation_vector({0.3 * std::sin(p[0]), 0.2, 0.4 * p[2]});
  });
  const MatchedField field(kComplex, frames);
  const std::vector<Quaternion> smooth = smoothed_frames(field, frames);
  std::vector<int> faces_of(kCylinder.mesh.tets.size(), 0);
  for (const std::uint32_t tet : kCylinder.boundary_tets) ++faces_of[tet];
  for (std::uint32_t f = 0; f < kCylinder.boundary.size(); ++f) {
    const std::uint32_t tet = kCylinder.boundary_tets[f];
    if (faces_of[tet] > 1) continue;
    const SignedAxis axis = field.normal_axis(f);
    const Vector3 held = (axis < 3 ? 1.0 : -1.0) * axes_of(smooth[tet])[axis % 3];
    EXPECT_NEAR(dot(held, kComplex.boundary_normals()[f]), 1, 1e-12);
  }
}

TEST(FrozenFrames, BecomeSmoothForTheMatchingsTheyHave) {
  // Scattered about frames that follow the flat ends.
  std::vector<Quaternion> frames = scattered_frames(kCylinder.mesh.tets.size(), 0.3);
  const std::vector<Quaternion> straight(frames.size(), Quaternion{1, 0, 0, 0});
  const MatchedField field(kComplex, straight);
  const double before = roughness(field, frames);
  const std::vector<Quaternion> smooth = smoothed_frames(field, std::move(frames));
  EXPECT_LT(roughness(field, smooth), 0.2 * before);
}

TEST(FrozenFrames, AreTheSameToTheBitForAnyNumberOfThreads) {
  const auto frames = scattered_frames(kCylinder.mesh.tets.size(), 0.5);
  const MatchedField field(kComplex, frames);
  const auto smoothed_on = [&](int threads) {
    const ThreadLimit limit(threads);
    return smoothed_frames(field, frames);
  };
  const auto one = smoothed_on(1), two = smoothed_on(2);
  for (std::size_t t = 0; t < one.size(); ++t) {
    EXPECT_EQ(one[t].w, two[t].w);
    EXPECT_EQ(one[t].z, two[t].z);
  }
}

}  // namespace
}  // namespace crossgrain
