// SPDX-License-Identifier: Apache-2.0
#include "sampling/nearest_leaf.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace crossgrain {
double squared_distance(const Vector3& point, const Box& box) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double off = std::max({0.0, box.low[axis] - point[axis], point[axis] - box.high[axis]});
    sum += off * off;
  }
  return sum;
}

namespace {

class NearestLeafSearch {
 public:
  NearestLeafSearch(const Octree& tree, const Vector3& point,
                    const std::function<bool(CellIndex)>& admissible)
      : tree_(tree), point_(point), admissible_(admissible) {}

  CellIndex best() const { return best_; }

  /// Visits the leaves [first, last), which are in `cell` and need not fill it.
  void visit(CellAddress cell, CellIndex first, CellIndex last) {
    if (first == last) return;
    if (tree_[first] == cell) {
      offer(first);
      return;
    }
    struct Child {
      CellAddress cell;
      CellIndex first, last;
      double squared_distance;
    };
    std::array<Child, 8> children;
    CellIndex begin = first;
    for (int octant = 0; octant < 8; ++octant) {
      const CellAddress child = cell.child(octant);
      const auto& leaves = tree_.leaves();
      const auto end =
          std::partition_point(leaves.begin() + begin, leaves.begin() + last,
                               [&](CellAddress leaf) { return leaf < child || child.contains(leaf); });
      const auto after = static_cast<CellIndex>(end - leaves.begin());
      children[octant] = {child, begin, after, distance_to(child)};
      begin = after;
    }
    std::ranges::stable_sort(children, {}, &Child::squared_distance);
    for (const Child& child : children) {
      if (child.squared_distance <= best_squared_distance_) visit(child.cell, child.first, child.last);
    }
  }

 private:
  double distance_to(CellAddress cell) const { return squared_distance(point_, tree_.root().box(cell)); }

  void offer(CellIndex leaf) {
    const double distance = distance_to(tree_[leaf]);
    if (distance > best_squared_distance_ || (distance == best_squared_distance_ && leaf >= best_)) return;
    if (admissible_ && !admissible_(leaf)) return;
    best_ = leaf;
    best_squared_distance_ = distance;
  }

  const Octree& tree_;
  Vector3 point_;
  const std::function<bool(CellIndex)>& admissible_;
  CellIndex best_ = kNoCell;
  double best_squared_distance_ = std::numeric_limits<double>::infinity();
};

}  // namespace

CellIndex nearest_leaf(const Octree& tree, const Vector3& point) {
  return nearest_leaf(tree, point, {});
}

CellIndex nearest_leaf(const Octree& tree, const Vector3& point,
                       const std::function<bool(CellIndex)>& admissible) {
  NearestLeafSearch search(tree, point, admissible);
  search.visit(CellAddress::root(), 0, static_cast<CellIndex>(tree.size()));
  return search.best();
}

}  // namespace crossgrain
