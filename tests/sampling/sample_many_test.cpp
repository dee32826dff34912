// SPDX-License-Identifier: Apache-2.0
// What a field says at points beside frames, and at many points in one call.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <numbers>
#include <random>

#include "crossgrain/error.hpp"
#include "crossgrain/frame_field.hpp"
#include "crossgrain/thread_limit.hpp"
#include "field/field_data.hpp"
#include "field/made_grid.hpp"
#include "harmonics/deviation.hpp"
#include "sampling/arc_distance.hpp"
#include "sampling/frames_in_leaves.hpp"
#include "sampling/sampling.hpp"

namespace crossgrain {
namespace {

using FrameAt = std::function<Quaternion(const Vector3&)>;

std::shared_ptr<FieldData> data_of(const Octree& tree, const FrameAt& frame_at) {
  auto data = std::make_shared<FieldData>();
  data->tree = tree;
  data->open_faces = testing::all_open(tree);
  for (CellIndex i = 0; i < tree.size(); ++i) data->frames.push_back(to_stored(frame_at(tree.centre(i))));
  return data;
}

/// A quarter turn once around the line x = y = 1/2.
Quaternion around_a_line(const Vector3& p) {
  return from_rotation_vector({0, 0, std::atan2(p[1] - 0.5, p[0] - 0.5) / 4});
}

/// Leaves are missing, so that the field has an outside within.
std::shared_ptr<FieldData> holed(const FrameAt& frame_at, unsigned seed) {
  std::mt19937 engine(seed);
  std::vector<CellAddress> leaves = testing::graded_octree(seed).leaves();
  std::erase_if(leaves, [&](CellAddress) { return engine() % 20 == 0; });
  return data_of(Octree({{0, 0, 0}, 1}, std::move(leaves)), frame_at);
}

/// In the cube and around it, and on corners, edges and faces of cells.
std::vector<Vector3> scattered(std::size_t count, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> coordinate(-0.1, 1.1);
  std::vector<Vector3> points(count);
  for (std::size_t k = 0; k < count; ++k) {
    for (double& x : points[k]) {
      x = coordinate(engine);
      if (k % 4 == 0 || (k % 4 == 1 && engine() % 2)) x = std::round(32 * x) / 32;
    }
  }
  return points;
}

void expect_same(const FrameField::Sample& a, const FrameField::Sample& b) {
  ASSERT_EQ(a.frame.axes, b.frame.axes);
  ASSERT_EQ(a.in_active_cell, b.in_active_cell);
  ASSERT_EQ(a.deviation, b.deviation);
  ASSERT_EQ(a.singular_distance, b.singular_distance);
}

TEST(SamplingMany, IsThatOfEachPointToTheBitWhateverTheirNumber) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const FrameField field(holed(around_a_line, seed));
    for (const std::size_t count : {0, 1, 5, 8, 63, 1024, 3001}) {
      const std::vector<Vector3> points = scattered(count, seed);
      const std::vector<FrameField::Sample> samples = field.sample(points);
      ASSERT_EQ(samples.size(), count);
      for (std::size_t k = 0; k < count; ++k)
        ASSERT_NO_FATAL_FAILURE(expect_same(samples[k], field.sample(points[k])));
    }
  }
}

TEST(Sampler, WithTurnsOnDemandIsTheSameToTheBit) {
  const auto data = holed(around_a_line, 6);
  const Sampler all(data->tree, data->frames, data->open_faces);
  const Sampler on_demand(data->tree, data->frames, data->open_faces, Sampler::Turns::kOnDemand);
  for (const Vector3& point : scattered(500, 6)) {
    const Sampler::Result a = all.at(point), b = on_demand.at(point);
    ASSERT_EQ(std::memcmp(&a.frame, &b.frame, sizeof(Quaternion)), 0);
    ASSERT_EQ(a.leaf, b.leaf);
    ASSERT_EQ(a.deviation, b.deviation);
  }
}

TEST(FramesInLeaves, AreThoseOfTheSamplerToTheBit) {
  const auto data = holed(around_a_line, 5);
  const Sampler sampler(data->tree, data->frames, data->open_faces);
  const LeafField field{data->tree, data->frames, data->open_faces};
  FramesInLeaves frames(field);
  std::mt19937 engine(5);
  std::vector<Quaternion> expected;
  const auto compare = [&] {
    const std::span<const Quaternion> found = frames.frames();
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k)
      ASSERT_EQ(std::memcmp(&found[k], &expected[k], sizeof(Quaternion)), 0);
    expected.clear();
  };
  for (CellIndex leaf = 0; leaf < data->tree.size(); leaf += 3) {
    const Box box = data->tree.root().box(data->tree[leaf]);
    for (unsigned k = 0; k < engine() % 4; ++k) {
      Vector3 point;
      for (std::size_t axis = 0; axis < 3; ++axis)
        point[axis] = std::uniform_real_distribution<double>(box.low[axis], box.high[axis])(engine);
      if (frames.is_full()) {
        ASSERT_NO_FATAL_FAILURE(compare());
      }
      frames.add(leaf, point);
      expected.push_back(sampler.in_leaf(leaf, point));
    }
  }
  ASSERT_NO_FATAL_FAILURE(compare());
}

