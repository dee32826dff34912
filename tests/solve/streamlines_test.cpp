// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/streamlines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>

#include "crossgrain/error.hpp"
#include "crossgrain/solve.hpp"
#include "crossgrain/thread_limit.hpp"
#include "field/field_data.hpp"
#include "field/made_grid.hpp"
#include "sampling/leaf_turn.hpp"
#include "singularity/singular_edges.hpp"
#include "solve/lines_in_cube.hpp"
#include "solve/tuned_tracer.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::distance_to_faces;

using FrameAt = std::function<Quaternion(const Vector3&)>;

FrameField field_of(Octree tree, const FrameAt& frame_at) {
  auto data = std::make_shared<FieldData>();
  data->tree = std::move(tree);
  data->open_faces = testing::all_open(data->tree);
  data->frames = testing::frames_of(data->tree, frame_at);
  data->on_boundary.assign(data->tree.size(), 0);
  return FrameField(data);
}

/// The same field, each cell with another of the 24 names for its axes.
FrameField renamed(const FrameField& field, unsigned seed) {
  auto data = std::make_shared<FieldData>(field.data());
  std::mt19937 engine(seed);
  for (StoredQuaternion& frame : data->frames)
    frame = to_stored(testing::renamed(from_stored(frame), engine));
  return FrameField(data);
}

std::vector<Vector3> random_points(int count, const Box& box, unsigned seed) {
  std::mt19937 engine(seed);
  std::vector<Vector3> points;
  for (int k = 0; k < count; ++k) {
    Vector3 p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = std::uniform_real_distribution<double>(box.low[axis], box.high[axis])(engine);
    points.push_back(p);
  }
  return points;
}

constexpr Box kCube{{0, 0, 0}, {1, 1, 1}};

ErrorKind kind_of_error(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.kind();
  }
  ADD_FAILURE() << "nothing is thrown";
  return ErrorKind::kUsage;
}

TEST(Streamlines, OfAConstantFieldAreStraightAndEndOnTheBoundaryWhateverCellsNameTheirAxes) {
  const Quaternion frame = from_rotation_vector({0.4, -0.7, 0.5});
  const FrameField field =
      renamed(field_of(testing::graded_octree(2), [&](const Vector3&) { return frame; }), 6);
  const auto seeds = random_points(50, kCube, 7);
  const Streamlines result = StreamlineTracer(field).trace(seeds);
  ASSERT_EQ(result.lines.size(), 150u);
  for (std::size_t k = 0; k < result.lines.size(); ++k) {
    const Streamline& line = result.lines[k];
    EXPECT_EQ(line.seed, k / 3);
    EXPECT_EQ(line.axis, static_cast<int>(k % 3));
    EXPECT_EQ(line.points[line.seed_point], seeds[line.seed]);
    EXPECT_EQ(line.first_end, StreamlineEnd::kBoundary);
    EXPECT_EQ(line.last_end, StreamlineEnd::kBoundary);
    EXPECT_LT(distance_to_faces(line.points.front()), 1e-12);
    EXPECT_LT(distance_to_faces(line.points.back()), 1e-12);
    // The frame is within 63 degrees of the coordinate axes, so that these are its own names. Frames are
    // stored in single precision.
    const Vector3 axis = axes_of(frame)[static_cast<std::size_t>(line.axis)];
    ASSERT_EQ(line.tangents.size(), line.points.size());
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      EXPECT_LT(norm(cross(line.points[i] - seeds[line.seed], axis)), 1e-6);
      EXPECT_LT(norm(line.tangents[i] - axis), 1e-6);
    }
    EXPECT_NEAR(line.length, norm(line.points.back() - line.points.front()), 1e-9);
  }
}

/// Frames that turn with the angle about the axis of the cube along z. 32 cells a side.
constexpr double kCell = 1.0 / 32;
FrameField circles() {
  return field_of(testing::uniform_octree(5), [](const Vector3& p) {
    return from_rotation_vector({0, 0, std::atan2(p[1] - 0.5, p[0] - 0.5)});
  });
}

double radius_of(const Vector3& p) {
  return std::hypot(p[0] - 0.5, p[1] - 0.5);
}

/// Whether a line of circles() runs about the middle at its seed.
bool goes_round(const Streamline& line) {
  const Vector3 &place = line.points[line.seed_point], &along = line.tangents[line.seed_point];
  return std::abs((place[0] - 0.5) * along[1] - (place[1] - 0.5) * along[0]) > 0.9 * radius_of(place);
}

