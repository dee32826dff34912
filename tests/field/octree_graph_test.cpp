// SPDX-License-Identifier: Apache-2.0
#include "field/octree_graph.hpp"

#include <gtest/gtest.h>

#include <map>

#include "constraint/normal_form.hpp"
#include "field/connected_level.hpp"
#include "field/energy.hpp"
#include "field/face_edges.hpp"
#include "field/leaf_stencil.hpp"
#include "field/solve_tuning.hpp"
#include "grid/refinement.hpp"
#include "grid/test_solid.hpp"
#include "harmonics/random_samples.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::connect_leaves;
using testing::connectivity_of;
using testing::face_edges;
using testing::interior_level;
using testing::RandomSamples;
using testing::refined;
using testing::TestSolid;
using testing::touching_face;

/// A balanced octree that fills its root cube, random leaves of the unit cube refined `rounds` times.
Octree random_complete_octree(RandomSamples& random, int rounds) {
  Octree tree({{0, 0, 0}, 1}, {CellAddress::root()});
  for (int round = 0; round < rounds; ++round) {
    std::vector<bool> marks(tree.size());
    for (std::size_t i = 0; i < marks.size(); ++i) marks[i] = round < 2 || random.uniform(0, 1) < 0.2;
    testing::balance_marks(tree, marks);
    tree = testing::split(tree, marks);
  }
  return tree;
}

/// No leaf of the trees above holds surface, so the solid is never looked at.
const TestSolid& any_solid() {
  static const TestSolid solid(make_box({1, 1, 1}));
  return solid;
}

/// The volume over which edges along an axis measure a gradient: the tree less half a cell at either end.
double measured_volume(const Octree& tree, int axis) {
  double volume = 1;
  for (CellIndex i = 0; i < tree.size(); ++i) {
    const double size = tree.cell_size(i);
    for (const int face : {2 * axis, 2 * axis + 1})
      if (!adjacent(tree[i], face)) volume -= size * size * size / 2;
  }
  return volume;
}

TEST(OctreeGraph, HasOneEdgeForEveryPairOfLeavesThatShareAFace) {
  RandomSamples random(1);
  for (int trial = 0; trial < 3; ++trial) {
    const GridLevel level = interior_level(random_complete_octree(random, 4));
    const LeafConnections connections = connect_leaves(level, any_solid().solid());
    std::map<std::pair<CellIndex, CellIndex>, int> found;
    for (const WeightedEdge& edge : face_edges(level, connections))
      ++found[std::minmax(edge.first, edge.second)];
    std::size_t pairs = 0;
    for (CellIndex i = 0; i < level.size(); ++i) {
      for (CellIndex j = i + 1; j < level.size(); ++j) {
        const bool touch = touching_face(level.tree[i], level.tree[j]) >= 0;
        ASSERT_EQ(found.count({i, j}), touch ? 1u : 0u);
        if (touch) {
          ASSERT_EQ((found[{i, j}]), 1);
        }
        pairs += touch;
      }
    }
    EXPECT_EQ(face_edges(level, connections).size(), pairs);
    EXPECT_EQ(connections.tied_leaves, 0u);
  }
}

TEST(OctreeGraph, FlagsTheFaceOfEveryEdgeOnTheSmallerLeafOrTheLowerOfTwoEqualOnes) {
  const TestSolid solid(make_bracket(16));
  GridLevel level = solid.level(0.1);
  Marks marks(level.size(), false);
  mark_surface(level, marks);
  level = refined(level, solid.solid(), marks);
  const LeafConnections connections = connect_leaves(level, solid.solid());
  std::map<std::pair<CellIndex, CellIndex>, int> flagged;
  for (CellIndex i = 0; i < level.size(); ++i) {
    for (int face = 0; face < kFaceCount; ++face) {
      if (connections.open_faces[i] >> face & 1) ++flagged[std::minmax(i, level.tree.neighbour(i, face))];
    }
  }
  EXPECT_EQ(flagged.size(), face_edges(level, connections).size());
  for (const WeightedEdge& edge : face_edges(level, connections))
    ASSERT_EQ(flagged.count(std::minmax(edge.first, edge.second)), 1u);
}

TEST(OctreeGraph, WeighsAFaceBetweenEqualLeavesByAreaOverDistance) {
  Octree tree({{0, 0, 0}, 2}, {CellAddress::root()});
  tree = testing::split(tree, {true});
  const GridLevel level = interior_level(tree);
  const LeafConnections connections = connect_leaves(level, any_solid().solid());
  EXPECT_EQ(face_edges(level, connections).size(), 12u);
  for (const WeightedEdge& edge : face_edges(level, connections)) EXPECT_EQ(edge.weight, 1);
}

