// SPDX-License-Identifier: Apache-2.0
// Streamlines on tets.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>

#include "crossgrain/streamlines.hpp"
#include "crossgrain/thread_limit.hpp"
#include "field/field_data.hpp"
#include "field/made_grid.hpp"
#include "singularity/tet_matchings.hpp"
#include "solve/lines_in_cube.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tet_field.hpp"
#include "solve/tuned_tracer.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

using testing::distance_to_faces;

using FrameAt = std::function<Quaternion(const Vector3&)>;

/// The unit cube of `cells` per side, cut into tets.
TetMesh unit_cube(std::uint32_t cells, double shake = 0) {
  TetMesh mesh = TetBox{{cells, cells, cells}}.mesh(shake);
  for (Vector3& p : mesh.vertices) p = (1.0 / cells) * p;
  return mesh;
}

/// A field on tets without a grid.
TetFrameField field_of(TetMesh mesh, std::vector<Quaternion> vertex_frames) {
  TetDomain domain(std::move(mesh));
  auto field = std::make_shared<TetField>();
  field->vertex_frames = std::move(vertex_frames);
  field->tet_frames = tet_frames_of(domain.mesh(), field->vertex_frames);
  return TetFrameField(FrameField(std::make_shared<FieldData>()), std::move(domain), field, {});
}

TetFrameField field_of(const TetMesh& mesh, const FrameAt& frame_at) {
  std::vector<Quaternion> frames;
  for (const Vector3& p : mesh.vertices) frames.push_back(frame_at(p));
  return field_of(mesh, std::move(frames));
}

/// The same field, each vertex with another of the 24 names for its axes.
TetFrameField renamed(const TetFrameField& field, unsigned seed) {
  std::vector<Quaternion> frames = field.data().vertex_frames;
  std::mt19937 engine(seed);
  for (Quaternion& frame : frames) frame = testing::renamed(frame, engine);
  return field_of(field.domain().mesh(), std::move(frames));
}

std::vector<Vector3> random_points(int count, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(0.02, 0.98);
  std::vector<Vector3> points;
  for (int k = 0; k < count; ++k) points.push_back({uniform(engine), uniform(engine), uniform(engine)});
  return points;
}

Quaternion bent(const Vector3& p) {
  return from_rotation_vector(
      {0.5 * std::sin(p[1] + 2 * p[2]), 0.4 * p[0] * p[0], 0.5 * std::cos(p[0] - p[1])});
}

TEST(TetStreamlines, OfAConstantFieldAreStraightAndEndExactlyOnTheBoundary) {
  const Quaternion frame = from_rotation_vector({0.4, -0.7, 0.5});
  const TetFrameField field = renamed(field_of(unit_cube(6, 0.25), [&](const Vector3&) { return frame; }), 6);
  const auto seeds = random_points(60, 7);
  const Streamlines result = StreamlineTracer(field).trace(seeds);
  ASSERT_EQ(result.lines.size(), 180u);
  for (std::size_t k = 0; k < result.lines.size(); ++k) {
    const Streamline& line = result.lines[k];
    EXPECT_EQ(line.seed, k / 3);
    EXPECT_EQ(line.axis, static_cast<int>(k % 3));
    EXPECT_EQ(line.points[line.seed_point], seeds[line.seed]);
    EXPECT_EQ(line.first_end, StreamlineEnd::kBoundary);
    EXPECT_EQ(line.last_end, StreamlineEnd::kBoundary);
    EXPECT_LT(distance_to_faces(line.points.front()), 1e-12);
    EXPECT_LT(distance_to_faces(line.points.back()), 1e-12);
    const Vector3 axis = axes_of(frame)[static_cast<std::size_t>(line.axis)];
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      EXPECT_LT(norm(cross(line.points[i] - seeds[line.seed], axis)), 1e-9);
      EXPECT_LT(norm(line.tangents[i] - axis), 1e-9);
    }
  }
}