TEST(Streamlines, AroundAnAxisAreClosedCirclesThroughTheirSeeds) {
  std::vector<Vector3> seeds;
  // 6 to 14 cells from the middle.
  for (int k = 0; k < 9; ++k) {
    const double angle = 0.2 + 0.04 * k, radius = (6 + k) * kCell;
    seeds.push_back({0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle), 0.3 + 0.05 * k});
  }
  std::size_t around_axis = 0;
  for (const Streamline& line : StreamlineTracer(circles()).trace(seeds).lines) {
    if (!goes_round(line)) continue;
    ++around_axis;
    EXPECT_EQ(line.first_end, StreamlineEnd::kClosed);
    EXPECT_EQ(line.last_end, StreamlineEnd::kClosed);
    EXPECT_EQ(line.points.front(), line.points.back());
    const double radius = radius_of(seeds[line.seed]);
    for (const Vector3& p : line.points) {
      // Of the interpolation too: a hundredth of a cell for frames that turn by a sixth of a radian in one.
      EXPECT_NEAR(radius_of(p), radius, 1e-2 * kCell);
      EXPECT_NEAR(p[2], seeds[line.seed][2], 1e-4 * kCell);
    }
    // Chords of a cell are shorter than their arcs by the share of (cell / radius)^2 / 24, and steps that
    // miss the seed by a hundredth of a cell add a little.
    const double around = 2 * std::numbers::pi * radius, in_cells = radius / kCell;
    EXPECT_LT(line.length, around + 1e-4 * kCell);
    EXPECT_GT(line.length, around * (1 - 1.3 / (24 * in_cells * in_cells)));
  }
  EXPECT_EQ(around_axis, seeds.size());
}

double distance_to(const Streamline& line, const Vector3& p) {
  double least = INFINITY;
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const Vector3 &a = line.points[i - 1], along = line.points[i] - a;
    const double share = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
    least = std::min(least, norm(p - (a + share * along)));
  }
  return least;
}

/// How far, in cells, points of lines of circles() are off at most within 30 cells each way, against steps so
/// small that neither their errors nor the straight pieces between them count.
double error_on_circles(double tolerance) {
  StreamlineTuning tuning;
  tuning.largest_step_cells = 2;
  tuning.closing_cells = 0;
  tuning.longest_sides = 30 * kCell;
  tuning.tolerance = tolerance;
  const std::vector<Vector3> seeds{
      {0.5 + 6.3 * kCell, 0.5, 0.5}, {0.5 + 9.1 * kCell, 0.52, 0.5}, {0.5 + 13.7 * kCell, 0.47, 0.5}};
  const Streamlines lines = TunedTracer(circles(), {}, tuning).trace(seeds);
  tuning.longest_sides = 31 * kCell;
  tuning.tolerance = 1e-8;
  tuning.largest_step_cells = 0.02;
  tuning.smallest_step_cells = 1e-4;
  const Streamlines exact = TunedTracer(circles(), {}, tuning).trace(seeds);
  double worst = 0;
  for (std::size_t k = 0; k < lines.lines.size(); ++k) {
    if (!goes_round(lines.lines[k])) continue;
    // The ends are on the straight piece to where the next point would be.
    for (std::size_t i = 1; i + 1 < lines.lines[k].points.size(); ++i)
      worst = std::max(worst, distance_to(exact.lines[k], lines.lines[k].points[i]) / kCell);
  }
  return worst;
}

TEST(Streamlines, AreOffByLessThanTheToleranceTimesTheirLengthAndInProportionToIt) {
  const std::array tolerances{1e-3, 1e-4, 1e-5};
  std::array<double, 3> errors;
  for (std::size_t k = 0; k < 3; ++k) {
    errors[k] = error_on_circles(tolerances[k]);
    EXPECT_LT(errors[k], 30 * tolerances[k]);
  }
  // Ten times; less a margin for where steps happen to meet the kinks of the interpolated field.
  EXPECT_LT(errors[1], errors[0] / 4);
  EXPECT_LT(errors[2], errors[1] / 4);
}

struct QuarterField {
  testing::QuarterLine line{{0.51, 0.48, 0.5}, normalised(Vector3{0.2, -0.3, 1})};
  FrameField field = field_of(testing::uniform_octree(5), line);
  std::vector<GridEdge> edges =
      singular_edges(field.data().tree, field.data().frames, field.data().open_faces);