TEST(OctreeGraph, CostsALinearFunctionWhatTheIntegralSaysAcrossTwoToOneFaces) {
  RandomSamples random(3);
  for (int trial = 0; trial < 8; ++trial) {
    const GridLevel level = interior_level(random_complete_octree(random, 5));
    const LeafConnections connections = connect_leaves(level, any_solid().solid());
    const Vector3 gradient = random.vector();
    double cost = 0, exact = 0;
    std::size_t hanging = 0;
    for (const WeightedEdge& edge : face_edges(level, connections)) {
      const double step = dot(gradient, level.tree.centre(edge.first) - level.tree.centre(edge.second));
      cost += edge.weight / 2 * step * step;
      hanging += level.tree[edge.first].depth() != level.tree[edge.second].depth();
    }
    for (int axis = 0; axis < 3; ++axis)
      exact += gradient[axis] * gradient[axis] / 2 * measured_volume(level.tree, axis);
    EXPECT_GT(hanging, face_edges(level, connections).size() / 5);
    // Weights are stored in single precision.
    EXPECT_NEAR(cost / exact, 1, 1e-6);
  }
}

TEST(OctreeGraph, CostsALinearTwistWhatTheIntegralSaysToThreePercent) {
  RandomSamples random(4);
  double worst = 0;
  for (int trial = 0; trial < 24; ++trial) {
    const GridLevel level = interior_level(random_complete_octree(random, 5));
    const LeafConnections connections = connect_leaves(level, any_solid().solid());
    // A turn about each axis along each direction, then oblique ones; 0.1 rad from cell to cell of the
    // largest.
    Vector3 about{0, 0, 0}, along{0, 0, 0};
    about[trial % 3] = along[trial / 3 % 3] = 1;
    if (trial >= 9) {
      about = random.direction();
      along = random.direction();
    }
    const double rate = 0.1 * 4;
    const Quaternion base = random.rotation();
    std::vector<StoredQuaternion> frames;
    for (CellIndex i = 0; i < level.size(); ++i) {
      const double angle_rad = rate * dot(along, level.tree.centre(i));
      frames.push_back(to_stored(from_rotation_vector(angle_rad * about) * base));
    }
    const Adjacency adjacency = connectivity_of(level, connections, SolverTuning().diagonal_share).adjacency;
    const double cost = level_energy(level, any_solid().solid(), adjacency, frames, 10).parts.smoothness;
    double exact = 0;
    for (int axis = 0; axis < 3; ++axis)
      exact += 10.0 / 3 * std::pow(rate * along[axis], 2) * measured_volume(level.tree, axis);
    worst = std::max(worst, std::abs(cost / exact - 1));
  }
  EXPECT_LT(worst, 0.03);
  RecordProperty("worst_relative_error", std::to_string(worst));
}

template <class Degree>
class BoundaryFormsTest : public ::testing::Test {};
TYPED_TEST_SUITE(BoundaryFormsTest, testing::BothDegrees);

TYPED_TEST(BoundaryFormsTest, AreTheSumsOverThePiecesTimesWeightOverCellSize) {
  constexpr int D = TypeParam::value;
  RandomSamples random(9);
  const TestSolid solid(make_bracket(16));
  GridLevel level = solid.level(0.12);
  Marks marks(level.size());
  for (std::size_t i = 0; i < marks.size(); ++i) marks[i] = random.uniform(0, 1) < 0.5;
  level = refined(level, solid.solid(), marks);
  // A graph without edges has no energy but that of its forms.
  LeafConnections none;
  none.weights.resize(level.size());
  FieldGraph<D> graph{std::make_shared<const Connectivity>(connectivity_of(level, none, 0)),
                      boundary_forms<D>(level, solid.solid(), 10)};
  FieldState<D> state;
  state.frames.resize(level.size());
  double expected = 0;
  int planes = 0, generals = 0;
  for (CellIndex i = 0; i < level.size(); ++i) {
    const Coefficients<D> h = random.coefficients<D>();
    state.coefficients.push_back(to_stored<D>(h));
    planes += graph.forms.plane(i) != nullptr;
    generals += graph.forms.general(i) != nullptr;
    for (const SurfacePiece& piece : level.pieces_of(i)) {
      const auto basis = normal_basis<D>(solid.surface().normals[piece.triangle]);
      expected +=
          (D == 3 ? 5.0 / 3 : 1) * 10 / level.tree.cell_size(i) * piece.area * normal_value<D>(basis, h);
    }
  }
  EXPECT_GT(planes, 100);
  EXPECT_GT(generals, 100);
  EXPECT_NEAR(graph_energy(graph, state) / expected, 1, 1e-6);
}

}  // namespace
}  // namespace crossgrain
