// SPDX-License-Identifier: Apache-2.0
// What a picture of a field shows.
#pragma once

#include <vector>

#include "crossgrain/picture.hpp"
#include "field/field_data.hpp"
#include "field/solved_surface.hpp"
#include "picture/camera.hpp"
#include "picture/cell_colours.hpp"
#include "picture/drawing.hpp"

namespace crossgrain {

/// What is drawn from; lives as long as the drawing.
struct PictureSubject {
  const FieldData& field;
  const SolvedSurface& surface;
  const SingularityGraph& singularities;
  const CellColours& colours;
  const std::vector<std::vector<Vector3>>& streamlines;  ///< polylines
};

/// Thickness of things in a picture.
struct PictureWeights {
  double unit;  ///< model units; a 1200th of the shorter side of the picture

  explicit PictureWeights(const PictureOptions& options, const Camera& camera);
};

inline constexpr Colour kStreamlineColour = colour_of(0x2f9e8f);

/// Throws Error(kUsage) where the options cut beside the part, or the cut is seen from its edge.
Drawing field_drawing(const PictureSubject& subject, const PictureOptions& options, const Camera& camera);

/// Colours that go with a background.
Colour ink_on(PictureBackground background);
Colour paper_of(PictureBackground background);

}  // namespace crossgrain
