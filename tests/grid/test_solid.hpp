// SPDX-License-Identifier: Apache-2.0
// A solid with all that a grid is built from, and brute-force geometry of cells to compare with.
#pragma once

#include <algorithm>
#include <utility>

#include "grid/grid_level.hpp"
#include "surface/topology.hpp"

namespace crossgrain::testing {

/// Owns what a Solid refers to.
class TestSolid {
 public:
  explicit TestSolid(TriangleMesh mesh)
      : closed_(analyse_topology(weld(mesh)).watertight),
        surface_(prepare_surface(std::move(mesh))),
        bvh_(surface_),
        winding_(bvh_) {}
  TestSolid(const TestSolid&) = delete;
  TestSolid& operator=(const TestSolid&) = delete;

  Solid solid() const { return {surface_, bvh_, winding_, closed_}; }
  const Surface& surface() const { return surface_; }
  const WindingNumber& winding() const { return winding_; }

  double area() const {
    double sum = 0;
    for (const double area : surface_.areas) sum += area;
    return sum;
  }

  /// The uniform level of cells of `cell_size`.
  GridLevel level(double cell_size) const {
    const GridFrame frame = frame_around(surface_.box, cell_size);
    return uniform_level(solid(), frame.root, frame.finest_depth).level;
  }

 private:
  bool closed_;
  Surface surface_;
  TriangleBvh bvh_;
  WindingNumber winding_;
};

/// The face of `a` beyond which `b` lies, if the two share a piece of face; -1 otherwise. From the corners
/// alone.
inline int touching_face(CellAddress a, CellAddress b) {
  const GridPoint low_a = a.corner(), low_b = b.corner();
  int found = -1, overlapping = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int high_a = low_a[axis] + a.width(), high_b = low_b[axis] + b.width();
    if (high_a == low_b[axis]) found = 2 * axis + 1;
    if (high_b == low_a[axis]) found = 2 * axis;
    overlapping += std::max(low_a[axis], low_b[axis]) < std::min(high_a, high_b);
  }
  return overlapping == 2 ? found : -1;
}

inline void balance_marks(const Octree& tree, std::vector<bool>& marked) {
  crossgrain::balance_marks(tree, face_neighbours(tree), marked);
}

/// The level refined, its neighbours looked up anew.
inline GridLevel refined(const GridLevel& level, const Solid& solid, std::vector<bool> marked) {
  return crossgrain::refined(level, face_neighbours(level.tree), solid, std::move(marked)).level;
}

/// The tree with marked leaves split into eight.
inline Octree split(const Octree& tree, const std::vector<bool>& marked) {
  std::vector<CellAddress> leaves;
  for (CellIndex i = 0; i < tree.size(); ++i) {
    if (!marked[i]) leaves.push_back(tree[i]);
    for (int octant = 0; marked[i] && octant < 8; ++octant) leaves.push_back(tree[i].child(octant));
  }
  return {tree.root(), std::move(leaves)};
}

/// A level of cells that are all inside and hold no surface.
inline GridLevel interior_level(Octree tree) {
  GridLevel level;
  level.piece_begin.assign(tree.size() + 1, 0);
  level.centre_winding.assign(tree.size(), 1);
  level.tree = std::move(tree);
  return level;
}

}  // namespace crossgrain::testing
