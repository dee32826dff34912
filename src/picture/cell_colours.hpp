// SPDX-License-Identifier: Apache-2.0
// The numbers of a field's cells as colours.
#pragma once

#include <optional>

#include "crossgrain/picture.hpp"
#include "field/field_data.hpp"
#include "grid/leaf_finder.hpp"
#include "picture/drawing.hpp"
#include "picture/legend.hpp"

namespace crossgrain {

/// Refers to the field. Safe to use from any number of threads.
class CellColours {
 public:
  /// Throws Error(kInput), naming `source`, where the field has not what is asked for.
  CellColours(const FieldData& field, const PictureOptions& options, const std::string& source);

  bool is_none() const { return what_ == PictureColour::kNone; }

  /// At a point of the surface: of the leaf that is there, slightly inside.
  Colour on_surface(const MeshPoint& point) const;

  /// At a point on a cut: by energy only, which is all that cells without surface have. None outside: where
  /// there is no cell, or where the surface, which may have holes, does not enclose a point of a cell with
  /// some.
  std::optional<Colour> on_cut(const Vector3& point, bool is_enclosed) const;

  /// What the colours mean; none for kNone.
  std::optional<LegendBlock> legend() const;

  /// The leaf at a point; kNoCell where there is none.
  CellIndex leaf_at(const Vector3& point) const;

 private:
  Colour of_leaf(CellIndex leaf) const;
  void choose_scale(const PictureOptions& options);

  const FieldData& field_;
  LeafFinder finder_;
  PictureColour what_;
  double inwards_;  ///< how far a point is moved from the surface, model units
  ColourMap map_;
  ColourScale scale_;
  bool goes_on_ = false;
};

/// What a part without colours has.
inline constexpr Colour kPlainPart = colour_of(0xa9b7c6);

}  // namespace crossgrain
