// SPDX-License-Identifier: Apache-2.0
// Colours of a part by the numbers, classes or regions of its field.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "crossgrain/picture.hpp"
#include "display/region_sections.hpp"
#include "display/shown_field.hpp"
#include "display/surface_numbers.hpp"
#include "display/surface_spots.hpp"
#include "grid/leaf_finder.hpp"
#include "picture/drawing.hpp"
#include "picture/legend.hpp"

namespace crossgrain {

/// Colours on the surface and on cuts. Refers to the field. Safe to use from any number of threads.
class CellColours {
 public:
  /// Chooses colours and scale. Throws Error(kInput) if the field lacks the array to colour by, and
  /// Error(kUsage) if it is a field on tets and that is an array of grids.
  CellColours(const ShownField& field, const PictureOptions& options);

  bool is_none() const { return what_ == PictureColour::kNone; }

  /// Colour at a point of the surface: numbers are interpolated, a class is that of the cell there, a region
  /// and a face those of the triangle.
  Colour on_surface(const MeshPoint& point) const;

  /// For kFace the number of each triangle of the surface, otherwise empty.
  const std::vector<std::int32_t>& faces() const { return faces_; }

  /// Colour at a point on a cut through a grid, by energy or region, as cells without surface have no other
  /// numbers. None outside: where there is no cell, or in a cell with surface where that, which may have
  /// holes, does not enclose the point.
  std::optional<Colour> on_cut(const Vector3& point, const std::function<bool()>& is_enclosed) const;

  /// Colour of a tet on a cut, by energy or region.
  Colour of_tet(std::uint32_t tet) const;

  /// Legend of the colours; none for kNone.
  std::optional<LegendBlock> legend() const;

  /// The leaf of the grid at a point; kNoCell if there is none.
  CellIndex leaf_at(const Vector3& point) const;

 private:
  void choose_scale(const PictureOptions& options);
  void choose_regions(const PictureOptions& options);
  void choose_faces();
  Colour of_number(double number) const;
  Colour class_at(const MeshPoint& point) const;
  LegendBlock class_legend() const;

  const ShownField& field_;
  LeafFinder finder_;
  PictureColour what_;
  ColourMap map_;
  ColourScale scale_;
  std::optional<double> largest_;           ///< if above the scale
  std::optional<SurfaceNumbers> numbers_;   ///< for kAlignment and kEnergy
  std::vector<std::int32_t> faces_;         ///< for kFace
  std::vector<std::int32_t> regions_;       ///< for kRegion, ascending
  std::optional<RegionSections> sections_;  ///< for kRegion on a cut through a grid
  std::optional<SurfaceLeaves> boundary_;   ///< for kConstraint
};

/// Colour of a part without colours.
inline constexpr Colour kPlainPart = colour_of(0xa9b7c6);

/// Colour of a cut without colours.
inline constexpr Colour kPlainCut = colour_of(0xe4e9ee);

}  // namespace crossgrain
