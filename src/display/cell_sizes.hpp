// SPDX-License-Identifier: Apache-2.0
// Sizes of the cells or tets at places of a field.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vector3.hpp"
#include "display/shown_field.hpp"

namespace crossgrain {

/// Sizes of the cells at the points of singular lines, model units. Refers to the field.
class CellSizes {
 public:
  explicit CellSizes(const ShownField& field);

  /// On tets the mean length of the edges at `vertex`, or of all if that is -1; on a grid the size of the
  /// cell at `place`, or of the smallest cells if there is none.
  double at(const Vector3& place, std::int64_t vertex) const;

 private:
  const ShownField& field_;
  std::vector<double> of_vertices_;  ///< on tets; 0 at unused ones
  double usual_;
};

}  // namespace crossgrain
