// SPDX-License-Identifier: Apache-2.0
// The guides (surface/guides.hpp) inside each leaf.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "grid/octree.hpp"
#include "surface/guides.hpp"

namespace crossgrain {

/// Frames in a leaf are to have an axis along a direction, as if it were the normal of so much surface.
struct LeafGuide {
  CellIndex leaf;
  std::array<float, 3> direction;  ///< unit
  float area;                      ///< model units squared

  Vector3 unit_direction() const;
};

/// Few leaves have any, so they are found among a list of those that do.
class LeafGuides {
 public:
  LeafGuides() = default;

  /// What lies outside all leaves is passed over.
  LeafGuides(const Octree& tree, const Guides& guides);

  /// Creases first, then segments, faces and points, each in their order.
  std::span<const LeafGuide> of(CellIndex leaf) const {
    if (guides_.empty()) return {};
    return found(leaf);
  }
  bool has(CellIndex leaf) const { return !of(leaf).empty(); }
  const std::vector<LeafGuide>& all() const { return guides_; }

 private:
  std::span<const LeafGuide> found(CellIndex leaf) const;

  std::vector<LeafGuide> guides_;     ///< ordered by leaf
  std::vector<std::uint32_t> begin_;  ///< of every 256th leaf among them, and the end of the last
};

}  // namespace crossgrain