TEST(SamplingMany, OfAPointThatIsNowhereIsAnError) {
  const FrameField field(holed(around_a_line, 1));
  for (const double nowhere :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Vector3 point{0.5, 0.5, 0.5};
      point[axis] = nowhere;
      EXPECT_THROW(field.sample(point), Error);
      EXPECT_THROW(field.sample(std::vector<Vector3>{{0.5, 0.5, 0.5}, point}), Error);
    }
  }
  EXPECT_NO_THROW(field.sample(Vector3{1e300, -1e300, 1e300}));
}

TEST(SamplingMany, IsTheSameForAnyNumberOfThreads) {
  const FrameField field(holed(around_a_line, 4));
  const std::vector<Vector3> points = scattered(20000, 4);
  const auto with = [&](int threads) {
    const ThreadLimit limit(threads);
    return field.sample(points);
  };
  const std::vector<FrameField::Sample> one = with(1), all = with(0);
  for (std::size_t k = 0; k < points.size(); ++k) ASSERT_NO_FATAL_FAILURE(expect_same(one[k], all[k]));
}

TEST(SamplingDeviation, IsZeroInAConstantFieldHoweverItsCellsNameTheirAxes) {
  std::mt19937 engine(5);
  const Quaternion frame = from_rotation_vector({0.4, -0.7, 0.5});
  const Quaternion quarter = from_rotation_vector({0, std::numbers::pi / 2, 0});
  const FrameField field(holed([&](const Vector3&) { return engine() % 2 ? frame : frame * quarter; }, 5));
  // Frames in single precision are 1e-7 apart, and the fourth power of that counts.
  for (const FrameField::Sample& sample : field.sample(scattered(2000, 5)))
    ASSERT_LT(sample.deviation, 1e-24);
}

TEST(SamplingDeviation, IsZeroOutside) {
  const FrameField field(holed(around_a_line, 6));
  int outside = 0;
  for (const FrameField::Sample& sample : field.sample(scattered(2000, 6))) {
    if (sample.in_active_cell) continue;
    ++outside;
    ASSERT_EQ(sample.deviation, 0);
  }
  EXPECT_GT(outside, 100);
}

TEST(SamplingDeviation, IsThatOfTheBlendOfCoefficients) {
  // Like the squares of a chessboard, frames take turns in being turned by 45 degrees about z, too far for
  // any turn to be seen, and their coefficients differ in the sign of the last.
  constexpr int kCells = 4;
  const auto square = [](const Vector3& p) {
    const int sum =
        static_cast<int>(kCells * p[0]) + static_cast<int>(kCells * p[1]) + static_cast<int>(kCells * p[2]);
    return from_rotation_vector({0, 0, sum % 2 ? std::numbers::pi / 4 : 0});
  };
  const FrameField field(data_of(testing::uniform_octree(2), square));
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> coordinate(0.125, 0.875);
  for (int k = 0; k < 1000; ++k) {
    const Vector3 p{coordinate(engine), coordinate(engine), coordinate(engine)};
    double last =
        1;  // the weighted mean of the signs: between centres of cells it goes from one to the other
    for (const double x : p) {
      const double t = kCells * x - 0.5, cell = std::floor(t);
      last *= (static_cast<int>(cell) % 2 ? -1 : 1) * (1 - 2 * (t - cell));
    }
    Coefficients<4> h = reference_frame<4>();
    h.back() *= last;
    const double expected = deviation<4>(scaled(h, 1 / std::sqrt(squared_norm(h))));
    ASSERT_NEAR(field.sample(p).deviation, expected, 1e-4);  // 200/3 at most, from frames good to 1e-7
  }
}

TEST(SamplingDeviation, OnALineThatFramesTurnAboutIsThatOfTheAxisAlone) {
  // Of four frames with an axis in common, each turned by 22.5 degrees from the last, only the coefficient of
  // order 0 is left.
  const FrameField field(data_of(testing::uniform_octree(3), around_a_line));
  for (const double z : {0.3, 0.5, 0.51}) EXPECT_NEAR(field.sample({0.5, 0.5, z}).deviation, 200.0 / 3, 1e-4);
  EXPECT_LT(field.sample({0.9, 0.9, 0.5}).deviation, 0.01);
}

TEST(SamplingSingularDistance, IsThatToTheArcsOfTheField) {
  const FrameField field(data_of(testing::uniform_octree(3), around_a_line));
  ASSERT_EQ(field.singularities().arcs.size(), 1u);
  const ArcDistance distance(field.singularities().arcs);
  const std::vector<Vector3> points = scattered(500, 8);
  const std::vector<FrameField::Sample> samples = field.sample(points);
  for (std::size_t k = 0; k < points.size(); ++k)
    ASSERT_EQ(samples[k].singular_distance, distance.at(points[k]));
  EXPECT_NEAR(field.sample({0.9, 0.8, 0.5}).singular_distance, 0.5, 1e-12);
}

TEST(SamplingSingularDistance, IsInfiniteWhereThereAreNoArcs) {
  const FrameField field(data_of(testing::uniform_octree(2), [](const Vector3&) { return Quaternion{}; }));
  for (const FrameField::Sample& sample : field.sample(scattered(20, 9)))
    EXPECT_EQ(sample.singular_distance, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace crossgrain
