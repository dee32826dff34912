// SPDX-License-Identifier: Apache-2.0
#include "singularity/singularity_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "crossgrain/report.hpp"
#include "field/made_grid.hpp"
#include "singularity/singular_edges.hpp"
#include "singularity/smooth_places.hpp"

namespace crossgrain {
namespace {

using testing::all_open;
using testing::frames_of;
using testing::graded_octree;
using testing::TurningLine;
using testing::uniform_octree;

using Graph = SingularityGraph;

constexpr FrameTurn::Kind kQuarter = FrameTurn::Kind::kQuarter, kHalf = FrameTurn::Kind::kHalf;

/// Unit edges along one axis of the grid, around which frames turn about this axis of space.
std::vector<GridEdge> line(GridPoint start, int axis, int count, FrameTurn turn) {
  std::vector<GridEdge> edges;
  for (int k = 0; k < count; ++k) {
    edges.push_back({start, axis, 1, turn});
    ++start[axis];
  }
  return edges;
}

Vector3 unit(int axis, double sign = 1) {
  Vector3 v{0, 0, 0};
  v[axis] = sign;
  return v;
}

std::vector<GridEdge> operator+(std::vector<GridEdge> a, const std::vector<GridEdge>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Of a grid whose smallest possible cells are unit cubes.
SingularEdges singular_of(const std::vector<GridEdge>& edges) {
  return by_end_points(edges, {{0, 0, 0}, std::ldexp(1.0, kMaxDepth)});
}
Graph graph_of(const std::vector<GridEdge>& edges) {
  return singularity_graph(singular_of(edges));
}

std::size_t count_nodes(const Graph& graph, bool on_boundary) {
  return static_cast<std::size_t>(
      std::count_if(graph.nodes.begin(), graph.nodes.end(),
                    [&](const auto& node) { return node.on_boundary == on_boundary; }));
}

/// Arms of ten, twelve and fourteen edges from (50, 50, 50), about which frames turn by a quarter, a quarter
/// and a half.
const std::vector<GridEdge> kTripod = line({40, 50, 50}, 0, 10, {kQuarter, unit(0)}) +
                                      line({50, 50, 50}, 1, 12, {kQuarter, unit(1)}) +
                                      line({50, 50, 50}, 2, 14, {kHalf, unit(2, -1)});

/// A closed way around a square of this side.
std::vector<GridEdge> square(int side) {
  const FrameTurn turn{kQuarter, unit(2)};
  return line({0, 0, 0}, 0, side, turn) + line({side, 0, 0}, 1, side, turn) +
         line({0, side, 0}, 0, side, turn) + line({0, 0, 0}, 1, side, turn);
}

TEST(SingularityGraph, OfNoEdgesIsEmpty) {
  const Graph graph = graph_of({});
  EXPECT_TRUE(graph.arcs.empty() && graph.nodes.empty());
  EXPECT_EQ(graph.edges, 0u);
  EXPECT_EQ(graph.edge_length, 0);
  EXPECT_EQ(graph.verdict(), Verdict::kMeshable);
}

TEST(SingularityGraph, OfALineIsOneArcBetweenTwoEndsOnTheSurface) {
  const Graph graph = graph_of(line({2, 3, 4}, 0, 20, {kQuarter, unit(0)}));
  ASSERT_EQ(graph.arcs.size(), 1u);
  EXPECT_EQ(graph.arcs[0].points.size(), 21u);
  EXPECT_EQ(graph.arcs[0].index, 0.25);
  EXPECT_EQ(graph.arcs[0].type, Graph::ArcType::kRegular);
  EXPECT_NEAR(graph.arcs[0].length, 20, 1e-12);
  EXPECT_EQ(graph.edge_length, 20);
  EXPECT_EQ(count_nodes(graph, true), 2u);
  EXPECT_EQ(count_nodes(graph, false), 0u);
  for (const Vector3& point : graph.arcs[0].points)
    EXPECT_EQ((Vector3{0, point[1], point[2]}), (Vector3{0, 3, 4}));
}

TEST(SingularityGraph, TellsThePlaceHalfWayAlongAnArc) {
  const auto summary = summary_of(graph_of(line({2, 3, 4}, 0, 21, {kQuarter, unit(0)})));
  ASSERT_EQ(summary.arc_list.size(), 1u);
  EXPECT_NEAR(norm(summary.arc_list[0].place - Vector3{12.5, 3, 4}), 0, 1e-12);
}

TEST(SingularityGraph, HasTheSameIndexWhicheverWayEdgesPoint) {
  for (const double sign : {1., -1.}) {
    SingularEdges singular = singular_of(line({0, 0, 0}, 1, 20, {kQuarter, unit(1, sign)}));
    for (std::size_t e = 0; e < singular.edges.size(); e += 2) {
      auto& [ends, turn] = singular.edges[e];
      std::swap(ends[0], ends[1]);
      turn.axis = -1.0 * turn.axis;
    }
    const Graph graph = singularity_graph(singular);
    ASSERT_EQ(graph.arcs.size(), 1u);
    EXPECT_EQ(graph.arcs[0].index, sign / 4);
    EXPECT_EQ(graph.arcs[0].oblique_length, 0);
  }
}

TEST(SingularityGraph, OfALargeSquareIsOneClosedArcWithoutNodes) {
  const Graph graph = graph_of(square(10));
  ASSERT_EQ(graph.arcs.size(), 1u);
  EXPECT_TRUE(graph.arcs[0].is_closed());
  EXPECT_EQ(graph.arcs[0].points.size(), 41u);
  EXPECT_EQ(graph.arcs[0].points.front(), graph.arcs[0].points.back());
  EXPECT_TRUE(graph.nodes.empty());
}

TEST(SingularityGraph, OfTheLoopAroundOneFaceHasNoArcButCountsIt) {
  const Graph graph = graph_of(square(1));
  EXPECT_TRUE(graph.arcs.empty() && graph.nodes.empty());
  EXPECT_EQ(graph.unresolved_loops, 1u);
  EXPECT_EQ(graph.edges, 4u);
}

TEST(SingularityGraph, WhereThreeArcsMeetHasANode) {
  const Graph graph = graph_of(kTripod);
  EXPECT_EQ(graph.arcs.size(), 3u);
  EXPECT_EQ(count_nodes(graph, true), 3u);
  ASSERT_EQ(count_nodes(graph, false), 1u);
  const auto node =
      std::find_if(graph.nodes.begin(), graph.nodes.end(), [](const auto& n) { return !n.on_boundary; });
  EXPECT_EQ(node->arcs, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_LE(norm(node->place - Vector3{50, 50, 50}), kShiftCells + 1e-12);
  EXPECT_EQ(node->verdict, Verdict::kNotMeshable) << "one line of a half turn, two of a quarter";
}

TEST(SingularityGraph, WhereThreeQuarterTurnsMeetAFourthLineReachesTheSurface) {
  std::vector<GridEdge> edges = kTripod;
  for (GridEdge& edge : edges) edge.turn.kind = kQuarter;
  const Graph graph = graph_of(edges);
  EXPECT_EQ(count_nodes(graph, true), 4u);
  EXPECT_EQ(summary_of(graph).nodes, 1u);
  EXPECT_EQ(summary_of(graph).boundary_ends, 4u);
}

TEST(SingularityGraph, TakesNodesOfShortArcsBetweenForOne) {
  // Two lines each way, which share two edges between.
  const FrameTurn turn{kQuarter, unit(2)};
  const auto edges = line({50, 50, 40}, 2, 10, turn) + line({40, 50, 50}, 0, 10, turn) +
                     line({50, 50, 50}, 2, 2, {kHalf, unit(2)}) + line({50, 50, 52}, 2, 10, turn) +
                     line({50, 50, 52}, 0, 10, turn);
  const Graph graph = graph_of(edges);
  EXPECT_EQ(graph.arcs.size(), 4u);
  ASSERT_EQ(count_nodes(graph, false), 1u);
  SingularityTuning exactly;
  exactly.merge_cells = 0;
  const Graph unmerged = singularity_graph(singular_of(edges), exactly);
  EXPECT_EQ(unmerged.arcs.size(), 5u);
  EXPECT_EQ(count_nodes(unmerged, false), 2u);
}

TEST(SingularityGraph, GoesOnThroughABubbleOfTwoShortArcs) {
  const FrameTurn turn{kQuarter, unit(0)};
  const auto edges = line({0, 0, 0}, 0, 10, turn) + line({10, 0, 0}, 0, 1, {kHalf, unit(0)}) +
                     line({10, 0, 0}, 1, 1, turn) + line({10, 1, 0}, 0, 1, turn) +
                     line({11, 0, 0}, 1, 1, turn) + line({11, 0, 0}, 0, 10, turn);
  const Graph graph = graph_of(edges);
  ASSERT_EQ(graph.arcs.size(), 1u);
  EXPECT_EQ(graph.nodes.size(), 2u);
}

TEST(SingularityGraph, OfTetsGoesOnWhereALineTouchesTheSurfaceAndEndsWhereTwoDo) {
  SingularEdges singular = singular_of(line({0, 0, 0}, 0, 20, {kQuarter, unit(0)}));
  singular.points[10].on_boundary = true;
  EXPECT_EQ(singularity_graph(singular).arcs.size(), 1u);
  for (std::size_t e = 10; e < 20; ++e) singular.edges[e].turn.axis = -1.0 * singular.edges[e].turn.axis;
  const Graph graph = singularity_graph(singular);
  EXPECT_EQ(graph.arcs.size(), 2u);
  EXPECT_EQ(count_nodes(graph, true), 3u);
}

TEST(SingularityGraph, OfTetsGoesOnOverAnEdgeOfTheSurfaceWhereTheTurnsAreOne) {
  const FrameTurn turn{kQuarter, unit(0)};
  SingularEdges singular = singular_of(line({0, 0, 0}, 0, 10, turn) + line({11, 0, 0}, 0, 10, turn));
  const auto point_at = [&](double x) {
    std::uint32_t k = 0;
    while (singular.points[k].place[0] != x) ++k;
    return k;
  };
  EXPECT_EQ(singularity_graph(singular).arcs.size(), 2u);
  singular.surface_edges = {{point_at(10), point_at(11)}};
  const Graph graph = singularity_graph(singular);
  ASSERT_EQ(graph.arcs.size(), 1u);
  EXPECT_EQ(graph.arcs[0].index, 0.25);
  EXPECT_EQ(count_nodes(graph, true), 2u);
  // Two lines that run to the surface side by side are two.
  for (std::size_t e = 10; e < 20; ++e) singular.edges[e].turn.axis = -1.0 * singular.edges[e].turn.axis;
  EXPECT_EQ(singularity_graph(singular).arcs.size(), 2u);
}

TEST(SingularityGraph, DoesNotDependOnTheOrderOfEdges) {
  std::vector<GridEdge> edges = kTripod + square(9);
  const Graph one = graph_of(edges);
  std::reverse(edges.begin(), edges.end());
  const Graph other = graph_of(edges);
  ASSERT_EQ(one.arcs.size(), other.arcs.size());
  for (std::size_t a = 0; a < one.arcs.size(); ++a) EXPECT_EQ(one.arcs[a].points, other.arcs[a].points);
}

TEST(SingularityGraph, MakesAStaircaseStraight) {
  std::vector<GridEdge> edges;
  const FrameTurn turn{kQuarter, normalised(Vector3{3, 1, 0})};
  for (int k = 0; k < 20; ++k)
    edges = edges + line({3 * k, k, 0}, 0, 3, turn) + line({3 * k + 3, k, 0}, 1, 1, turn);
  const Graph graph = graph_of(edges);
  ASSERT_EQ(graph.arcs.size(), 1u);
  const auto& points = graph.arcs[0].points;
  const Vector3 direction = normalised(Vector3{3, 1, 0});
  // The staircase is up to 0.95 off on one side only, the line half-way between its corners.
  for (std::size_t k = 10; k + 10 < points.size(); ++k) {
    const Vector3 from_line = points[k] - Vector3{1.5, 0, 0};
    EXPECT_NEAR(norm(from_line - dot(from_line, direction) * direction), 0, 0.06);
  }
  EXPECT_EQ(graph.arcs[0].oblique_length, 0);
}

TEST(SingularityGraph, MovesNoPointFurtherThanItMay) {
  const Graph graph = graph_of(square(10));
  SingularityTuning still;
  still.smoothing_rounds = 0;
  const Graph staircase = singularity_graph(singular_of(square(10)), still);
  double most = 0;
  for (std::size_t k = 0; k < graph.arcs[0].points.size(); ++k)
    most = std::max(most, norm(graph.arcs[0].points[k] - staircase.arcs[0].points[k]));
  EXPECT_LE(most, kShiftCells + 1e-12);
  EXPECT_GT(most, 0.5);
}

/// The arcs of a field on a uniform grid of 32 cells a side in the unit cube.
template <class Field>
Graph solved(const Field& field) {
  const Octree tree = uniform_octree(5);
  return singularity_graph(singular_grid_edges(tree, frames_of(tree, field), all_open(tree)));
}

const Vector3 kSlanted = normalised(Vector3{0.3, -0.4, 1});

TEST(SingularityGraph, KnowsIndicesOfEitherSign) {
  for (const double turns : {0.25, -0.25}) {
    const Graph graph = solved(TurningLine{{0.52, 0.47, 0.5}, kSlanted, kSlanted, turns});
    ASSERT_EQ(graph.arcs.size(), 1u) << turns;
    EXPECT_EQ(graph.arcs[0].index, turns);
    EXPECT_EQ(graph.arcs[0].type, Graph::ArcType::kRegular);
    EXPECT_EQ(graph.verdict(), Verdict::kMeshable);
  }
}

TEST(SingularityGraph, KnowsThatTwoHexahedraAroundAnEdgeAreTooFew) {
  const Graph six = graph_of(line({0, 0, 0}, 0, 20, {kHalf, unit(0, -1)}));
  EXPECT_EQ(six.arcs[0].index, -0.5);
  EXPECT_EQ(six.verdict(), Verdict::kMeshable);
  const Graph two = graph_of(line({0, 0, 0}, 0, 20, {kHalf, unit(0)}));
  EXPECT_EQ(two.arcs[0].index, 0.5);
  EXPECT_EQ(two.verdict(), Verdict::kNotMeshable);
}

TEST(SingularityGraph, DoesNotDecideAboutAnArcAcrossWhichFramesTurn) {
  const Graph graph = solved(TurningLine{{0.52, 0.47, 0.5}, kSlanted, orthogonal_unit(kSlanted), 0.25});
  ASSERT_EQ(graph.arcs.size(), 1u);
  EXPECT_EQ(graph.arcs[0].type, Graph::ArcType::kRegular);
  EXPECT_EQ(graph.arcs[0].oblique_length, graph.arcs[0].length);
  EXPECT_EQ(graph.verdict(), Verdict::kUndecided);
}

TEST(SingularityGraph, AllowsAnArcOfOneSenseHoweverOblique) {
  for (const double degrees : {50., 65., 75.}) {
    const double tilt = degrees * std::numbers::pi / 180;
    Vector3 axis = std::cos(tilt) * kSlanted;
    axis += std::sin(tilt) * orthogonal_unit(kSlanted);
    const Graph graph = solved(TurningLine{{0.52, 0.47, 0.5}, kSlanted, axis, 0.25});
    ASSERT_EQ(graph.arcs.size(), 1u) << degrees;
    EXPECT_EQ(graph.arcs[0].index, 0.25) << degrees;
    EXPECT_EQ(graph.verdict(), Verdict::kMeshable) << degrees;
    EXPECT_GT(graph.arcs[0].oblique_length, 0.8 * graph.arcs[0].length) << degrees;
  }
}

TEST(SingularityGraph, LeavesOutAStubOfThirdTurnsFromSurfaceToSurface) {
  const FrameTurn third{FrameTurn::Kind::kThird, normalised(Vector3{1, 1, 1})};
  const Graph stub = graph_of(line({0, 0, 0}, 0, 2, third));
  EXPECT_EQ(stub.arcs.size(), 0u);
  EXPECT_EQ(stub.unresolved_stubs, 1u);
  const Graph longer = graph_of(line({0, 0, 0}, 0, 3, third));
  EXPECT_EQ(longer.unresolved_stubs, 0u);
  EXPECT_EQ(longer.verdict(), Verdict::kNotMeshable);
}

TEST(SingularityGraph, LeavesOutALineFromSurfaceToSurfaceInTheFirstCellsAlongOneCrease) {
  const std::vector<std::vector<Vector3>> along{{{-5, 1.2, 0}, {30, 1.2, 0}}};
  const std::vector<std::vector<Vector3>> across{{{2, -20, 0}, {2, 20, 0}}};
  const std::vector<std::vector<Vector3>> halves{{{-5, 1, 0}, {4, 1, 0}}, {{4, 1, 0}, {30, 1, 0}}};
  const auto graph_beside = [](int cells, const std::vector<std::vector<Vector3>>& creases) {
    SingularEdges singular = singular_of(line({0, 0, 0}, 0, cells, {kQuarter, unit(0)}));
    singular.creases = creases;
    return singularity_graph(singular);
  };
  EXPECT_EQ(graph_beside(12, along).arcs.size(), 0u);
  EXPECT_EQ(graph_beside(12, along).crease_hooks, 1u);
  EXPECT_EQ(graph_beside(13, along).arcs.size(), 1u) << "long";
  EXPECT_EQ(graph_beside(8, across).arcs.size(), 1u) << "through a wall";
  EXPECT_EQ(graph_beside(8, halves).arcs.size(), 1u) << "from one crease to the next";
  EXPECT_EQ(graph_beside(2, {{{-5, 2.5, 0}, {30, 2.5, 0}}}).arcs.size(), 0u) << "across a tip";
  EXPECT_EQ(graph_beside(4, {{{-5, 2.5, 0}, {30, 2.5, 0}}}).arcs.size(), 1u);
}

TEST(SingularityGraph, LeavesOutAHookAtTheEndOfAnArcAndKeepsTheArc) {
  // The arc arrives at (10, 0, 0), where a line goes on along a crease and another one to the surface.
  SingularEdges singular =
      singular_of(line({0, 0, 0}, 0, 10, {kQuarter, unit(0)}) + line({10, 0, 0}, 1, 8, {kQuarter, unit(1)}) +
                  line({10, 0, -1}, 2, 1, {kQuarter, unit(2)}));
  const std::vector<std::vector<Vector3>> creases{{{10.5, -9, 0}, {10.5, 9, 0}}};
  singular.creases = creases;
  const Graph graph = singularity_graph(singular);
  EXPECT_EQ(graph.crease_hooks, 1u);
  ASSERT_EQ(graph.arcs.size(), 1u);
  EXPECT_EQ(count_nodes(graph, true), 2u);
}

TEST(SingularityGraph, MergesAShortArcFromANodeToTheSurface) {
  const auto arms = [](int cells) {
    return graph_of(line({0, 0, 0}, 0, 20, {kQuarter, unit(0)}) +
                    line({20, 0, 0}, 1, 20, {kQuarter, unit(1)}) +
                    line({20, 0, -cells}, 2, cells, {kHalf, unit(2)}));
  };
  EXPECT_EQ(arms(4).arcs.size(), 2u);
  EXPECT_EQ(count_nodes(arms(4), false), 0u);
  EXPECT_EQ(arms(5).arcs.size(), 3u);
  EXPECT_EQ(count_nodes(arms(5), false), 1u);
}

TEST(SingularityGraph, CountsWhereAnArcTouchesTheSurface) {
  SingularEdges singular = singular_of(line({0, 0, 0}, 0, 8, {kQuarter, unit(0)}));
  for (SingularEdges::Point& point : singular.points) point.name = 7;
  EXPECT_EQ(singularity_graph(singular).contacts, 0u) << "arcs end there";
  singular.points[4].on_boundary = true;
  const Graph graph = singularity_graph(singular);
  EXPECT_EQ(graph.arcs.size(), 1u);
  EXPECT_EQ(graph.contacts, 2u);
}

TEST(SingularityGraph, JoinsALineThatTouchesTheSurfaceBetweenCells) {
  // The second line begins at `start`, with frames that turn about x in this sense.
  const auto joined = [](GridPoint start, double sign) {
    SingularEdges singular = singular_of(line({0, 0, 0}, 0, 10, {kQuarter, unit(0)}) +
                                         line(start, 0, 10, {kQuarter, unit(0, sign)}));
    const auto at = [&](const Vector3& place) {
      const auto found = std::find_if(singular.points.begin(), singular.points.end(),
                                      [&](const auto& point) { return norm(point.place - place) < 0.1; });
      return static_cast<std::uint32_t>(found - singular.points.begin());
    };
    const Vector3 end{double(start[0]), double(start[1]), double(start[2])};
    singular.surface_edges = {{at({10, 0, 0}), at(end)}};
    return singularity_graph(singular);
  };
  const Graph graph = joined({12, 1, 0}, 1);
  ASSERT_EQ(graph.arcs.size(), 1u);
  EXPECT_EQ(graph.arcs[0].index, 0.25);
  EXPECT_EQ(graph.nodes.size(), 2u);
  EXPECT_EQ(graph.contacts, 1u);
  EXPECT_EQ(joined({12, 1, 0}, -1).arcs.size(), 2u) << "frames turn the other way";
  EXPECT_EQ(joined({12, 2, 0}, 1).arcs.size(), 2u) << "beside the line";
  EXPECT_EQ(joined({14, 0, 0}, 1).arcs.size(), 2u) << "too far";
  EXPECT_EQ(joined({8, 1, 0}, 1).arcs.size(), 2u) << "behind the end";
}

TEST(SingularityGraph, DoesNotJoinTheEndsOfAShortLine) {
  for (const int cells : {1, 2, 3}) {
    SingularEdges singular = singular_of(line({0, 0, 0}, 0, cells, {kQuarter, unit(0)}));
    singular.surface_edges = {{0, static_cast<std::uint32_t>(cells)}};
    EXPECT_EQ(singularity_graph(singular).contacts, 0u) << cells;
  }
}

TEST(SingularityGraph, KnowsAnArcAroundWhichFramesTurnAboutNoAxis) {
  // A third of a turn about the diagonal of a frame whose axes are those of space.
  const Vector3 diagonal = normalised(Vector3{1, 1, 1});
  const TurningLine third{{0.52, 0.47, 0.5}, kSlanted, diagonal, 1 / 3.};
  const auto field = [&](const Vector3& p) { return from_rotation_vector(third.turn_rad(p) * diagonal); };
  const Graph graph = solved(field);
  ASSERT_EQ(graph.arcs.size(), 1u);
  EXPECT_EQ(graph.arcs[0].type, Graph::ArcType::kNoAxis);
  EXPECT_EQ(graph.verdict(), Verdict::kNotMeshable);
}

TEST(SingularityGraph, KnowsAnArcAlongWhichTheIndexChanges) {
  // Up one slope of a bent line and down the other. As seen on the way, frames turn about the same axis of
  // space all along where the index changes, and about opposite ones where it does not. Edges point upwards.
  for (const double sign : {1., -1.}) {
    std::vector<GridEdge> edges;
    const FrameTurn up{kQuarter, unit(2)}, down{kQuarter, unit(2, -sign)},
        down_aside{kQuarter, unit(2, sign)};
    for (int k = 0; k < 10; ++k) {
      edges = edges + line({k, 0, 3 * k}, 2, 3, up) + line({k, 0, 3 * k + 3}, 0, 1, up);
      edges = edges + line({20 - k, 0, 3 * k}, 2, 3, down) + line({19 - k, 0, 3 * k + 3}, 0, 1, down_aside);
    }
    const Graph graph = graph_of(edges);
    ASSERT_EQ(graph.arcs.size(), 1u);
    EXPECT_EQ(graph.arcs[0].type, sign > 0 ? Graph::ArcType::kChanging : Graph::ArcType::kRegular);
    EXPECT_EQ(graph.verdict() == Verdict::kMeshable, sign < 0);
  }
}

TEST(SingularityGraph, OfASlantedLineThroughLeavesOfThreeSizesIsOneArcWithoutNodes) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Octree tree = graded_octree(seed);
    const auto frames = frames_of(tree, TurningLine{{0.52, 0.47, 0.55}, kSlanted, kSlanted, 0.25});
    const Graph graph = singularity_graph(singular_grid_edges(tree, frames, all_open(tree)));
    ASSERT_EQ(graph.arcs.size(), 1u) << "seed " << seed;
    EXPECT_EQ(graph.arcs[0].index, 0.25);
    EXPECT_EQ(count_nodes(graph, false), 0u) << "seed " << seed;
    EXPECT_EQ(count_nodes(graph, true), 2u) << "seed " << seed;
  }
}

TEST(SingularityGraph, SummaryCountsWhatIsWrong) {
  const FrameTurn third{FrameTurn::Kind::kThird, normalised(Vector3{1, 1, 1})};
  const auto summary = summary_of(graph_of(line({0, 0, 0}, 0, 8, third)));
  EXPECT_EQ(summary.verdict, Verdict::kNotMeshable);
  EXPECT_EQ(summary.not_meshable_arcs, 1u);
  EXPECT_EQ(summary.arc_list[0].type, SingularityGraph::ArcType::kNoAxis);
  EXPECT_EQ(summary.arc_list[0].verdict, Verdict::kNotMeshable);
  EXPECT_TRUE(summary.arc_list[0].on_boundary);
  EXPECT_EQ(summary.arc_list[0].nodes, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(summary.node_list[1].arcs, (std::vector<std::uint32_t>{0}));
}

}  // namespace
}  // namespace crossgrain
