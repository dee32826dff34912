// SPDX-License-Identifier: Apache-2.0
// A tree of bounding boxes over the triangles of a surface.
//
// Nodes lie in one array in depth-first order, so a walk needs no stack where the order of visits does not
// matter:
//
//   index      0       1      2      3     4     5 = end
//   node       root    A      A.l    A.r   B
//   skip       5       4      3      4     5       the node after the subtree
//   children   1, 4    2, 3   leaf   leaf  leaf    the first child is index + 1, the second is that child's
//   skip
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "surface/surface.hpp"

namespace crossgrain {

/// A point where a ray meets the surface: origin + t * direction.
struct RayHit {
  double t;
  std::uint32_t triangle;
};

/// The point of the surface nearest to a given point.
struct NearestPoint {
  double squared_distance;
  std::uint32_t triangle;
  Vector3 point;
};

/// Bounding volume hierarchy by binned surface area heuristic (Wald 2007). Refers to the surface, which must
/// outlive it and not move. All queries are thread-safe; the tree does not depend on the number of threads.
class TriangleBvh {
 public:
  /// A node holds the triangles triangle_order()[first, first + count); it is a leaf if skip is its own index
  /// + 1.
  struct Node {
    Box box;
    std::uint32_t skip;
    std::uint32_t first;
    std::uint32_t count;
  };
  static_assert(sizeof(Node) <= 64);

  explicit TriangleBvh(const Surface& surface);

  /// Returns the hit with the smallest t in [t_min, t_max]; among equal t, that of the triangle with the
  /// lowest index. `direction` may have any length; t is in units of it. Watertight (Woop et al. 2013, JCGT
  /// 2(1)): no ray passes between two triangles that share an edge. Triangles are hit from both sides, except
  /// by a ray within their plane.
  std::optional<RayHit> first_hit(const Vector3& origin, const Vector3& direction, double t_min,
                                  double t_max) const;

  /// Returns the point of the surface nearest to p; among equally near triangles, that of the lowest index.
  NearestPoint nearest(const Vector3& p) const;

  const Surface& surface() const { return *surface_; }
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<std::uint32_t>& triangle_order() const { return triangle_order_; }

 private:
  const Surface* surface_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> triangle_order_;
};

/// Returns the point of a triangle nearest to p.
Vector3 nearest_on_triangle(const std::array<Vector3, 3>& corners, const Vector3& p);

inline bool boxes_meet(const Box& a, const Box& b) {
  return a.low[0] <= b.high[0] && b.low[0] <= a.high[0] && a.low[1] <= b.high[1] && b.low[1] <= a.high[1] &&
         a.low[2] <= b.high[2] && b.low[2] <= a.high[2];
}

/// Calls visit(triangle) for every triangle in leaves of the tree that intersect the box, until it returns
/// false.
template <class Visit>
void for_each_triangle_near(const TriangleBvh& bvh, const Box& box, const Visit& visit) {
  const auto& nodes = bvh.nodes();
  for (std::uint32_t i = 0; i < nodes.size();) {
    const TriangleBvh::Node& node = nodes[i];
    if (!boxes_meet(node.box, box)) {
      i = node.skip;
      continue;
    }
    const bool is_leaf = node.skip == ++i;
    for (std::uint32_t k = node.first; is_leaf && k < node.first + node.count; ++k) {
      if (!visit(bvh.triangle_order()[k])) return;
    }
  }
}

}  // namespace crossgrain
