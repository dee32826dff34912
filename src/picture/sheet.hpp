// SPDX-License-Identifier: Apache-2.0
// What pictures of fields and of hexahedra have alike: options, where things are placed, the legend.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "crossgrain/monitor.hpp"
#include "crossgrain/picture.hpp"
#include "field/solved_surface.hpp"
#include "files/output_file.hpp"
#include "picture/camera.hpp"
#include "picture/drawing.hpp"
#include "picture/legend.hpp"

namespace crossgrain {

/// Throws Error(kUsage) for options out of range.
void check_options(const PictureOptions& options);

/// Throws Error(kUsage) for a name of another format than PNG.
void check_picture_name(const std::filesystem::path& picture);

/// Throws Error(kUsage) with this text unless `sound`.
void check_option(bool sound, const std::string& message);

/// Whether the options leave a part in.
bool shows(const PictureOptions& options, PicturePart part);

/// The direction from which the options ask to see the model.
ViewDirection direction_of(const PictureOptions& options);

/// Size of the letters of labels, in that of the legend's.
inline constexpr double kLabelSize = 0.85;

/// The positions of the part, the legend and the axes.
struct Sheet {
  double text_size, margin;
  std::optional<Camera> camera;
  std::optional<PixelBox> legend, axes;

  /// The part, or what a cut leaves of it, fills the picture, with the legend in a free corner. Without a
  /// free corner the part is moved aside; a legend that would take half of the picture is omitted.
  Sheet(const PictureOptions& options, const ViewDirection& direction, const SolvedSurface& surface,
        const std::vector<LegendBlock>& blocks);
};

/// Writes the picture of a drawing with its legend, whose blocks are no larger than those of the sheet.
void write_picture(OutputFile& file, const Drawing& drawing, const Sheet& sheet,
                   const PictureOptions& options, const std::vector<LegendBlock>& blocks,
                   const Monitor& monitor);

}  // namespace crossgrain
