// SPDX-License-Identifier: Apache-2.0
#include "singularity/singular_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "base/parallel.hpp"
#include "field/made_grid.hpp"
#include "singularity/matching.hpp"

namespace crossgrain {
namespace {

using testing::all_open;
using testing::frames_of;
using testing::graded_octree;
using testing::octree_of;
using testing::QuarterLine;
using testing::uniform_octree;

/// A segment as long as the smallest leaf: its low end and its axis.
using UnitSegment = std::pair<GridPoint, int>;

std::int32_t smallest_width(const Octree& tree) {
  std::int32_t width = CellAddress::root().width();
  for (const CellAddress leaf : tree.leaves()) width = std::min(width, leaf.width());
  return width;
}

/// The segments that edges consist of; that none lies on another is checked on the way.
std::set<UnitSegment> segments_of(const std::vector<GridEdge>& edges, std::int32_t width) {
  std::set<UnitSegment> segments;
  for (const GridEdge& edge : edges) {
    for (std::int32_t done = 0; done < edge.length; done += width) {
      GridPoint low = edge.start;
      low[edge.axis] += done;
      EXPECT_TRUE(segments.insert({low, edge.axis}).second) << "an edge is reported twice";
    }
  }
  return segments;
}

/// Every segment of the finest grid with the four leaves that lie around it; no octree logic but point
/// location.
class AllSegments {
 public:
  explicit AllSegments(const Octree& tree) : tree_(tree), width_(smallest_width(tree)) {}

  /// turns(ring, axis) for segments with leaves all around; ring runs through the quadrants --, +-, ++, -+ .
  std::set<UnitSegment> where(
      const std::function<bool(const std::array<CellIndex, 4>&, int axis)>& turns) const {
    std::set<UnitSegment> found;
    const std::int32_t end = CellAddress::root().width();
    for (std::int32_t x = 0; x < end; x += width_) {
      for (std::int32_t y = 0; y < end; y += width_) {
        for (std::int32_t z = 0; z < end; z += width_) {
          for (int axis = 0; axis < 3; ++axis) {
            const auto ring = around({x, y, z}, axis);
            if (std::count(ring.begin(), ring.end(), kNoCell) == 0 && turns(ring, axis))
              found.insert({{x, y, z}, axis});
          }
        }
      }
    }
    return found;
  }

 private:
  std::array<CellIndex, 4> around(const GridPoint& low, int axis) const {
    constexpr std::array<std::array<int, 2>, 4> kQuadrants{{{-1, -1}, {0, -1}, {0, 0}, {-1, 0}}};
    std::array<CellIndex, 4> ring;
    for (std::size_t k = 0; k < 4; ++k) {
      GridPoint corner = low;
      corner[(axis + 1) % 3] += kQuadrants[k][0] * width_;
      corner[(axis + 2) % 3] += kQuadrants[k][1] * width_;
      const bool outside = *std::min_element(corner.begin(), corner.end()) < 0;
      ring[k] = outside ? kNoCell : tree_.find_containing(CellAddress(corner, kMaxDepth));
    }
    return ring;
  }