  double cells_to_edges(const Vector3& p) const {
    double least = INFINITY;
    for (const GridEdge& edge : edges) {
      const RootCube& root = field.data().tree.root();
      const Vector3 a = root.position(edge.start), b = root.position(edge.end());
      const double share = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
      least = std::min(least, norm(p - (a + share * (b - a))) / kCell);
    }
    return least;
  }
};

TEST(Streamlines, EndAtASingularArcOrPassItWithoutComingNearer) {
  const QuarterField made;
  testing::expect_ends_on_the_cube_or_at_edges(
      StreamlineTracer(made.field).trace(random_points(200, kCube, 3)).lines,
      [&](const Vector3& p) { return made.cells_to_edges(p); });
}

TEST(Streamlines, FollowTheMatchingAroundASingularArc) {
  const QuarterField made;
  const Streamlines result = StreamlineTracer(made.field).trace(random_points(300, kCube, 4));
  const Quaternion base = with_axis_along({}, made.line.direction);
  int gone_round = 0;
  for (const Streamline& line : result.lines) {
    double nearest = INFINITY;
    for (const Vector3& p : line.points) nearest = std::min(nearest, made.cells_to_edges(p));
    // Nearer than that interpolation is off by degrees.
    if (nearest < 2) continue;
    // The angle about the arc grows and falls steadily along the line: one axis is to be its tangent all the
    // way, although the field by its formula jumps by a quarter turn where the angle does.
    double angle = made.line.angle_rad(line.points.front());
    const double first_angle = angle;
    const auto axes_at = [&](double at) {
      return axes_of(from_rotation_vector(at / 4 * made.line.direction) * base);
    };
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (std::abs(dot(axes_at(angle)[k], line.tangents[0])) >
          std::abs(dot(axes_at(angle)[axis], line.tangents[0])))
        axis = k;
    }
    const double sign = dot(axes_at(angle)[axis], line.tangents[0]) < 0 ? -1 : 1;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      angle += std::remainder(made.line.angle_rad(line.points[i]) - angle, 2 * std::numbers::pi);
      ASSERT_GT(sign * dot(axes_at(angle)[axis], line.tangents[i]), std::cos(0.02));
    }
    gone_round += std::abs(angle) > std::numbers::pi || std::abs(first_angle - angle) > std::numbers::pi;
  }
  EXPECT_GT(gone_round, 20);
}

Quaternion bent(const Vector3& p) {
  return from_rotation_vector({std::sin(p[1] + 2 * p[2]), 0.5 * p[0] * p[0], std::cos(p[0] - p[1])});
}

TEST(Streamlines, DoNotCareHowCellsNameTheirAxes) {
  const FrameField field = field_of(testing::graded_octree(3), bent);
  const auto seeds = random_points(40, kCube, 8);
  const Streamlines lines = StreamlineTracer(field).trace(seeds),
                    others = StreamlineTracer(renamed(field, 9)).trace(seeds);
  ASSERT_EQ(lines.lines.size(), 120u);
  ASSERT_EQ(others.lines.size(), lines.lines.size());
  for (std::size_t k = 0; k < lines.lines.size(); ++k) {
    const Streamline &line = lines.lines[k], &other = others.lines[k];
    EXPECT_EQ(line.axis, other.axis);
    EXPECT_EQ(line.first_end, other.first_end);
    EXPECT_EQ(line.last_end, other.last_end);
    EXPECT_LT(norm(line.points.front() - other.points.front()), 1e-4);
    EXPECT_LT(norm(line.points.back() - other.points.back()), 1e-4);
  }
}

const FrameField& bracket_field(const TriangleMesh& mesh) {
  static const FrameField field = [&] {
    SolveOptions options;
    options.resolution = 24;
    return solve(mesh, options);
  }();
  return field;
}

TEST(Streamlines, EndOnTheSurfaceThatIsGivenAndNowhereLeaveIt) {
  const TriangleMesh mesh = make_bracket(32);
  const testing::TestSolid solid(mesh);
  const StreamlineTracer tracer(bracket_field(mesh), {}, &mesh);
  const auto seeds = tracer.spread_seeds(60);
  ASSERT_EQ(seeds.size(), 60u);
  const Streamlines result = tracer.trace(seeds);
  EXPECT_GT(result.lines.size(), 150u);
  std::size_t on_surface = 0;
  const auto expect_on_surface = [&](StreamlineEnd end, const Vector3& p) {
    if (end != StreamlineEnd::kBoundary) return;
    ++on_surface;
    EXPECT_LT(std::sqrt(solid.solid().bvh.nearest(p).squared_distance), 1e-9);
  };
  for (const Streamline& line : result.lines) {
    expect_on_surface(line.first_end, line.points.front());
    expect_on_surface(line.last_end, line.points.back());
    for (std::size_t i = 1; i + 1 < line.points.size(); ++i)
      ASSERT_TRUE(solid.winding().inside(line.points[i]));
  }
  EXPECT_GT(on_surface, 200u);
}

