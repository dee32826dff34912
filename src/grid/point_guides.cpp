// SPDX-License-Identifier: Apache-2.0
#include "grid/point_guides.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "grid/leaf_finder.hpp"

namespace crossgrain {
namespace {

/// Smallest share of a point that a leaf receives; smaller shares would cost as much as large ones.
constexpr double kSmallestShare = 0.1;

/// A point and its share in one of the leaves around it.
struct PlacedPoint {
  CellIndex leaf;
  std::uint32_t point;
  double share;  ///< 1 for the leaf that holds it
};

double largest_weight(const GuidePoint& point) {
  return *std::max_element(point.weights.begin(), point.weights.end());
}

/// Returns the share of a point at a distance of `cells` from the centre of a cell, along one axis.
double share_at(double cells, int reach) {
  return std::clamp(reach - std::abs(cells), 0.0, 1.0);
}

/// Appends the leaves around a point, at positions spaced by the size of its own leaf. A share is the product
/// over the axes, divided by the largest.
void place_point(const Octree& tree, const LeafFinder& finder, const GuidePoint& point, std::uint32_t index,
                 std::vector<PlacedPoint>& placed) {
  const auto address = tree.root().locate(point.place);
  const CellIndex own = address ? finder.containing(*address) : kNoCell;
  if (own == kNoCell) return;
  const Vector3 centre = tree.centre(own);
  const double size = tree.cell_size(own);
  const int reach = point.reach_cells;
  const Vector3 off = (1 / size) * (point.place - centre);
  const double largest = share_at(off[0], reach) * share_at(off[1], reach) * share_at(off[2], reach);
  for (int x = -reach; x <= reach; ++x) {
    for (int y = -reach; y <= reach; ++y) {
      for (int z = -reach; z <= reach; ++z) {
        const double share =
            share_at(off[0] - x, reach) * share_at(off[1] - y, reach) * share_at(off[2] - z, reach) / largest;
        if (share < kSmallestShare) continue;
        const bool is_own = x == 0 && y == 0 && z == 0;
        const auto beside = tree.root().locate(centre + size * Vector3{1.0 * x, 1.0 * y, 1.0 * z});
        const CellIndex leaf = is_own ? own : beside ? finder.containing(*beside) : kNoCell;
        if (leaf != kNoCell) placed.push_back({leaf, index, share});
      }
    }
  }
}

/// Returns the shares of all points, ordered by leaf, then by point.
std::vector<PlacedPoint> placed_points(const Octree& tree, const std::vector<GuidePoint>& points) {
  const LeafFinder finder(tree);
  std::vector<std::vector<PlacedPoint>> runs((points.size() + kParallelGrain - 1) / kParallelGrain);
  parallel_for_chunks(points.size(), kParallelGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      place_point(tree, finder, points[k], static_cast<std::uint32_t>(k), runs[begin / kParallelGrain]);
    }
  });
  std::vector<PlacedPoint> placed;
  for (const auto& run : runs) placed.insert(placed.end(), run.begin(), run.end());
  std::ranges::stable_sort(placed, {}, &PlacedPoint::leaf);
  return placed;
}

}  // namespace

std::vector<LeafGuide> guides_at_points(const Octree& tree, const std::vector<GuidePoint>& points) {
  std::vector<LeafGuide> guides;
  const std::vector<PlacedPoint> placed = placed_points(tree, points);
  for (auto first = placed.begin(); first != placed.end();) {
    const CellIndex leaf = first->leaf;
    const auto last = std::find_if(first, placed.end(), [&](const PlacedPoint& p) { return p.leaf != leaf; });
    double largest = 0, sum = 0;
    for (auto p = first; p != last; ++p) {
      const double weight = p->share * largest_weight(points[p->point]);
      largest = std::max(largest, weight);
      sum += weight;
    }
    const double cell = tree.cell_size(leaf), area = largest / sum * cell * cell;
    for (auto p = first; p != last; ++p) {
      const GuidePoint& point = points[p->point];
      for (int k = 0; k < 3; ++k) {
        if (point.weights[k] > 0)
          guides.push_back(LeafGuide::rounded(leaf, point.directions[k], p->share * point.weights[k] * area));
      }
    }
    first = last;
  }
  return guides;
}

}  // namespace crossgrain
