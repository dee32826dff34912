// SPDX-License-Identifier: Apache-2.0
#include "sampling/arc_tubes.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "base/ascending.hpp"
#include "base/vector3.hpp"
#include "sampling/tube_entry.hpp"

namespace crossgrain {
namespace {

double distance_to(const GridEdge& edge, const Vector3& point) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double off = point[axis] - edge.start[axis];
    const double beside = axis == edge.axis ? off - std::clamp<double>(off, 0, edge.length) : off;
    sum += beside * beside;
  }
  return std::sqrt(sum);
}

}  // namespace

ArcTubes::ArcTubes(const LeafFinder& finder, std::vector<GridEdge> edges, double radius_cells)
    : edges_(std::move(edges)), radius_cells_(radius_cells) {
  assert(radius_cells >= 0 && radius_cells <= 1);
  for (std::uint32_t k = 0; k < edges_.size(); ++k) enter(finder, k);
  sort_uniquely(at_leaves_);
}

void ArcTubes::enter(const LeafFinder& finder, std::uint32_t edge) {
  // A tube stays within the cells of the edge's length that touch it.
  const GridPoint& start = edges_[edge].start;
  const std::int32_t length = edges_[edge].length;
  const int axis = edges_[edge].axis;
  const int depth = kMaxDepth - std::countr_zero(static_cast<std::uint32_t>(length));
  for (int number = 0; number < 12; ++number) {
    GridPoint corner = start;
    corner[axis] += (number / 4 - 1) * length;
    corner[(axis + 1) % 3] -= (number & 1) * length;
    corner[(axis + 2) % 3] -= (number >> 1 & 1) * length;
    const bool is_in_root = std::ranges::all_of(
        corner, [](std::int32_t x) { return x >= 0 && x < std::int32_t{1} << kMaxDepth; });
    if (!is_in_root) continue;
    const auto [first, last] = finder.over(CellAddress(corner, depth));
    for (CellIndex leaf = first; leaf < last; ++leaf) at_leaves_.push_back({leaf, edge});
  }
}

double ArcTubes::share_to(CellIndex leaf, const Vector3& from, const Vector3& to) const {
  double share = 1;
  for (auto entry = std::lower_bound(at_leaves_.begin(), at_leaves_.end(), AtLeaf{leaf, 0});
       entry != at_leaves_.end() && entry->leaf == leaf; ++entry) {
    share = std::min(share, share_to(edges_[entry->edge], from, to));
  }
  return share;
}

double ArcTubes::share_to(const GridEdge& edge, const Vector3& from, const Vector3& to) const {
  return tube_entry([&](double share) { return distance_to(edge, from + share * (to - from)); },
                    radius_cells_ * edge.length);
}

}  // namespace crossgrain
