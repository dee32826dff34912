// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "crossgrain/frame_field.hpp"
#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/hex_report.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/streamlines.hpp"
#include "crossgrain/tet_frame_field.hpp"

namespace crossgrain {

/// \addtogroup files Files, pages and pictures
/// @{

/// What the surface is coloured by.
enum class PictureColour {
  kNone,        ///< one colour for all of it
  kAlignment,   ///< angle between the normal and the nearest axis, degrees
  kEnergy,      ///< smoothness energy per volume, on a logarithmic scale
  kConstraint,  ///< class of the constraints (CellConstraint); only for a field on a grid
  kRegion,      ///< the solid or region, of several; also of hexahedra
  kFace,        ///< the face of the model, with its number; also of hexahedra
};

enum class PictureBackground { kLight, kDark, kTransparent };

/// How frames on the cut are drawn: as curves along the axes in the plane, or as glyphs that stand on it.
enum class PictureFrames { kLines, kBoxes, kCrosses, kNone };

/// What may be left out.
enum class PicturePart {
  kLines,    ///< singular lines and their nodes
  kCreases,  ///< sharp edges of the part
  kLegend,   ///< meaning of the colours, and the axes of the model
};

/// Content and view of a picture. The defaults show the whole part, translucent, with its singular lines.
struct PictureOptions {
  /// Width and height in pixels, 64 to 10000 each and at most 64 million in all.
  std::array<int, 2> size{1600, 1200};

  /// Position of the viewer in degrees. The projection is parallel with z upright.
  struct View {
    double azimuth_deg;    ///< about +z from +x towards +y
    double elevation_deg;  ///< above the xy plane, -90 to 90
  };

  /// By default from the front, above and the right (-55, 28), or nearly at right angles to a cut.
  std::optional<View> view;

  /// Axis of the model that points up: 0 x, 1 y, 2 z. The angles above treat it as z. With y up, the front is
  /// the side seen from +z; with x up, the side seen from -z, with y to the right.
  int up_axis = 2;

  /// Of hexahedra kNone, which is their scaled Jacobian, kFace or kRegion.
  PictureColour colour = PictureColour::kNone;

  /// Ends of the colour scale in degrees or length^-2, both positive for kEnergy; derived from the field by
  /// default.
  std::optional<std::array<double, 2>> range;

  /// A plane across an axis. The part in front of it is removed, the rest fills the picture, and the frames
  /// on the plane are drawn.
  struct Cut {
    int axis = 0;  ///< 0 x, 1 y, 2 z

    /// Coordinate along that axis, model units; the middle of the part by default.
    std::optional<double> position;
  };
  std::optional<Cut> cut;

  PictureFrames frames = PictureFrames::kLines;

  /// Parts to leave out.
  std::vector<PicturePart> without = {};

  PictureBackground background = PictureBackground::kLight;

  /// Of hexahedra: those to draw have a scaled Jacobian below this; all by default.
  std::optional<double> quality_below;
};

/// The view of a name: iso, front, back, left, right, top or bottom. The front is the side seen from -y, with
/// x to the right. Throws Error(kUsage) for any other name.
PictureOptions::View view_named(const std::string& name);

/// Curves to draw that are not part of the field.
struct PictureCurves {
  /// The singular lines to draw; null for those of the field. A field that was written in part
  /// (OutputOptions) lacks some of them; a file of the folder has all (`read_singularities`).
  const SingularityGraph* singularities = nullptr;

  /// Streamlines to draw, each in the colour of its axis. If empty, the legend does not mention them.
  std::vector<AxisCurve> streamlines = {};
};

/// Draws a field as a PNG file, which appears complete or not at all. Needs no display and no graphics
/// processor. The same field and options give the same bytes on any number of threads. Cells that were left
/// out of a field (OutputOptions) have no colours and no frames.
///
/// Errors: kUsage for options out of range and for a name that ends in anything but .png, if in anything;
/// kInput for a field without its surface or without what the
/// options colour by, as earlier versions wrote; kOutput; kInterrupted.
void render_picture(const FrameField& field, const std::filesystem::path& picture,
                    const PictureOptions& options = {}, const PictureCurves& curves = {},
                    const Monitor& monitor = {});

/// Draws a field on tets: its own lines, frames and numbers. Draw `field.grid()` for those of the grid from
/// which it started.
void render_picture(const TetFrameField& field, const std::filesystem::path& picture,
                    const PictureOptions& options = {}, const PictureCurves& curves = {},
                    const Monitor& monitor = {});

/// Draws a mesh of hexahedra: its outside with the edges of its faces, each hexahedron in the colour of its
/// scaled Jacobian on a scale from 0 to 1, inverted ones in a colour of their own. A cut removes the
/// hexahedra whose centres are in front of the plane, as a whole. The legend repeats what the report says of
/// the mesh, unless that is null. What is said above of files, threads and errors holds here too; options of
/// lines, creases and frames are not used.
///
/// Colours by PictureColour::kFace are those of the faces of the model (HexMesh::Face::tag) instead; faces
/// inside, which a cut shows, are plain.
///
/// Errors: kUsage also for colours by anything else, for a cut that leaves no hexahedron, and for corners
/// that are no vertices; kInput for a mesh without hexahedra, or without the tags to colour by.
void render_picture(const HexMesh& mesh, const std::filesystem::path& picture,
                    const PictureOptions& options = {}, const HexReport* report = nullptr,
                    const Monitor& monitor = {});

/// @}

}  // namespace crossgrain
