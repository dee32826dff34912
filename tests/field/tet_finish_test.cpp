// SPDX-License-Identifier: Apache-2.0
#include "field/tet_finish.hpp"

#include <gtest/gtest.h>

#include "harmonics/frame.hpp"
#include "harmonics/random_samples.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

using testing::RandomSamples;

double angle_to_nearest_axis_rad(const Quaternion& frame, const Vector3& direction) {
  double sine = INFINITY;
  for (const Vector3& axis : axes_of(frame)) sine = std::min(sine, norm(cross(axis, direction)));
  return std::asin(std::min(1.0, sine));
}

template <class Degree>
class TetFinish : public ::testing::Test {
 protected:
  TetFinish() {
    std::vector<std::string> warnings;
    solid_ = prepare_tets(TetBox{{5, 4, 3}}.mesh(0.15), warnings);
    edges_ = stiffness_edges(solid_.mesh);
    boundary_ = classify_boundary_vertices(solid_);
    RandomSamples random(3);
    for (std::size_t i = 0; i < solid_.mesh.vertices.size(); ++i) {
      start_.push_back(from_rotation_vector(random.uniform(0, 0.3) * random.direction()));
    }
  }

  std::vector<Quaternion> finished(const OntoOptions& options) const {
    return finish_on_tets(edges_, boundary_, start_, static_cast<crossgrain::Degree>(Degree::value), options,
                          Monitor());
  }

  TetSolid solid_;
  std::vector<StiffnessEdge> edges_;
  BoundaryVertices boundary_;
  std::vector<Quaternion> start_;
};
TYPED_TEST_SUITE(TetFinish, testing::BothDegrees);

TYPED_TEST(TetFinish, OfABoxEndsAtTheFrameOfTheBox) {
  OntoOptions options;
  options.sweep_tolerance = 0;
  options.most_sweeps = 200;
  for (const Quaternion& frame : this->finished(options)) {
    // Frames are swept in single precision, and the energy is flat at its minimum.
    EXPECT_LT(testing::misorientation_rad(frame, Quaternion{}), 1e-3);
  }
}

TYPED_TEST(TetFinish, HoldsTheNormalsOfSmoothVerticesToRounding) {
  OntoOptions options;
  options.most_sweeps = 3;
  const std::vector<Quaternion> frames = this->finished(options);
  std::size_t smooth = 0;
  for (std::size_t k = 0; k < this->boundary_.size(); ++k) {
    if (this->boundary_.classes[k] != BoundaryClass::kSmooth) continue;
    ++smooth;
    const Quaternion& frame = frames[this->boundary_.vertices[k]];
    EXPECT_LT(angle_to_nearest_axis_rad(frame, this->boundary_.normals[k]), 1e-12);
  }
  EXPECT_GT(smooth, 20u);
}

TYPED_TEST(TetFinish, LeavesCreasesFreeWhereTold) {
  OntoOptions free, bound;
  free.boundary = TetBoundary::kSmoothOnly;
  // Relaxed, a box has no conflict left to tell the two apart.
  free.relaxation_sweeps = bound.relaxation_sweeps = 0;
  free.most_sweeps = bound.most_sweeps = 3;
  const std::vector<Quaternion> with = this->finished(bound), without = this->finished(free);
  double worst_with = 0, worst_without = 0;
  for (std::size_t k = 0; k < this->boundary_.size(); ++k) {
    if (this->boundary_.classes[k] == BoundaryClass::kSmooth) continue;
    for (const FaceAtVertex& face : this->boundary_.faces_at(k)) {
      const std::uint32_t vertex = this->boundary_.vertices[k];
      worst_with = std::max(worst_with, angle_to_nearest_axis_rad(with[vertex], face.normal));
      worst_without = std::max(worst_without, angle_to_nearest_axis_rad(without[vertex], face.normal));
    }
  }
  EXPECT_LT(worst_with, 1e-2);
  EXPECT_GT(worst_without, 3 * worst_with);
}

TEST(WithAxisAlong, TurnsByNoMoreThanTheAngleToTheNearestAxis) {
  RandomSamples random(9);
  for (int i = 0; i < 200; ++i) {
    const Quaternion frame = random.rotation();
    const Vector3 direction = random.direction();
    const Quaternion turned = with_axis_along(frame, direction);
    EXPECT_LT(angle_to_nearest_axis_rad(turned, direction), 1e-15);
    EXPECT_LE(testing::misorientation_rad(turned, frame), angle_to_nearest_axis_rad(frame, direction) + 1e-7);
  }
}

}  // namespace
}  // namespace crossgrain