  const Octree& tree_;
  std::int32_t width_;
};

/// The faces through which a ring of AllSegments is walked.
std::array<int, 4> ring_faces(int axis) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  return {2 * u + 1, 2 * v + 1, 2 * u, 2 * v};
}

bool is_open(const Octree& tree, const std::vector<std::uint8_t>& open_faces, CellIndex a, int face,
             CellIndex b) {
  if (a == b) return true;
  const bool said_by_a = open_faces[a] >> face & 1, said_by_b = open_faces[b] >> opposite_face(face) & 1;
  if (tree[a].depth() == tree[b].depth()) return said_by_a || said_by_b;
  return tree[a].depth() > tree[b].depth() ? said_by_a : said_by_b;
}

std::vector<StoredQuaternion> random_frames(std::size_t count, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  std::vector<StoredQuaternion> frames;
  while (frames.size() < count) {
    frames.push_back(
        to_stored(normalised(Quaternion{normal(engine), normal(engine), normal(engine), normal(engine)})));
  }
  return frames;
}

TEST(SingularEdges, OfAConstantFieldAreNone) {
  const Octree tree = graded_octree(1);
  const auto frames = frames_of(tree, [](const Vector3&) { return from_rotation_vector({0.3, 0.2, 0.9}); });
  EXPECT_TRUE(singular_edges(tree, frames, all_open(tree)).empty());
}

TEST(SingularEdges, OfATwistAreNoneThoughNoNamesOfAxesFitBothEnds) {
  const Octree tree = graded_octree(2);
  // 36 degrees from one of the widest leaves to the next, more than 90 from end to end.
  const auto frames = frames_of(tree, [](const Vector3& p) {
    return from_rotation_vector({0, 0, 2.5 * p[2]});
  });
  EXPECT_TRUE(singular_edges(tree, frames, all_open(tree)).empty());
}

TEST(SingularEdges, OfALineAlongTheGridAreTheEdgesWhoseFourCellsSurroundIt) {
  const Octree tree = uniform_octree(3);
  // Between the centres at 3.5 and 4.5 eighths in x, 2.5 and 3.5 in y: around the grid line at (4, 3)
  // eighths.
  const auto frames = frames_of(tree, QuarterLine{{0.53, 0.35, 0}, {0, 0, 1}});
  const auto edges = singular_edges(tree, frames, all_open(tree));
  const std::int32_t eighth = CellAddress::root().width() / 8;
  std::set<UnitSegment> expected;
  for (std::int32_t k = 0; k < 8; ++k) expected.insert({{4 * eighth, 3 * eighth, k * eighth}, 2});
  EXPECT_EQ(segments_of(edges, eighth), expected);
}

TEST(SingularEdges, OfALineAcrossLeavesOfThreeSizesAreThoseWhoseRingOfCentresWindsAroundIt) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Octree tree = graded_octree(seed);
    const QuarterLine line{{0.52, 0.47, 0.55}, normalised(Vector3{0.3, -0.5 + 0.4 * seed, 1})};
    const auto expected = AllSegments(tree).where([&](const std::array<CellIndex, 4>& ring, int) {
      double sum = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        sum += std::remainder(
            line.angle_rad(tree.centre(ring[(k + 1) % 4])) - line.angle_rad(tree.centre(ring[k])),
            2 * std::numbers::pi);
      }
      return std::abs(sum) > 1;
    });
    const auto edges = singular_edges(tree, frames_of(tree, line), all_open(tree));
    EXPECT_GE(expected.size(), 4u);
    EXPECT_EQ(segments_of(edges, smallest_width(tree)), expected) << "seed " << seed;
  }
}

TEST(SingularEdges, OfRandomFramesInARaggedTreeAreThoseOfAnExhaustiveSearch) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    std::mt19937 engine(100 + seed);
    std::vector<CellAddress> leaves = graded_octree(10 + seed).leaves();
    std::erase_if(leaves, [&](CellAddress) { return engine() % 10 == 0; });
    const Octree tree = octree_of(leaves);
    const auto frames = random_frames(tree.size(), seed);
    auto open_faces = all_open(tree);
    for (std::uint8_t& bits : open_faces) {
      if (engine() % 4 == 0) bits = static_cast<std::uint8_t>(bits & engine());
    }
    const auto expected = AllSegments(tree).where([&](const std::array<CellIndex, 4>& ring, int axis) {
      CubeRotation turn;
      for (std::size_t k = 0; k < 4; ++k) {
        const CellIndex a = ring[k], b = ring[(k + 1) % 4];
        if (!is_open(tree, open_faces, a, ring_faces(axis)[k], b)) return false;
        if (a != b) turn = matching(frames[a], frames[b]) * turn;
      }
      return !turn.is_identity();
    });
    EXPECT_GE(expected.size(), 100u);
    EXPECT_EQ(segments_of(singular_edges(tree, frames, open_faces), smallest_width(tree)), expected);
  }
}