TEST(Streamlines, EndOnTheSurfaceOfTheFieldIfNoneIsGiven) {
  const TriangleMesh mesh = make_bracket(32);
  const FrameField& field = bracket_field(mesh);
  const StreamlineTracer own(field), given(field, {}, &mesh);
  const auto seeds = own.spread_seeds(20);
  const auto ours = own.trace(seeds).lines, theirs = given.trace(seeds).lines;
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t k = 0; k < ours.size(); ++k) EXPECT_EQ(ours[k].points, theirs[k].points);
}

TEST(Streamlines, WithoutASurfaceEndWithTheActiveCells) {
  const TriangleMesh mesh = make_bracket(32);
  const FrameField& field = bracket_field(mesh);
  const auto seeds = StreamlineTracer(field, {}, &mesh).spread_seeds(30);
  auto without_surface = std::make_shared<FieldData>(field.data());
  without_surface->surface = {};
  const Streamlines result = StreamlineTracer(FrameField(without_surface)).trace(seeds);
  const LeafField leaves{field.data().tree, field.data().frames, field.data().open_faces};
  const Octree& tree = leaves.tree;
  const RootCube& root = tree.root();
  std::size_t at_boundary = 0;
  for (const Streamline& line : result.lines) {
    if (line.last_end != StreamlineEnd::kBoundary) continue;
    ++at_boundary;
    // A little further along the line there is no cell any more, or one across a closed face.
    const Vector3 step = 1e-6 * root.size * line.tangents.back();
    const CellIndex last = tree.find_containing(*root.locate(line.points.back() - step));
    const CellIndex beyond = tree.find_containing(*root.locate(line.points.back() + step));
    ASSERT_NE(last, kNoCell);
    EXPECT_NE(last, beyond);
    EXPECT_TRUE(beyond == kNoCell || !joined(placed(leaves, last), placed(leaves, beyond)));
  }
  EXPECT_GT(at_boundary, 50u);
}

TEST(Streamlines, DoNotCrossAGapThatIsThinnerThanACell) {
  const TriangleMesh mesh = make_plates(0.95 / 16);
  SolveOptions options;
  options.resolution = 16;
  const FrameField field = solve(mesh, options);
  const Streamlines result =
      StreamlineTracer(field).trace(random_points(100, {{-0.4, -0.4, -0.4}, {0.4, 0.4, 0.4}}, 5));
  int vertical = 0;
  for (const Streamline& line : result.lines) {
    vertical += line.axis == 2;
    // One plate is 0.4 thick, and its cells reach out by a cell at most.
    EXPECT_LT(std::abs(line.points.back()[2] - line.points.front()[2]), 0.4 + 2.0 / 16);
  }
  EXPECT_GT(vertical, 50);
}

TEST(Streamlines, AreTheSameToTheBitForAnyNumberOfThreads) {
  const QuarterField made;
  const auto seeds = random_points(60, kCube, 11);
  const auto traced = [&](int threads) {
    const ThreadLimit limit(threads);
    return StreamlineTracer(made.field).trace(seeds);
  };
  const Streamlines one = traced(1), many = traced(4);
  ASSERT_EQ(one.lines.size(), many.lines.size());
  for (std::size_t k = 0; k < one.lines.size(); ++k) {
    EXPECT_EQ(one.lines[k].points, many.lines[k].points);
    EXPECT_EQ(one.lines[k].tangents, many.lines[k].tangents);
    EXPECT_EQ(one.lines[k].seed, many.lines[k].seed);
  }
}

TEST(Streamlines, AreNoLongerThanAllowed) {
  StreamlineTuning tuning;
  tuning.longest_sides = 0.25;
  const FrameField field = circles();
  for (const Streamline& line : TunedTracer(field, {}, tuning).trace(random_points(50, kCube, 12)).lines) {
    EXPECT_LT(line.length, 0.5 + 1e-9);
    if (line.first_end == StreamlineEnd::kLongest && line.last_end == StreamlineEnd::kLongest) {
      EXPECT_NEAR(line.length, 0.5, 1e-3);
    }
  }
  tuning = {};
  tuning.most_points = 5;
  for (const Streamline& line : TunedTracer(field, {}, tuning).trace(random_points(50, kCube, 12)).lines)
    EXPECT_LE(line.points.size(), 9u);
}

