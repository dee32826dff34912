// SPDX-License-Identifier: Apache-2.0
#include "field/tet_finish.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

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
    std::vector<Warning> warnings;
    solid_ = prepare_tets(TetBox{{5, 4, 3}}.mesh(0.15), warnings);
    edges_ = stiffness_edges(solid_.mesh);
    boundary_ = classify_boundary_vertices(solid_);
    RandomSamples random(3);
    for (std::size_t i = 0; i < solid_.mesh.vertices.size(); ++i) {
      start_.push_back(from_rotation_vector(random.uniform(0, 0.3) * random.direction()));
    }
  }

  std::vector<Quaternion> finished(const TetFinishing& options) const {
    return finish_on_tets(edges_, boundary_, {start_}, static_cast<crossgrain::Degree>(Degree::value),
                          options, Monitor())
        .frames;
  }

  TetSolid solid_;
  std::vector<StiffnessEdge> edges_;
  BoundaryVertices boundary_;
  std::vector<Quaternion> start_;
};
TYPED_TEST_SUITE(TetFinish, testing::BothDegrees);

TYPED_TEST(TetFinish, OfABoxEndsAtTheFrameOfTheBox) {
  TetFinishing options;
  options.sweep_tolerance = 0;
  options.most_sweeps = 200;
  for (const Quaternion& frame : this->finished(options)) {
    // Frames are swept in single precision, and the energy is flat at its minimum.
    EXPECT_LT(testing::misorientation_rad(frame, Quaternion{}), 1e-3);
  }
}

TYPED_TEST(TetFinish, HoldsTheNormalsOfSmoothVerticesToRounding) {
  TetFinishing options;
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

TYPED_TEST(TetFinish, ReturnsTheLowestOfSeveralStarts) {
  TetFinishing options;
  options.relaxation_sweeps = 0;
  options.most_sweeps = 200;
  const std::vector<Quaternion> along(this->start_.size(), Quaternion{});
  // A quarter of the cube's symmetry away from the box: the sweeps do not leave it soon.
  const std::vector<Quaternion> across(this->start_.size(), from_rotation_vector({0, 0, 0.78}));
  const auto finish = [&](std::vector<std::vector<Quaternion>> starts) {
    return finish_on_tets(this->edges_, this->boundary_, std::move(starts),
                          static_cast<crossgrain::Degree>(TypeParam::value), options, Monitor());
  };
  EXPECT_EQ(finish({across, along, across}).start, 1u);
  EXPECT_EQ(finish({along, across}).start, 0u);
  for (const Quaternion& frame : finish({across, along}).frames)
    EXPECT_LT(testing::misorientation_rad(frame, Quaternion{}), 1e-3);
}

TYPED_TEST(TetFinish, DoesNotPreferAStartThatIgnoresGuides) {
  TetFinishing options;
  options.relaxation_sweeps = options.most_sweeps = 0;
  std::uint32_t inside = 0;
  const std::vector<std::uint32_t>& boundary = this->boundary_.vertices;
  while (std::find(boundary.begin(), boundary.end(), inside) != boundary.end()) ++inside;
  const std::vector<Quaternion> even(this->start_.size(), Quaternion{});
  std::vector<Quaternion> following = even;
  following[inside] = from_rotation_vector({0, 0, std::numbers::pi / 4});
  const auto best = [&](const std::vector<VertexGuide>& guides) {
    return finish_on_tets(this->edges_, this->boundary_, {even, following},
                          static_cast<crossgrain::Degree>(TypeParam::value), options, Monitor(), guides)
        .start;
  };
  EXPECT_EQ(best({}), 0u);
  EXPECT_EQ(best({{inside, normalised(Vector3{1, 1, 0}), 100}}), 1u);
}

/// A plate of one layer of cells: what smooth vertices it has lie on its two large faces, so only creases and
/// corners know where its sides are.
template <class Degree>
class FinishOfAPlate : public ::testing::Test {
 protected:
  /// From frames that all stand along the large faces but are turned against the sides.
  std::vector<Quaternion> finished(TetBoundary boundary_option) const {
    TetFinishing options;
    options.boundary = boundary_option;
    options.relaxation_sweeps = 0;
    options.most_sweeps = 200;
    options.sweep_tolerance = 0;
    const TetSolid solid = solid_of(TetBox{{6, 5, 1}}.mesh());
    return finish_on_tets(stiffness_edges(solid.mesh), classify_boundary_vertices(solid),
                          {std::vector<Quaternion>(solid.mesh.vertices.size(), turned_)},
                          static_cast<crossgrain::Degree>(Degree::value), options, Monitor())
        .frames;
  }

  Quaternion turned_ = from_rotation_vector({0, 0, 0.5});
};
TYPED_TEST_SUITE(FinishOfAPlate, testing::BothDegrees);

TYPED_TEST(FinishOfAPlate, FollowsItsCreases) {
  for (const Quaternion& frame : this->finished(TetBoundary::kAll))
    EXPECT_LT(testing::misorientation_rad(frame, Quaternion{}), 1e-3);
}

TYPED_TEST(FinishOfAPlate, LeavesCreasesFreeWhereTold) {
  // Nothing but creases and corners could turn it.
  for (const Quaternion& frame : this->finished(TetBoundary::kSmoothOnly))
    EXPECT_LT(testing::misorientation_rad(frame, this->turned_), 1e-3);
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

TYPED_TEST(TetFinish, HoldsTaggedEdgesInsideAndOnFacesToRounding) {
  const TetBox box{{5, 4, 3}};
  InnerFeatures features;
  features.edges = {{box.at(1, 1, 1), box.at(2, 2, 1)},
                    {box.at(2, 2, 1), box.at(3, 3, 1)},
                    {box.at(1, 1, 3), box.at(2, 2, 3)}};
  this->boundary_ = classify_boundary_vertices(this->solid_, {}, features);
  const std::vector<Quaternion> held = this->finished({}),
                                free = this->finished({{}, TetBoundary::kSmoothOnly});
  double freest_rad = 0;
  for (const auto& [a, b] : features.edges) {
    const Vector3 along = normalised(this->solid_.mesh.vertices[b] - this->solid_.mesh.vertices[a]);
    // Of the one through the middle, inside, the tangent is between the edges before and after.
    const bool on_face = a == box.at(1, 1, 3);
    for (const std::uint32_t v : {a, b}) {
      EXPECT_LT(angle_to_nearest_axis_rad(held[v], along), on_face ? 1e-7 : 0.2);
      if (on_face) {
        EXPECT_LT(angle_to_nearest_axis_rad(held[v], {0, 0, 1}), 1e-7);
      }
      freest_rad = std::max(freest_rad, angle_to_nearest_axis_rad(free[v], along));
    }
  }
  EXPECT_GT(freest_rad, 0.5);
}

}  // namespace
}  // namespace crossgrain