TEST(TetStreamlines, AroundAnAxisAreCircles) {
  constexpr std::uint32_t kAcross = 32;
  constexpr double kCell = 2.0 / kAcross;
  const TetFrameField field = field_of(tet_cylinder(kAcross), [](const Vector3& p) {
    return from_rotation_vector({0, 0, std::atan2(p[1], p[0])});
  });
  StreamlineTuning tuning;
  tuning.closing_cells = 0.2;
  std::vector<Vector3> seeds;
  for (int k = 0; k < 8; ++k) {
    const double angle = 0.3 * k, radius = 0.4 + 0.05 * k;
    seeds.push_back({radius * std::cos(angle), radius * std::sin(angle), -0.8 + 0.2 * k});
  }
  std::size_t closed = 0;
  for (const Streamline& line : TunedTracer(field, {}, tuning).trace(seeds).lines) {
    if (line.last_end != StreamlineEnd::kClosed) continue;
    ++closed;
    const Vector3& seed = seeds[line.seed];
    for (const Vector3& p : line.points) {
      // Frames between vertices turn linearly, which bends lines by a part of a cell.
      EXPECT_NEAR(std::hypot(p[0], p[1]), std::hypot(seed[0], seed[1]), 0.15 * kCell);
      EXPECT_NEAR(p[2], seed[2], 1e-6);
    }
  }
  EXPECT_EQ(closed, seeds.size());
}

struct QuarterField {
  static constexpr std::uint32_t kCells = 14;
  testing::QuarterLine line{{0.51, 0.48, 0.5}, normalised(Vector3{0.2, -0.3, 1})};
  TetFrameField field = field_of(unit_cube(kCells), line);
  SingularEdges edges = singular_tet_edges(field.domain().data().solid, field.data().tet_frames);

  /// The mean edge of each tet, all of which are alike.
  static double cell() { return (3 + 2 * std::numbers::sqrt2 + std::numbers::sqrt3) / 6 / kCells; }

  double cells_to_edges(const Vector3& p) const {
    double least = INFINITY;
    for (const SingularEdge& edge : edges.edges) {
      const Vector3 &a = edges.points[edge.ends[0]].place, &b = edges.points[edge.ends[1]].place;
      const double share = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
      least = std::min(least, norm(p - (a + share * (b - a))) / cell());
    }
    return least;
  }
};

TEST(TetStreamlines, EndAtASingularLineOrPassItWithoutComingNearer) {
  const QuarterField made;
  testing::expect_ends_on_the_cube_or_at_edges(
      StreamlineTracer(made.field).trace(random_points(150, 3)).lines,
      [&](const Vector3& p) { return made.cells_to_edges(p); });
}

TEST(TetStreamlines, DoNotCareHowVerticesNameTheirAxes) {
  const TetFrameField field = field_of(unit_cube(8, 0.2), bent);
  const auto seeds = random_points(40, 8);
  const Streamlines lines = StreamlineTracer(field).trace(seeds),
                    others = StreamlineTracer(renamed(field, 9)).trace(seeds);
  ASSERT_EQ(lines.lines.size(), 120u);
  ASSERT_EQ(others.lines.size(), lines.lines.size());
  for (std::size_t k = 0; k < lines.lines.size(); ++k) {
    const Streamline &line = lines.lines[k], &other = others.lines[k];
    EXPECT_EQ(line.axis, other.axis);
    EXPECT_EQ(line.last_end, other.last_end);
    EXPECT_LT(norm(line.points.front() - other.points.front()), 1e-6);
    EXPECT_LT(norm(line.points.back() - other.points.back()), 1e-6);
  }
}

