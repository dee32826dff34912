// SPDX-License-Identifier: Apache-2.0
#include "sampling/sampling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <random>

#include "base/parallel.hpp"
#include "crossgrain/frame_field.hpp"
#include "field/connected_level.hpp"
#include "field/face_edges.hpp"
#include "field/field_data.hpp"
#include "field/octree_graph.hpp"
#include "grid/test_solid.hpp"
#include "sampling/nearest_leaf.hpp"
#include "singularity/matching.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

/// Single precision in which frames and turns are stored, times the few of them that make a sample.
constexpr double kStorage_rad = 1e-6;

using FrameAt = std::function<Quaternion(const Vector3&)>;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(engine_); }
  Vector3 point(const Box& box) {
    Vector3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = uniform(box.low[axis], box.high[axis]);
    return p;
  }

 private:
  std::mt19937 engine_;
};

/// The misorientation of two frames, whatever their axes are called.
double angle_between_rad(const Quaternion& p, const Quaternion& q) {
  const Quaternion r = conjugate(p) * q;
  const Quaternion rest = r * conjugate(to_quaternion(nearest_cube_rotation(r)));
  return 2 * std::atan2(norm(Vector3{rest.x, rest.y, rest.z}), std::abs(rest.w));
}

/// An octree with frames by formula.
struct MadeField {
  Octree tree;
  std::vector<StoredQuaternion> frames;
  std::vector<std::uint8_t> open_faces;

  Sampler sampler() const { return Sampler(tree, frames, open_faces); }
  void fill(const FrameAt& frame_at) {
    frames.clear();
    for (CellIndex i = 0; i < tree.size(); ++i) frames.push_back(to_stored(frame_at(tree.centre(i))));
  }
};

/// The unit cube in 8 x 8 x 8 cells, of which those in the lower x half are in four 2:1 layers halved again:
/// all faces are open.
MadeField graded_cube(const FrameAt& frame_at) {
  std::vector<CellAddress> leaves;
  const std::function<void(CellAddress)> divide = [&](CellAddress cell) {
    const double low_x = static_cast<double>(cell.corner()[0]) / (1 << kMaxDepth);
    const int depth = low_x < 0.25 ? 4 : low_x < 0.5 || cell.corner()[1] == 0 ? 3 : 2;
    if (cell.depth() >= depth) {
      leaves.push_back(cell);
      return;
    }
    for (int octant = 0; octant < 8; ++octant) divide(cell.child(octant));
  };
  divide(CellAddress::root());
  MadeField field;
  field.tree = Octree({{0, 0, 0}, 1}, std::move(leaves));
  field.open_faces.assign(field.tree.size(), 0x3f);
  field.fill(frame_at);
  return field;
}

Quaternion twist(const Vector3& p) {
  return from_rotation_vector((0.4 * p[0] + 0.7 * p[1] - 0.5 * p[2]) * normalised(Vector3{1, -2, 0.5}));
}

/// Curved: no two turns commute.
Quaternion bent(const Vector3& p) {
  return from_rotation_vector({std::sin(p[1] + 2 * p[2]), 0.5 * p[0] * p[0], std::cos(p[0] - p[1])});
}

/// The largest error of samples at 1000 points of a box.
double worst_error_rad(const MadeField& field, const FrameAt& expected, const Box& box) {
  const Sampler sampler = field.sampler();
  Random random(1);
  double worst = 0;
  for (int k = 0; k < 1000; ++k) {
    const Vector3 p = random.point(box);
    const auto result = sampler.at(p);
    EXPECT_TRUE(result.in_active_cell);
    worst = std::max(worst, angle_between_rad(result.frame, expected(p)));
  }
  return worst;
}

constexpr Box kCube{{0, 0, 0}, {1, 1, 1}};

TEST(Sampler, ReproducesAConstantFieldToStorage) {
  const auto constant = [](const Vector3&) { return from_rotation_vector({0.4, -0.7, 0.5}); };
  EXPECT_LT(worst_error_rad(graded_cube(constant), constant, kCube), kStorage_rad);
}

