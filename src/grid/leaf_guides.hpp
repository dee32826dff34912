// SPDX-License-Identifier: Apache-2.0
// The guides (surface/guides.hpp) in each leaf.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "grid/octree.hpp"
#include "surface/guides.hpp"

namespace crossgrain {

/// A constraint that frames in a leaf have an axis along a direction, equal to that of a piece of surface
/// with this normal and area.
struct LeafGuide {
  CellIndex leaf;
  std::array<float, 3> direction;  ///< unit
  float area;                      ///< model units squared

  /// Returns a guide in single precision; `direction` is unit.
  static LeafGuide rounded(CellIndex leaf, const Vector3& direction, double area);

  Vector3 unit_direction() const;
};

/// Finds the guides of a leaf. Only leaves with guides take memory, since few have any.
class LeafGuides {
 public:
  LeafGuides() = default;

  /// Distributes guides among leaves. Parts outside all leaves are ignored. `finest` is the size of the
  /// finest leaves, which may belong to other processes; 0: of those of `tree`.
  LeafGuides(const Octree& tree, const Guides& guides, double finest = 0);

  /// Returns the guides of a leaf: creases, then segments, faces and points, each in the given order.
  std::span<const LeafGuide> of(CellIndex leaf) const {
    if (guides_.empty()) return {};
    return found(leaf);
  }
  bool has(CellIndex leaf) const { return !of(leaf).empty(); }
  const std::vector<LeafGuide>& all() const { return guides_; }

 private:
  std::span<const LeafGuide> found(CellIndex leaf) const;

  std::vector<LeafGuide> guides_;     ///< ordered by leaf
  std::vector<std::uint32_t> begin_;  ///< first guide of each run of 256 leaves, then the number of guides
};

}  // namespace crossgrain