TEST(TetStreamlines, TurnWithThePart) {
  const TetFrameField field = field_of(unit_cube(8, 0.2), bent);
  const Quaternion turn = from_rotation_vector({0.3, 1.1, -0.6});
  TetMesh mesh = field.domain().mesh();
  for (Vector3& p : mesh.vertices) p = rotate(turn, p);
  std::vector<Quaternion> frames;
  for (const Quaternion& frame : field.data().vertex_frames) frames.push_back(turn * frame);
  auto seeds = random_points(40, 8);
  const Streamlines lines = StreamlineTracer(field).trace(seeds);
  for (Vector3& seed : seeds) seed = rotate(turn, seed);
  const Streamlines others = StreamlineTracer(field_of(mesh, frames)).trace(seeds);
  ASSERT_EQ(others.lines.size(), lines.lines.size());
  for (std::size_t k = 0; k < lines.lines.size(); k += 3) {
    // Axes have other names, and lines may run the other way.
    for (std::size_t i = k; i < k + 3; ++i) {
      double least = INFINITY;
      const Vector3 a = rotate(turn, lines.lines[i].points.front()),
                    b = rotate(turn, lines.lines[i].points.back());
      for (std::size_t j = k; j < k + 3; ++j) {
        const Vector3 &c = others.lines[j].points.front(), &d = others.lines[j].points.back();
        least = std::min({least, norm(a - c) + norm(b - d), norm(a - d) + norm(b - c)});
      }
      EXPECT_LT(least, 1e-6);
    }
  }
}

TEST(TetStreamlines, AgreeWithThoseOnAGrid) {
  const TetFrameField on_tets = field_of(unit_cube(20), bent);
  auto data = std::make_shared<FieldData>();
  data->tree = testing::uniform_octree(4);
  data->open_faces = testing::all_open(data->tree);
  data->frames = testing::frames_of(data->tree, bent);
  data->on_boundary.assign(data->tree.size(), 0);
  const auto seeds = random_points(40, 5);
  const Streamlines tets = StreamlineTracer(on_tets).trace(seeds),
                    grid = StreamlineTracer(FrameField(data)).trace(seeds);
  ASSERT_EQ(tets.lines.size(), grid.lines.size());
  for (std::size_t k = 0; k < tets.lines.size(); ++k) {
    const Streamline &a = tets.lines[k], &b = grid.lines[k];
    EXPECT_EQ(a.axis, b.axis);
    EXPECT_EQ(a.last_end, b.last_end);
    EXPECT_LT(norm(a.points.front() - b.points.front()), 5e-3);
    EXPECT_LT(norm(a.points.back() - b.points.back()), 5e-3);
  }
}

TEST(TetStreamlines, AreTheSameToTheBitForAnyNumberOfThreads) {
  const QuarterField made;
  StreamlineOptions options;
  options.spacing_sides = 0.05;
  const auto traced = [&](int threads) {
    const ThreadLimit limit(threads);
    const StreamlineTracer tracer(made.field, options);
    return tracer.trace(tracer.spread_seeds(200)).lines;
  };
  const auto one = traced(1), many = traced(4);
  ASSERT_EQ(one.size(), many.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].points, many[k].points);
    EXPECT_EQ(one[k].seed, many[k].seed);
    EXPECT_EQ(one[k].axis, many[k].axis);
  }
}

TEST(TetStreamlines, SeedsAreSpreadEvenlyInTheTets) {
  const StreamlineTracer tracer(field_of(unit_cube(5, 0.2), bent));
  const auto few = tracer.spread_seeds(100), many = tracer.spread_seeds(1000);
  ASSERT_EQ(many.size(), 1000u);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  for (int octant = 0; octant < 8; ++octant) {
    const auto inside = std::ranges::count_if(many, [&](const Vector3& p) {
      return (p[0] > 0.5) == (octant & 1) && (p[1] > 0.5) == (octant >> 1 & 1) &&
             (p[2] > 0.5) == (octant >> 2);
    });
    EXPECT_NEAR(static_cast<double>(inside), 125, 8);
  }
}

}  // namespace
}  // namespace crossgrain