TEST(Sampler, ReproducesATwistAtAConstantRateUpToThirdOrderAcrossCellsOfAnySizeAndUpToTheSurface) {
  // The angles that are blended lie up to a cell's turn apart, and unevenly, so that the mean of their
  // coefficients is off by the third power of it: here 0.2 rad a cell. Halving the rate is halving the cells.
  const auto fast = [](const Vector3& p) { return twist(p); };
  const auto slow = [](const Vector3& p) { return twist(0.5 * p); };
  const double fast_error = worst_error_rad(graded_cube(fast), fast, kCube);
  const double slow_error = worst_error_rad(graded_cube(slow), slow, kCube);
  EXPECT_LT(fast_error, 3e-4);
  EXPECT_LT(slow_error, fast_error / 7);
}

MadeField even_cube(int depth, const FrameAt& frame_at) {
  std::vector<CellAddress> leaves{CellAddress::root()};
  for (int d = 0; d < depth; ++d) {
    std::vector<CellAddress> finer;
    for (const CellAddress cell : leaves) {
      for (int octant = 0; octant < 8; ++octant) finer.push_back(cell.child(octant));
    }
    leaves = std::move(finer);
  }
  MadeField field;
  field.tree = Octree({{0, 0, 0}, 1}, std::move(leaves));
  field.open_faces.assign(field.tree.size(), 0x3f);
  field.fill(frame_at);
  return field;
}

TEST(Sampler, IsOfSecondOrderOnABentFieldUpToTheSurfaceAndOfThirdInside) {
  // Halving the cells divides the error by four and by eight once they are small; 3 and 6 tell that from the
  // order below.
  EXPECT_GT(
      worst_error_rad(even_cube(3, bent), bent, kCube) / worst_error_rad(even_cube(4, bent), bent, kCube), 3);
  const Box inside{{0.3, 0.3, 0.3}, {0.7, 0.7, 0.7}};
  EXPECT_GT(
      worst_error_rad(even_cube(3, bent), bent, inside) / worst_error_rad(even_cube(4, bent), bent, inside),
      6);
}

TEST(Sampler, IsContinuousAcrossFacesBetweenCellsOfDifferentSizeToo) {
  const MadeField field = graded_cube(bent);
  const Sampler sampler = field.sampler();
  Random random(3);
  // The field turns by less than 4 rad over the cube, so over this distance by less than 4e-9; a jump of
  // linear extensions that are cut off would be of the second order in the cell size, about 1e-3.
  constexpr double kStep = 1e-9;
  double worst = 0;
  for (int k = 0; k < 3000; ++k) {
    const auto i = static_cast<CellIndex>(random.below(static_cast<int>(field.tree.size())));
    const Box box = field.tree.root().box(field.tree[i]);
    Vector3 p = random.point(box);
    const int axis = random.below(3);
    Vector3 q = p;
    p[axis] = box.high[axis] - kStep;
    q[axis] = box.high[axis] + kStep;
    if (q[axis] > 1) continue;
    worst = std::max(worst, angle_between_rad(sampler.at(p).frame, sampler.at(q).frame));
  }
  EXPECT_LT(worst, 1e-7);
}

std::shared_ptr<const FieldData> data_of(const MadeField& made) {
  auto data = std::make_shared<FieldData>();
  data->tree = made.tree;
  data->frames = made.frames;
  data->open_faces = made.open_faces;
  return data;
}

TEST(Sampler, MayBeMadeFromWithinAParallelLoop) {
  // Waiting for each other the threads would hang here, by chance: hence some tries.
  const auto data = data_of(graded_cube(bent));
  const Vector3 p{0.3, 0.4, 0.5};
  const Frame expected = FrameField(data).sample(p).frame;
  for (int attempt = 0; attempt < 20; ++attempt) {
    const FrameField field(data);
    std::vector<Frame> frames(500);
    parallel_for(
        frames.size(), [&](std::size_t i) { frames[i] = field.sample(p).frame; }, 1);
    for (const Frame& frame : frames) ASSERT_EQ(frame.axes, expected.axes);
  }
}

TEST(Sampler, AnswersWithOrthonormalRightHandedAxes) {
  const FrameField field(data_of(graded_cube(bent)));
  Random random(4);
  for (int k = 0; k < 20000; ++k) {
    const auto axes = field.sample(random.point({{-0.2, -0.2, -0.2}, {1.2, 1.2, 1.2}})).frame.axes;
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) ASSERT_NEAR(dot(axes[a], axes[b]), a == b, 1e-15);
    }
    ASSERT_NEAR(dot(cross(axes[0], axes[1]), axes[2]), 1, 1e-14);
  }
}

