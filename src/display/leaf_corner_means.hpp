// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "display/surface_numbers.hpp"
#include "display/surface_spots.hpp"

namespace crossgrain {

/// Means of numbers on the surface at the corners of the leaves that hold it. Leaves share their corners.
class LeafCornerMeans {
 public:
  /// Refers to the field.
  explicit LeafCornerMeans(const FieldData& field);

  /// Adds the number of a spot at a place to the corners of its leaf, by area and nearness. Ignored in leaves
  /// without surface.
  void add(const SurfaceSpot& spot, const Vector3& place, double number);

  /// The means; a corner without a number has the mean over its leaf, and a leaf without any has 0.
  std::vector<SurfaceNumbers::LeafCorners> result() const;

 private:
  const FieldData& field_;
  std::vector<CellIndex> leaves_;     ///< those with surface
  std::vector<std::uint32_t> rows_;   ///< of each leaf of the field among them
  std::vector<std::uint32_t> index_;  ///< of the eight corners of each of them
  std::vector<double> sums_, weights_;
};

}  // namespace crossgrain
