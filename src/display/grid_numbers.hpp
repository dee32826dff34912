// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "display/leaf_block.hpp"
#include "display/smooth_corners.hpp"
#include "display/surface_numbers.hpp"
#include "display/surface_spots.hpp"

namespace crossgrain {

class GridNumbers {
 public:
  /// Cuts the surface into pieces of `longest` cells.
  GridNumbers(const ShownField& field, SurfaceNumber number, double longest);

  /// Another number from the same pieces of the surface.
  GridNumbers(const GridNumbers& other, SurfaceNumber number);

  double at(const SurfacePoint& point) const;
  double energy_at(const Vector3& place) const;
  std::vector<SurfaceNumbers::Sample> samples() const;
  std::vector<SurfaceNumbers::LeafCorners> at_leaf_corners(const CornersOfLeaves& corners) const;

 private:
  /// The surface in a leaf that faces about the same way.
  struct Facet {
    Vector3 normal;  ///< unit
    double area;
    double angle_deg;  ///< to the nearest axis of the interpolated frame at its middle
  };

  LeafBlock block_at(const Vector3& place) const;
  double energy_of(const LeafBlock& block) const;
  double alignment_of(const LeafBlock& block, const Vector3& normal) const;
  Vector3 smooth_normal(const SurfacePoint& point) const;
  Vector3 flat_normal(const SurfaceSpot& spot) const;
  void prepare();
  void weigh_leaves();
  void measure_facets();
  template <class Visit>
  void for_each_facet(CellIndex leaf, std::span<const std::uint32_t> spots, const Visit& visit) const;

  const FieldData& field_;
  const SolvedSurface& surface_;
  SurfaceNumber number_;
  SurfaceLeaves leaves_;
  std::shared_ptr<const CornerNormals> normals_;
  std::shared_ptr<const std::deque<SurfaceSpot>> spots_;

  /// How far each leaf lies in the part, from nearly 0 to 1: those that only dip into it are hardly held by
  /// their neighbours, and their energy is not that of the field.
  std::vector<float> weights_;  ///< for kEnergy

  std::vector<std::uint32_t> facets_begin_;  ///< of each leaf, and the end; for kAlignment
  std::vector<Facet> facets_;
};

}  // namespace crossgrain
