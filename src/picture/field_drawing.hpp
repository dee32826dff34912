// SPDX-License-Identifier: Apache-2.0
// The drawing of a field.
#pragma once

#include <vector>

#include "crossgrain/picture.hpp"
#include "display/shown_field.hpp"
#include "picture/camera.hpp"
#include "picture/cell_colours.hpp"
#include "picture/drawing.hpp"

namespace crossgrain {

/// The data to draw; must live as long as the drawing.
struct PictureSubject {
  const ShownField& field;
  const CellColours& colours;
  const std::vector<AxisCurve>& streamlines;
};

/// The unit of line widths and sizes in a picture.
struct PictureWeights {
  double unit;  ///< model units; 1/1200 of the shorter side of the picture

  explicit PictureWeights(const PictureOptions& options, const Camera& camera);
};

/// The drawing of a field without its cut (picture/cut_drawing.hpp). The first rods are the singular lines,
/// if they are drawn.
Drawing field_drawing(const PictureSubject& subject, const PictureOptions& options, const Camera& camera);

/// Colours of lines and paper for a background.
Colour ink_on(PictureBackground background);
Colour paper_of(PictureBackground background);

}  // namespace crossgrain