TEST(Sampler, DoesNotCareHowTheCellsNameTheirAxes) {
  MadeField field = graded_cube(bent);
  MadeField renamed = field;
  Random random(5);
  const std::array<Quaternion, 3> quarter_turns{from_rotation_vector({std::numbers::pi / 2, 0, 0}),
                                                from_rotation_vector({0, std::numbers::pi / 2, 0}),
                                                from_rotation_vector({0, 0, std::numbers::pi / 2})};
  for (StoredQuaternion& frame : renamed.frames) {
    for (int turns = random.below(5); turns > 0; --turns) {
      frame = to_stored(from_stored(frame) * quarter_turns[random.below(3)]);
    }
  }
  const Sampler sampler = field.sampler(), renamed_sampler = renamed.sampler();
  for (int k = 0; k < 1000; ++k) {
    const Vector3 p = random.point({{0, 0, 0}, {1, 1, 1}});
    ASSERT_LT(angle_between_rad(sampler.at(p).frame, renamed_sampler.at(p).frame), kStorage_rad);
  }
}

TEST(Sampler, GoesWithTheManyWhereTheCellOfThePointDisagreesWithAllAround) {
  // Turned by 60 degrees about a diagonal a frame is as far from another as can be, and by symmetry no small
  // turn leads from one nearer to the other: from the cell's own frame Newton's iteration goes nowhere.
  MadeField field = even_cube(2, [](const Vector3&) { return Quaternion{}; });
  const double s = std::numbers::pi / 3 / std::sqrt(3.0);
  const CellIndex odd = field.tree.find_containing(*field.tree.root().locate({0.4, 0.4, 0.4}));
  field.frames[odd] = to_stored(from_rotation_vector({s, s, s}));
  const Sampler sampler = field.sampler();
  const auto at_corner = sampler.at({0.499, 0.499, 0.499});
  EXPECT_EQ(at_corner.leaf, odd);
  EXPECT_LT(angle_between_rad(at_corner.frame, Quaternion{}), kStorage_rad);
  EXPECT_LT(angle_between_rad(sampler.at({0.375, 0.375, 0.375}).frame, from_stored(field.frames[odd])),
            kStorage_rad);
}

struct Model {
  explicit Model(const TriangleMesh& mesh) : surface(prepare_surface(mesh)), bvh(surface), winding(bvh) {}
  Surface surface;
  TriangleBvh bvh;
  WindingNumber winding;
  Solid solid{surface, bvh, winding};
};

TEST(Sampler, KeepsFramesOnTheTwoSidesOfAThinGapApart) {
  // The gap is narrower than a cell, with a layer of cell faces in it: cells of both plates touch there.
  const double cell = 1.0 / 16, gap = 0.95 * cell;
  const Model model(make_plates(gap));
  const auto [root, depth] = frame_around(model.surface.box, cell);
  const GridLevel level = uniform_level(model.solid, root, depth).level;
  const double layer = root.origin[2] + cell * std::round(-root.origin[2] / cell);
  ASSERT_LT(std::abs(layer), gap / 2);
  MadeField field{level.tree, {}, testing::connect_leaves(level, model.solid).open_faces};
  field.fill([&](const Vector3& p) { return from_rotation_vector({0, 0, p[2] > layer ? 0.0 : 0.5}); });
  const CellIndex below = level.tree.find_containing(*root.locate({0, 0, layer - cell / 2}));
  ASSERT_NE(level.tree.neighbour(below, 5), kNoCell);
  const Sampler sampler = field.sampler();
  Random random(7);
  for (int k = 0; k < 1000; ++k) {
    const auto result = sampler.at(random.point({{-0.45, -0.45, -0.2}, {0.45, 0.45, 0.2}}));
    ASSERT_LT(angle_between_rad(result.frame, from_stored(field.frames[result.leaf])), kStorage_rad);
  }
}

TEST(Sampler, OutsideAnswersWithTheFrameOfTheNearestLeafAndSaysSo) {
  const MadeField field = graded_cube(bent);
  const Sampler sampler = field.sampler();
  const auto result = sampler.at({-3, 0.99, 0.01});
  EXPECT_FALSE(result.in_active_cell);
  const CellIndex corner = field.tree.find_containing(*field.tree.root().locate({0.01, 0.99, 0.01}));
  EXPECT_EQ(result.leaf, corner);
  EXPECT_EQ(angle_between_rad(result.frame, from_stored(field.frames[corner])), 0);
}

