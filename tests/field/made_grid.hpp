// SPDX-License-Identifier: Apache-2.0
// Octrees and fields by formula for the tests of singularities. The root is the unit cube.
#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "base/quaternion.hpp"
#include "field/tet_finish.hpp"
#include "grid/octree.hpp"
#include "grid/test_solid.hpp"

namespace crossgrain::testing {

inline Octree octree_of(std::vector<CellAddress> leaves) {
  return Octree({{0, 0, 0}, 1}, std::move(leaves));
}

/// Splits the leaves that `wanted` says, and those that balance demands.
inline Octree split_where(const Octree& tree, const std::function<bool(CellIndex)>& wanted) {
  std::vector<bool> marked(tree.size());
  for (CellIndex i = 0; i < tree.size(); ++i) marked[i] = wanted(i);
  testing::balance_marks(tree, marked);
  std::vector<CellAddress> leaves;
  for (CellIndex i = 0; i < tree.size(); ++i) {
    if (!marked[i]) leaves.push_back(tree[i]);
    for (int octant = 0; marked[i] && octant < 8; ++octant) leaves.push_back(tree[i].child(octant));
  }
  return octree_of(std::move(leaves));
}

inline Octree uniform_octree(int depth) {
  Octree tree = octree_of({CellAddress::root()});
  for (int d = 0; d < depth; ++d) tree = split_where(tree, [](CellIndex) { return true; });
  return tree;
}

/// Leaves of three sizes, mixed at random.
inline Octree graded_octree(unsigned seed) {
  std::mt19937 engine(seed);
  Octree tree = uniform_octree(2);
  for (int round = 0; round < 2; ++round) {
    tree = split_where(tree, [&](CellIndex) { return engine() % 10 == 0; });
  }
  return tree;
}

/// Every face open, each said by the leaf that owns it as in LeafConnections.
inline std::vector<std::uint8_t> all_open(const Octree& tree) {
  std::vector<std::uint8_t> open_faces(tree.size(), 0);
  for (CellIndex i = 0; i < tree.size(); ++i) {
    for (int face = 0; face < kFaceCount; ++face) {
      const CellIndex j = tree.neighbour(i, face);
      if (j == kNoCell || (tree[j].depth() == tree[i].depth() && face_sign(face) < 0)) continue;
      open_faces[i] = static_cast<std::uint8_t>(open_faces[i] | 1u << face);
    }
  }
  return open_faces;
}

inline std::vector<StoredQuaternion> frames_of(const Octree& tree,
                                               const std::function<Quaternion(const Vector3&)>& at) {
  std::vector<StoredQuaternion> frames;
  for (CellIndex i = 0; i < tree.size(); ++i) frames.push_back(to_stored(at(tree.centre(i))));
  return frames;
}

/// A straight line around which frames turn by a quarter: exp(phi / 4 about the line), phi the angle about
/// it, applied to a frame with an axis along the line. It is singular on the line and nowhere else.
struct QuarterLine {
  Vector3 point;
  Vector3 direction;  ///< unit vector

  double angle_rad(const Vector3& p) const {
    const Vector3 u = orthogonal_unit(direction), v = cross(direction, u);
    return std::atan2(dot(p - point, v), dot(p - point, u));
  }
  Quaternion operator()(const Vector3& p) const {
    return from_rotation_vector(angle_rad(p) / 4 * direction) * with_axis_along({}, direction);
  }
};

/// A straight line around which frames turn `turns` times about an axis of theirs that need not be along it.
/// With a quarter and a half, either way, it is singular on the line and nowhere else.
struct TurningLine {
  Vector3 point;
  Vector3 direction;  ///< unit vector
  Vector3 axis;       ///< unit vector
  double turns;

  double turn_rad(const Vector3& p) const { return turns * QuarterLine{point, direction}.angle_rad(p); }
  Quaternion operator()(const Vector3& p) const {
    return from_rotation_vector(turn_rad(p) * axis) * with_axis_along({}, axis);
  }
};

}  // namespace crossgrain::testing
