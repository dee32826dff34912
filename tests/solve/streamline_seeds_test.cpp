// SPDX-License-Identifier: Apache-2.0
// Seeds of streamlines on surfaces and cuts, the distance between lines, and the names of axes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "crossgrain/error.hpp"
#include "crossgrain/streamlines.hpp"
#include "field/field_data.hpp"
#include "field/made_grid.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using FrameAt = std::function<Quaternion(const Vector3&)>;

constexpr double kCell = 1.0 / 16;

/// A field on the unit cube.
std::shared_ptr<FieldData> cube_data(const FrameAt& frame_at) {
  auto data = std::make_shared<FieldData>();
  data->tree = testing::uniform_octree(4);
  data->open_faces = testing::all_open(data->tree);
  data->frames = testing::frames_of(data->tree, frame_at);
  data->on_boundary.assign(data->tree.size(), 1);
  return data;
}

TriangleMesh cube_surface() {
  return translate_mesh(make_box({1, 1, 1}), {0.5, 0.5, 0.5});
}

/// Frames that turn about z by 80 degrees from x = 0 to x = 1.
Quaternion turning(const Vector3& p) {
  return from_rotation_vector({0, 0, 80.0 / 180 * std::numbers::pi * p[0]});
}

TEST(StreamlineSeeds, OnASurfaceAreSpreadByAreaSlightlyInsideForLinesAlongIt) {
  const TriangleMesh surface = cube_surface();
  const StreamlineTracer tracer(FrameField(cube_data(turning)), {}, &surface);
  const auto few = tracer.surface_seeds(60), many = tracer.surface_seeds(600);
  ASSERT_EQ(many.size(), 600u);
  std::array<int, 6> on_face{};
  for (std::size_t k = 0; k < many.size(); ++k) {
    const auto& [point, across] = many[k];
    if (k < few.size()) {
      EXPECT_EQ(few[k].point, point);
    }
    int faces = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (std::abs(across[axis]) < 0.5) continue;
      const bool is_high = across[axis] > 0;
      const double depth = is_high ? 1 - point[axis] : point[axis];
      EXPECT_NEAR(depth, 0.25 * kCell, 1e-12);
      ++on_face[2 * axis + (is_high ? 1 : 0)];
      ++faces;
    }
    EXPECT_EQ(faces, 1);
  }
  for (const int count : on_face) EXPECT_NEAR(count, 100, 5);
  const Streamlines lines = tracer.trace(few);
  EXPECT_EQ(lines.lines.size(), 120u);
  for (const Streamline& line : lines.lines)
    EXPECT_LT(std::abs(dot(line.tangents[line.seed_point], few[line.seed].across)), 0.8);
}

TEST(StreamlineSeeds, OnACutAreSpreadOverItForLinesAlongIt) {
  const TriangleMesh surface = cube_surface();
  const StreamlineTracer tracer(FrameField(cube_data(turning)), {}, &surface);
  const auto few = tracer.cut_seeds(2, 0.3, 40), many = tracer.cut_seeds(2, 0.3, 400);
  ASSERT_EQ(many.size(), 400u);
  std::array<int, 4> in_quarter{};
  for (std::size_t k = 0; k < many.size(); ++k) {
    if (k < few.size()) {
      EXPECT_EQ(few[k].point, many[k].point);
    }
    EXPECT_EQ(many[k].point[2], 0.3);
    ++in_quarter[(many[k].point[0] > 0.5) + 2 * (many[k].point[1] > 0.5)];
  }
  for (const int count : in_quarter) EXPECT_NEAR(count, 100, 5);
  for (const Streamline& line : tracer.trace(few).lines) {
    EXPECT_NE(line.axis, 2);
    for (const Vector3& p : line.points) EXPECT_NEAR(p[2], 0.3, 1e-6);
  }
  EXPECT_EQ(tracer.cut_seeds(0, {}, 3)[0].point[0], 0.5);
  EXPECT_THROW(tracer.cut_seeds(1, 1.5, 3), Error);
  EXPECT_THROW(StreamlineTracer(FrameField(cube_data(turning))).surface_seeds(3), Error);
}

TEST(StreamlineSpacing, KeepsLinesAlongLikeAxesApart) {
  StreamlineOptions options;
  options.spacing_sides = 0.1;
  const StreamlineTracer tracer(FrameField(cube_data(turning)), options);
  const auto seeds = tracer.spread_seeds(500);
  const auto lines = tracer.trace(seeds).lines;
  EXPECT_GT(lines.size(), 100u);
  EXPECT_LT(lines.size(), 600u);
  // Lines are sampled at a quarter of the spacing.
  constexpr double kRounding = 0.97;
  for (std::size_t a = 0; a < lines.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      for (std::size_t i = 0; i < lines[a].points.size(); ++i) {
        for (std::size_t j = 0; j < lines[b].points.size(); ++j) {
          if (std::abs(dot(lines[a].tangents[i], lines[b].tangents[j])) < std::sqrt(0.5)) continue;
          const double distance = norm(lines[a].points[i] - lines[b].points[j]);
          ASSERT_GT(distance, kRounding * 0.05);
          if (i == lines[a].seed_point) {
            ASSERT_GT(distance, kRounding * 0.1);
          }
        }
      }
    }
  }
}

TEST(StreamlineSpacing, EndsASpiralAfterOneTurn) {
  // Lines about the middle come 6 % nearer to it with each turn.
  const FrameField field(cube_data([](const Vector3& p) {
    return from_rotation_vector({0, 0, std::atan2(p[1] - 0.5, p[0] - 0.5) + 0.01});
  }));
  StreamlineOptions options;
  options.spacing_sides = 0.1;
  constexpr double kRadius = 0.3, kAround = 2 * std::numbers::pi * kRadius;
  const std::vector<Vector3> seeds{{0.5 + kRadius, 0.5, 0.5}};
  std::size_t ended = 0;
  for (const Streamline& line : StreamlineTracer(field, options).trace(seeds).lines) {
    EXPECT_LT(line.length, 1.2 * kAround);
    if (line.last_end != StreamlineEnd::kCrowded && line.first_end != StreamlineEnd::kCrowded) continue;
    EXPECT_GT(line.length, 0.8 * kAround);
    ++ended;
  }
  EXPECT_EQ(ended, 1u);
}

TEST(StreamlineAxes, AreNamedAlikeThroughoutTheField) {
  // At x = 1 the axis named x is nearer to y.
  const StreamlineTracer tracer(FrameField(cube_data(turning)));
  const auto seeds = tracer.spread_seeds(100);
  // Deep inside, frames are turned by about 40 degrees.
  for (const Streamline& line : tracer.trace(seeds).lines) {
    const Vector3 axis = axes_of(turning(seeds[line.seed]))[static_cast<std::size_t>(line.axis)];
    EXPECT_GT(std::abs(dot(line.tangents[line.seed_point], axis)), 0.99);
  }
}

}  // namespace
}  // namespace crossgrain
