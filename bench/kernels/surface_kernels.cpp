// SPDX-License-Identifier: Apache-2.0
// Kernels of the geometry of the surface and of its forms.
#include <benchmark/benchmark.h>

#include <vector>

#include "grid/cell_constraints.hpp"
#include "grid/winding_in_leaf.hpp"
#include "kernels/levels.hpp"
#include "kernels/surface_flops.hpp"
#include "surface/clipping.hpp"

namespace crossgrain::bench {
namespace {

/// Calls visit(leaf) for all leaves that were split and hold surface.
template <class Visit>
void for_each_split_leaf(const PartLevel& part, const Visit& visit) {
  for (CellIndex i = 0; i < part.before.size(); ++i) {
    if (part.marks[i] && part.before.holds_surface(i)) visit(i);
  }
}

/// Bytes of a triangle: its position in the list, three indices and three corners, shared by eight children.
constexpr double kTriangleBytesPerChild =
    (sizeof(SurfacePiece) + 3 * sizeof(std::uint32_t) + 3 * sizeof(Vector3)) / 8.0;

/// Clips the triangles in a leaf to each of its eight children; items are pairs of triangle and child.
void clipping(benchmark::State& state) {
  const PartLevel& part = part_level(Part::kTorus);
  const Octree& tree = part.before.tree;
  for (auto _ : state) {
    double area = 0;
    for_each_split_leaf(part, [&](CellIndex i) {
      for (int octant = 0; octant < 8; ++octant) {
        const Box box = tree.root().box(tree[i].child(octant));
        for (const SurfacePiece& piece : part.before.pieces_of(i))
          area += clip_triangle(part.solid.surface().corners(piece.triangle), box).area;
      }
    });
    benchmark::DoNotOptimize(area);
  }
  const auto [tried, kept] = clipped_pieces(part);
  const double flops = kRejectedClipFlops + kept / tried * (kClipFlops - kRejectedClipFlops);
  report(state, static_cast<std::size_t>(tried), {flops, kTriangleBytesPerChild});
}

PointsByAxis<8> centres_of_children(const Octree& tree, CellIndex i) {
  PointsByAxis<8> centres;
  for (int octant = 0; octant < 8; ++octant) {
    const Vector3 centre = tree.root().centre(tree[i].child(octant));
    for (int axis = 0; axis < 3; ++axis) centres[axis][octant] = centre[axis];
  }
  return centres;
}

/// Tests the triangles in a leaf against the segments from its centre to those of its children, which are
/// known before; items are pairs of triangle and segment.
void crossings(benchmark::State& state) {
  const PartLevel& part = part_level(Part::kTorus);
  const Solid solid = part.solid.solid();
  std::vector<PointsByAxis<8>> ends;
  for_each_split_leaf(part, [&](CellIndex i) { ends.push_back(centres_of_children(part.before.tree, i)); });
  for (auto _ : state) {
    int changes = 0;
    std::size_t leaf = 0;
    for_each_split_leaf(part, [&](CellIndex i) {
      for (const int change : winding_changes(part.before, solid, i, ends[leaf++]).change) changes += change;
    });
    benchmark::DoNotOptimize(changes);
  }
  const double items = clipped_pieces(part).tried;
  const double bytes_of_ends = static_cast<double>(ends.size() * sizeof(ends[0]));
  report(state, static_cast<std::size_t>(items),
         {crossing_flops(8), kTriangleBytesPerChild + bytes_of_ends / items});
}

/// Numbers of visits of a query. Clusters of the tree of boxes represent those of the winding number, each
/// with half the diagonal of its box as its radius.
struct Visits {
  double clusters = 0, far_clusters = 0, near_triangles = 0;
};

void count_visits(const TriangleBvh& bvh, const Vector3& point, Visits& visits) {
  const auto& nodes = bvh.nodes();
  for (std::size_t i = 0; i < nodes.size();) {
    const Vector3 half = 0.5 * (nodes[i].box.high - nodes[i].box.low);
    const Vector3 way = nodes[i].box.low + half - point;
    const bool is_far = norm(way) > WindingNumber::kDefaultBeta * norm(half);
    visits.clusters += 1;
    visits.far_clusters += is_far;
    if (!is_far && nodes[i].skip == i + 1) visits.near_triangles += nodes[i].count;
    i = is_far ? nodes[i].skip : i + 1;
  }
}

/// Winding numbers at the centres of leaves with surface, which visit most of a tree; items are points.
void winding_numbers(benchmark::State& state) {
  const PartLevel& part = part_level(Part::kTorus);
  const Solid solid = part.solid.solid();
  std::vector<Vector3> points;
  Visits visits;
  for (CellIndex i = 0; i < part.before.size(); i += 16) {
    if (!part.before.holds_surface(i)) continue;
    points.push_back(part.before.tree.centre(i));
    count_visits(solid.bvh, points.back(), visits);
  }
  for (auto _ : state) {
    double sum = 0;
    for (const Vector3& point : points) sum += solid.winding.at(point);
    benchmark::DoNotOptimize(sum);
  }
  const double flops = visits.clusters * kClusterFlops + visits.far_clusters * kFarClusterFlops +
                       visits.near_triangles * kNearTriangleFlops;
  // The tree stays in the cache between points, so only the point counts.
  report(state, points.size(), {flops / static_cast<double>(points.size()), sizeof(Vector3)});
}

/// Computes the forms of all leaves with surface; items are pieces.
template <int D>
void cell_forms(benchmark::State& state) {
  const PartLevel& part = part_level(Part::kTorus);
  const Solid solid = part.solid.solid();
  double forms = 0;
  for (CellIndex i = 0; i < part.level.size(); ++i) forms += part.level.holds_surface(i);
  for (auto _ : state) {
    double weight = 0;
    for (CellIndex i = 0; i < part.level.size(); ++i) {
      if (part.level.holds_surface(i)) weight += cell_form<D>(part.level, solid, i).weight;
    }
    benchmark::DoNotOptimize(weight);
  }
  const std::size_t pieces = part.level.pieces.size();
  const double written = forms * sizeof(QuadraticForm<D>) / static_cast<double>(pieces);
  report(state, pieces, {add_normal_flops<D>(), sizeof(SurfacePiece) + sizeof(Vector3) + written});
}

BENCHMARK(clipping)->Name("clipping of a triangle to a cell")->Unit(benchmark::kMillisecond);
BENCHMARK(crossings)->Name("crossing of a segment and a triangle")->Unit(benchmark::kMillisecond);
BENCHMARK(winding_numbers)->Name("winding number at a point near the surface")->Unit(benchmark::kMillisecond);
BENCHMARK(cell_forms<4>)->Name("normal added to a form, degree 4")->Unit(benchmark::kMillisecond);
BENCHMARK(cell_forms<3>)->Name("normal added to a form, degree 3")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace crossgrain::bench
