// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "crossgrain/frame_field.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// What the surface is coloured by: numbers of the cells at the surface.
enum class PictureColour {
  kNone,        ///< one colour for all of it
  kAlignment,   ///< mean angle between the normal and the nearest axis, degrees
  kEnergy,      ///< smoothness energy per volume, on a logarithmic scale
  kConstraint,  ///< what the surface asks of a frame: plane, axis, frame, free, conflicted
};

enum class PictureBackground { kLight, kDark, kTransparent };

/// How frames on the cut are drawn.
enum class PictureFrames { kBoxes, kCrosses, kNone };

/// What a picture shows, and from where. The defaults show the whole part, translucent, with its singular
/// lines.
struct PictureOptions {
  /// Pixels, 64 to 10000 each, and at most 64 million in all.
  int width = 1600, height = 1200;

  /// Of the viewer, in degrees: about +z from +x towards +y, and above the xy plane (-90 to 90). The picture
  /// is upright in z, in parallel projection. By default from the front, above and the right.
  double azimuth_deg = -55, elevation_deg = 28;

  /// The axis of the model that points up: 0 x, 1 y, 2 z. The angles above are as if it were z; where it is
  /// y, the front is what is seen from +z, where it is x, from -z, with y to the right.
  int up_axis = 2;

  PictureColour colour = PictureColour::kNone;

  /// Ends of the colour scale, degrees or length^-2; by default they follow from the field. Of kEnergy both
  /// positive.
  std::optional<std::array<double, 2>> range;

  /// A plane across an axis: what is before it, seen from the viewer, is taken away, and the frames on it are
  /// drawn.
  struct Cut {
    int axis = 0;  ///< 0 x, 1 y, 2 z

    /// Coordinate along that axis, model units; the middle of the part where there is none.
    std::optional<double> position;
  };
  std::optional<Cut> cut;

  PictureFrames frames = PictureFrames::kBoxes;

  /// Distance of frames on the cut, in pixels of a picture 1200 high; larger pictures have as many.
  double frame_spacing = 30;

  bool lines = true;    ///< singular lines and their nodes
  bool creases = true;  ///< sharp edges of the part
  bool legend = true;   ///< what colours mean, and the axes of the model

  /// Of faces seen at a right angle, 0 to 1; where there is none, what suits the colour.
  std::optional<double> opacity;

  PictureBackground background = PictureBackground::kLight;
};

/// A view by its name: iso, front, back, left, right, top, bottom; sets both angles. Throws Error(kUsage) for
/// any other. The front is what is seen from -y, with x to the right.
void set_view(PictureOptions& options, const std::string& name);

/// Curves to draw that the field itself does not hold.
struct PictureCurves {
  /// The singular lines; null for those of the field. Of part of a field (OutputOptions) the lines of the
  /// whole are in a file (`read_singularities`).
  const SingularityGraph* singularities = nullptr;

  /// Polylines of two points at least, model units; legend and lines are left out where there are none.
  std::vector<std::vector<Vector3>> streamlines = {};
};

/// Draws a field as a PNG file, which appears complete or not at all. Needs no display and no graphics
/// processor. The same field and options give the same bytes on any number of threads. Cells that were left
/// out of a field (OutputOptions) have no colours and no frames.
///
/// Errors: kUsage for options out of range; kInput for a field without its surface or without what the
/// options colour by, as earlier versions wrote; kOutput; kInterrupted.
void render_picture(const FrameField& field, const std::filesystem::path& picture,
                    const PictureOptions& options = {}, const PictureCurves& curves = {},
                    const Monitor& monitor = {});

}  // namespace crossgrain
