// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "display/surface_numbers.hpp"
#include "display/surface_spots.hpp"

namespace crossgrain {

/// The corners of the leaves that hold the surface, as numbers that leaves share.
class CornersOfLeaves {
 public:
  explicit CornersOfLeaves(const FieldData& field);

  /// The leaves that hold the surface, ascending.
  const std::vector<CellIndex>& leaves() const { return leaves_; }

  /// The eight corners of one of them.
  std::span<const std::uint32_t, 8> of(CellIndex leaf) const {
    return std::span<const std::uint32_t, 8>(index_.data() + std::size_t{8} * rows_[leaf], 8);
  }

  /// Number of different corners.
  std::size_t size() const { return size_; }

 private:
  std::vector<CellIndex> leaves_;
  std::vector<std::uint32_t> rows_;   ///< of each leaf of the field among them
  std::vector<std::uint32_t> index_;  ///< of the eight corners of each of them
  std::size_t size_ = 0;
};

/// Means of numbers on the surface at the corners of the leaves that hold it.
class LeafCornerMeans {
 public:
  /// Refers to both.
  LeafCornerMeans(const FieldData& field, const CornersOfLeaves& corners);

  /// Adds the number of a spot at a place to the corners of its leaf, by area and nearness. Ignored in leaves
  /// without surface.
  void add(const SurfaceSpot& spot, const Vector3& place, double number);

  /// The means; a corner without a number has the mean over its leaf, and a leaf without any has 0.
  std::vector<SurfaceNumbers::LeafCorners> result() const;

 private:
  const FieldData& field_;
  const CornersOfLeaves& corners_;
  std::vector<double> sums_, weights_;
};

}  // namespace crossgrain
