// SPDX-License-Identifier: Apache-2.0
// Colours of cells by the numbers of a field.
#pragma once

#include <optional>

#include "crossgrain/picture.hpp"
#include "field/field_data.hpp"
#include "grid/leaf_finder.hpp"
#include "picture/drawing.hpp"
#include "picture/legend.hpp"

namespace crossgrain {

/// Colours of cells. Refers to the field. Safe to use from any number of threads.
class CellColours {
 public:
  /// Chooses colours and scale. Throws Error(kInput) if the field lacks the array to colour by.
  CellColours(const FieldData& field, const PictureOptions& options);

  bool is_none() const { return what_ == PictureColour::kNone; }

  /// Colour at a point of the surface: that of the leaf there, sampled slightly inside.
  Colour on_surface(const MeshPoint& point) const;

  /// Colour at a point on a cut: by energy only, as cells without surface have no other number. None outside:
  /// where there is no cell, or in a cell with surface where that, which may have holes, does not enclose the
  /// point.
  std::optional<Colour> on_cut(const Vector3& point, bool is_enclosed) const;

  /// Legend of the colours; none for kNone.
  std::optional<LegendBlock> legend() const;

  /// The leaf at a point; kNoCell if there is none.
  CellIndex leaf_at(const Vector3& point) const;

 private:
  Colour of_leaf(CellIndex leaf) const;
  void choose_scale(const PictureOptions& options);

  const FieldData& field_;
  LeafFinder finder_;
  PictureColour what_;
  double inwards_;  ///< distance by which points are moved from the surface, model units
  ColourMap map_;
  ColourScale scale_;
  bool goes_on_ = false;
};

/// Colour of a part without colours.
inline constexpr Colour kPlainPart = colour_of(0xa9b7c6);

}  // namespace crossgrain