TEST(Streamlines, SeedsThatAreNowhereAreCountedAndGiveNoLine) {
  const QuarterField made;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const GridEdge& edge = made.edges[made.edges.size() / 2];
  const Vector3 at_arc = made.field.data().tree.root().position(edge.start);
  const Streamlines result =
      StreamlineTracer(made.field)
          .trace(std::vector<Vector3>{
              {1.5, 0.5, 0.5}, {nan, 0, 0}, {INFINITY, 0.5, 0.5}, at_arc, {0.2, 0.2, 0.2}});
  EXPECT_EQ(result.outside_seeds, 3u);
  EXPECT_EQ(result.arc_seeds, 1u);
  ASSERT_EQ(result.lines.size(), 3u);
  for (const Streamline& line : result.lines) EXPECT_EQ(line.seed, 4u);
}

TEST(Streamlines, EndAlsoInAFieldWithoutAnyOrder) {
  std::mt19937 engine(13);
  std::normal_distribution<double> normal;
  const FrameField field = field_of(testing::uniform_octree(3), [&](const Vector3&) {
    return normalised(Quaternion{normal(engine), normal(engine), normal(engine), normal(engine)});
  });
  StreamlineTuning tuning;
  tuning.arc_distance_cells = 0;
  std::array<int, 5> ends{};
  for (const Streamline& line : TunedTracer(field, {}, tuning).trace(random_points(20, kCube, 14)).lines) {
    ++ends[static_cast<std::size_t>(line.first_end)];
    for (const Vector3& p : line.points) {
      for (const double x : p) ASSERT_TRUE(x >= -1e-12 && x <= 1 + 1e-12);
    }
  }
  EXPECT_GT(ends[static_cast<std::size_t>(StreamlineEnd::kAmbiguous)], 0);
}

TEST(Streamlines, SeedsAreSpreadEvenlyAndMoreOfThemBeginWithTheSame) {
  const TriangleMesh mesh = make_bracket(32);
  const testing::TestSolid solid(mesh);
  const StreamlineTracer tracer(bracket_field(mesh), {}, &mesh);
  const auto few = tracer.spread_seeds(100), many = tracer.spread_seeds(2000);
  ASSERT_EQ(many.size(), 2000u);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  for (const Vector3& p : many) ASSERT_TRUE(solid.winding().inside(p));
  EXPECT_EQ(tracer.trace(few).lines.size(), 300u);  // none at an arc

  // In boxes that lie inside, as many as their share of the volume says. Random points would be off by 10 %
  // as often as not.
  const FrameField cube = field_of(testing::uniform_octree(3), bent);
  const auto in_cube = StreamlineTracer(cube).spread_seeds(1000);
  ASSERT_EQ(in_cube.size(), 1000u);
  for (int octant = 0; octant < 8; ++octant) {
    const auto inside = std::ranges::count_if(in_cube, [&](const Vector3& p) {
      return (p[0] > 0.5) == (octant & 1) && (p[1] > 0.5) == (octant >> 1 & 1) &&
             (p[2] > 0.5) == (octant >> 2);
    });
    EXPECT_NEAR(static_cast<double>(inside), 125, 8);
  }
}

TEST(Streamlines, AreCancelledByTheMonitor) {
  Monitor monitor;
  monitor.cancel();
  const StreamlineTracer tracer(circles());
  EXPECT_EQ(kind_of_error([&] { tracer.trace(random_points(5, kCube, 1), monitor); }),
            ErrorKind::kInterrupted);
}

TEST(Streamlines, SpacingsAndSurfacesThatMakeNoSenseAreRefused) {
  const FrameField field = circles();
  for (const double spacing : {-0.1, 1e-5, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    StreamlineOptions options;
    options.spacing_sides = spacing;
    EXPECT_EQ(kind_of_error([&] { const StreamlineTracer tracer(field, options); }), ErrorKind::kUsage);
  }
  const TriangleMesh elsewhere = translate_mesh(make_box({1, 1, 1}), {5, 0, 0});
  EXPECT_EQ(kind_of_error([&] { const StreamlineTracer tracer(field, {}, &elsewhere); }), ErrorKind::kInput);
}

}  // namespace
}  // namespace crossgrain