TEST(SingularEdges, AreAsLongAsTheSmallestLeafBesideThem) {
  const Octree tree = graded_octree(3);
  std::set<std::int32_t> lengths;
  std::int32_t largest_ratio = 0;
  for (const GridEdge& edge : singular_edges(tree, random_frames(tree.size(), 4), all_open(tree))) {
    std::int32_t narrowest = CellAddress::root().width(), widest = 0;
    for (const int side : {0, 1, 2, 3}) {
      GridPoint near = edge.start;
      near[(edge.axis + 1) % 3] -= side & 1;
      near[(edge.axis + 2) % 3] -= side >> 1;
      const std::int32_t width = tree[tree.find_containing(CellAddress(near, kMaxDepth))].width();
      narrowest = std::min(narrowest, width);
      widest = std::max(widest, width);
    }
    EXPECT_EQ(edge.length, narrowest);
    lengths.insert(edge.length);
    largest_ratio = std::max(largest_ratio, widest / narrowest);
  }
  EXPECT_EQ(lengths.size(), 3u) << "the tree should have edges of three lengths";
  EXPECT_EQ(largest_ratio, 4) << "the tree should have leaves of 4:1 that meet in an edge";
}

TEST(SingularEdges, CancelWhereLeavesAreAllAround) {
  const std::int32_t high = CellAddress::root().width();
  for (unsigned seed = 0; seed < 3; ++seed) {
    const Octree tree = graded_octree(20 + seed);
    std::map<GridPoint, int> degree, odd;
    for (const GridEdge& edge : singular_edges(tree, random_frames(tree.size(), seed), all_open(tree))) {
      ++degree[edge.start];
      ++degree[edge.end()];
      odd[edge.start] += edge.turn.is_odd();
      odd[edge.end()] += edge.turn.is_odd();
    }
    int interior = 0;
    for (const auto& [point, count] : degree) {
      const bool on_boundary =
          std::any_of(point.begin(), point.end(), [&](std::int32_t c) { return c == 0 || c == high; });
      if (on_boundary) continue;
      ++interior;
      EXPECT_GE(count, 2);
      EXPECT_EQ(odd[point] % 2, 0) << "turns that cannot cancel meet where leaves are all around";
    }
    EXPECT_GE(interior, 100);
  }
}

TEST(SingularEdges, DoNotDependOnHowEachCellNamesItsAxes) {
  const Octree tree = graded_octree(5);
  const auto frames = frames_of(tree, QuarterLine{{0.52, 0.47, 0.55}, normalised(Vector3{0.6, -0.3, 1})});
  std::mt19937 engine(6);
  std::vector<CubeRotation> names{CubeRotation{}};
  while (names.size() < 200) {
    names.push_back(names.back() * (engine() % 2 ? CubeRotation{1, 1, 0, 0} : CubeRotation{1, 0, 1, 0}));
  }
  std::vector<StoredQuaternion> renamed;
  for (const StoredQuaternion& frame : frames) {
    renamed.push_back(to_stored(from_stored(frame) * to_quaternion(names[engine() % names.size()])));
  }
  const auto edges = singular_edges(tree, frames, all_open(tree));
  EXPECT_FALSE(edges.empty());
  EXPECT_EQ(singular_edges(tree, renamed, all_open(tree)), edges);
}

TEST(SingularEdges, AroundAFaceThatIsClosedDoNotCount) {
  const Octree tree = uniform_octree(1);
  const auto frames = frames_of(tree, QuarterLine{{0.53, 0.48, 0}, {0, 0, 1}});
  auto open_faces = all_open(tree);
  ASSERT_EQ(singular_edges(tree, frames, open_faces).size(), 2u);
  const CellIndex low_corner = 0, beside = tree.neighbour(low_corner, 1);
  open_faces[low_corner] = static_cast<std::uint8_t>(open_faces[low_corner] & ~2u);
  const auto upper_half_only = singular_edges(tree, frames, open_faces);
  ASSERT_EQ(upper_half_only.size(), 1u);
  EXPECT_EQ(upper_half_only[0].start[2], CellAddress::root().width() / 2);
  open_faces[beside] =
      static_cast<std::uint8_t>(open_faces[beside] | 1u);  // as a leaf with no other face does
  EXPECT_EQ(singular_edges(tree, frames, open_faces).size(), 2u);
}

TEST(SingularEdges, ComeInTheSameOrderForAnyNumberOfThreads) {
  const Octree tree = uniform_octree(4);  // four tasks
  const auto frames = random_frames(tree.size(), 7);
  std::vector<GridEdge> alone;
  {
    const ThreadLimit one(1);
    alone = singular_edges(tree, frames, all_open(tree));
  }
  const ThreadLimit two(2);
  EXPECT_EQ(singular_edges(tree, frames, all_open(tree)), alone);
}

}  // namespace
}  // namespace crossgrain