/// The lowest of the nearest leaves that are admissible, by trying all.
CellIndex nearest_of_all(const Octree& tree, const Vector3& p,
                         const std::function<bool(CellIndex)>& admissible) {
  CellIndex best = kNoCell;
  double best_distance = std::numeric_limits<double>::infinity();
  for (CellIndex i = 0; i < tree.size(); ++i) {
    if (!admissible(i)) continue;
    const Box box = tree.root().box(tree[i]);
    double distance = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double off = p[axis] - std::clamp(p[axis], box.low[axis], box.high[axis]);
      distance += off * off;
    }
    if (distance < best_distance) {
      best_distance = distance;
      best = i;
    }
  }
  return best;
}

Octree octree_around_a_bracket() {
  const Model model(make_bracket(16));
  const auto [root, depth] = frame_around(model.surface.box, 0.1);
  const GridLevel level = uniform_level(model.solid, root, depth).level;
  std::vector<bool> marked(level.size());
  for (CellIndex i = 0; i < level.size(); ++i) marked[i] = level.holds_surface(i);
  return testing::refined(level, model.solid, marked).tree;
}

TEST(NearestLeaf, IsTheOneThatTryingAllOfThemFinds) {
  const Octree tree = octree_around_a_bracket();
  Random random(8);
  for (int k = 0; k < 500; ++k) {
    const double reach = k % 2 ? 1 : 5;
    const Vector3 p = random.point({{-reach, -reach, -reach}, {reach, reach, reach}});
    ASSERT_EQ(nearest_leaf(tree, p), nearest_of_all(tree, p, [](CellIndex) { return true; }));
  }
}

TEST(NearestLeaf, IsTheNearestOfThoseThatAreAdmissible) {
  const Octree tree = octree_around_a_bracket();
  Random random(9);
  for (const double share : {0.5, 0.05, 0.002}) {
    std::vector<bool> chosen(tree.size());
    for (CellIndex i = 0; i < tree.size(); ++i) chosen[i] = random.uniform(0, 1) < share;
    const auto admissible = [&](CellIndex i) { return chosen[i]; };
    for (int k = 0; k < 200; ++k) {
      const double reach = k % 2 ? 0.6 : 5;
      const Vector3 p = random.point({{-reach, -reach, -reach}, {reach, reach, reach}});
      ASSERT_EQ(nearest_leaf(tree, p, admissible), nearest_of_all(tree, p, admissible)) << share;
    }
  }
  EXPECT_EQ(nearest_leaf(tree, {0, 0, 0}, [](CellIndex) { return false; }), kNoCell);
}

TEST(NearestLeaf, OfEquallyNearLeavesIsTheLowest) {
  const MadeField field = graded_cube(twist);
  // In front of a corner that four leaves share.
  const Vector3 p{0.125, 0.5, -1};
  EXPECT_EQ(nearest_leaf(field.tree, p),
            field.tree.find_containing(*field.tree.root().locate({0.12, 0.49, 0.01})));
}

TEST(NearestLeaf, OfAnEmptyTreeIsNone) {
  EXPECT_EQ(nearest_leaf(Octree({{0, 0, 0}, 1}, {}), {0, 0, 0}), kNoCell);
}

TEST(LeafTurn, IsJoinedToWhatTheGraphHasAnEdgeTo) {
  const Model model(make_bracket(16));
  const auto [root, depth] = frame_around(model.surface.box, 0.1);
  GridLevel level = uniform_level(model.solid, root, depth).level;
  std::vector<bool> marked(level.size());
  for (CellIndex i = 0; i < level.size(); ++i) marked[i] = level.holds_surface(i);
  level = testing::refined(level, model.solid, marked);
  const LeafConnections connections = testing::connect_leaves(level, model.solid);
  const std::vector<StoredQuaternion> frames(level.size());
  const LeafField field{level.tree, frames, connections.open_faces};
  std::vector<std::pair<CellIndex, CellIndex>> expected, found;
  for (const WeightedEdge& edge : testing::face_edges(level, connections))
    expected.push_back(std::minmax(edge.first, edge.second));
  for (CellIndex i = 0; i < level.size(); ++i) {
    for (CellIndex j = i + 1; j < level.size(); ++j) {
      if (joined(placed(field, i), placed(field, j))) found.emplace_back(i, j);
    }
  }
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace crossgrain
