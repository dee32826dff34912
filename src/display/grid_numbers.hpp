// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "display/leaf_block.hpp"
#include "display/smooth_corners.hpp"
#include "display/surface_numbers.hpp"
#include "display/surface_spots.hpp"

namespace crossgrain {

/// SurfaceNumbers of a field on a grid.
class GridNumbers {
 public:
  GridNumbers(const ShownField& field, SurfaceNumber number);

  double at(const SurfacePoint& point) const;
  double energy_at(const Vector3& place) const;
  std::vector<SurfaceNumbers::Sample> samples() const;
  std::vector<SurfaceNumbers::LeafCorners> at_leaf_corners() const;

 private:
  LeafBlock block_at(const Vector3& place) const;
  double energy_of(const LeafBlock& block) const;
  double alignment_of(const LeafBlock& block, const Vector3& normal) const;
  Vector3 smooth_normal(const SurfacePoint& point) const;
  void weigh_leaves();

  const FieldData& field_;
  const SolvedSurface& surface_;
  SurfaceNumber number_;
  SurfaceLeaves leaves_;
  CornerNormals normals_;
  std::vector<SurfaceSpot> spots_;

  /// How far each leaf lies in the part, from nearly 0 to 1: those that only dip into it are hardly held by
  /// their neighbours, and their energy is not that of the field.
  std::vector<float> weights_;
};

}  // namespace crossgrain
