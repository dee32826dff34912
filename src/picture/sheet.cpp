// SPDX-License-Identifier: Apache-2.0
#include "picture/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "crossgrain/error.hpp"
#include "files/output_name.hpp"
#include "picture/axis_cross.hpp"
#include "picture/canvas.hpp"
#include "picture/field_drawing.hpp"
#include "picture/font.hpp"
#include "picture/layout.hpp"
#include "picture/png_file.hpp"
#include "picture/renderer.hpp"

namespace crossgrain {
namespace {

constexpr PictureOptions::View kUsualView{-55, 28};

/// Views of cuts across x, y and z: about 27 degrees off their normals, so that what is behind shows too.
constexpr std::array<PictureOptions::View, 3> kCutViews{{{-20, 18}, {-70, 18}, {-65, 62}}};

/// Opacity of the paper behind the legend.
constexpr float kLegendBacking = 0.85f;

constexpr int kLeastSide = 64, kLargestSide = 10000;
constexpr double kMostPixels = 64e6;

}  // namespace

void check_option(bool sound, const std::string& message) {
  if (!sound) throw Error(ErrorKind::kUsage, message);
}

void check_picture_name(const std::filesystem::path& picture) {
  check_extension(picture, "a picture", std::array<std::string_view, 1>{".png"});
}

void check_options(const PictureOptions& options) {
  const auto [width, height] = options.size;
  const auto is_side = [](int pixels) { return pixels >= kLeastSide && pixels <= kLargestSide; };
  check_option(
      is_side(width) && is_side(height) && static_cast<double>(width) * height <= kMostPixels,
      fmt::format("a picture of {} x {} pixels is not possible: each side must have {} to {}, at most 64 "
                  "million in total",
                  width, height, kLeastSide, kLargestSide));
  check_option(!options.view ||
                   (std::isfinite(options.view->azimuth_deg) && std::abs(options.view->elevation_deg) <= 90),
               "the azimuth must be finite and the elevation from -90 to 90 degrees");
  check_option(options.up_axis >= 0 && options.up_axis <= 2, "the axis that points up must be 0, 1 or 2");
  check_option(!options.cut || (options.cut->axis >= 0 && options.cut->axis <= 2),
               "the axis of the cut must be 0, 1 or 2");
  check_option(!options.quality_below || std::isfinite(*options.quality_below),
               "the limit of the scaled Jacobian must be finite");
  if (!options.range) return;
  const auto& [low, high] = *options.range;
  check_option(options.colour == PictureColour::kAlignment || options.colour == PictureColour::kEnergy,
               "a colour range needs colours by alignment or energy");
  check_option(std::isfinite(low) && std::isfinite(high) && low < high &&
                   (low > 0 || options.colour == PictureColour::kAlignment),
               "the colour range must have its lower end first, above 0 for energy");
}

bool shows(const PictureOptions& options, PicturePart part) {
  return std::find(options.without.begin(), options.without.end(), part) == options.without.end();
}

ViewDirection direction_of(const PictureOptions& options) {
  PictureOptions::View view = kUsualView;
  if (options.cut) {
    // As seen with another axis up, where y takes the place of z, say.
    constexpr std::array<std::array<std::size_t, 3>, 3> kAsSeen{{{2, 0, 1}, {0, 2, 1}, {0, 1, 2}}};
    view = kCutViews[kAsSeen[static_cast<std::size_t>(options.up_axis)]
                            [static_cast<std::size_t>(options.cut->axis)]];
  }
  if (options.view) view = *options.view;
  return {view.azimuth_deg, view.elevation_deg, options.up_axis};
}

PictureOptions::View view_named(const std::string& name) {
  struct NamedView {
    const char* name;
    PictureOptions::View view;
  };
  constexpr std::array<NamedView, 7> kViews{{{"iso", kUsualView},
                                             {"front", {-90, 0}},
                                             {"back", {90, 0}},
                                             {"left", {180, 0}},
                                             {"right", {0, 0}},
                                             {"top", {-90, 90}},
                                             {"bottom", {-90, -90}}}};
  for (const NamedView& known : kViews)
    if (name == known.name) return known.view;
  throw Error(ErrorKind::kUsage,
              "'" + name + "' is not a view; choose iso, front, back, left, right, top or bottom");
}

Sheet::Sheet(const PictureOptions& options, const ViewDirection& direction, const SolvedSurface& surface,
             const std::vector<LegendBlock>& blocks) {
  const auto [pixels_wide, pixels_high] = options.size;
  text_size = std::max(21 * std::min(pixels_wide, pixels_high) / 1200.0, 10.0);
  margin = 1.5 * text_size;
  std::vector<Vector3> seen;
  for (const auto& corners : surface.triangles)
    for (const std::uint32_t vertex : corners) seen.push_back(surface.vertices[vertex]);
  const PixelBox whole{0, 0, static_cast<double>(pixels_wide), static_cast<double>(pixels_high)};
  camera.emplace(direction, seen, whole);
  if (!shows(options, PicturePart::kLegend)) return;

  const Legend measured(blocks, text_size);
  const double width = measured.width() + 2 * margin, height = measured.height() + 2 * margin;
  const double axes_size = 6 * text_size;
  const bool is_wanted = !blocks.empty() && width < whole.width() / 2 && height < whole.height();
  const bool has_axes = axes_size < std::min(whole.width(), whole.height()) / 4;
  FreeCorners corners(surface.vertices, surface.triangles, *camera, whole);
  if (is_wanted) legend = corners.take(width, height);
  if (is_wanted && !legend) {
    PixelBox rest = whole;
    rest.right -= width - margin;
    camera.emplace(direction, seen, rest);
    legend = PixelBox{whole.right - width, 0, whole.right, height};
    corners = FreeCorners(surface.vertices, surface.triangles, *camera, whole);
    corners.keep_free_of(*legend);
  }
  if (has_axes) axes = corners.take(axes_size, axes_size);
}

namespace {

void draw_legend(const std::vector<LegendBlock>& blocks, const Sheet& sheet, const PictureOptions& options,
                 Image& image) {
  Canvas canvas(image);
  const Colour ink = ink_on(options.background);
  if (sheet.legend) {
    // Creases of what a cut removed would run through the text.
    if (options.background != PictureBackground::kTransparent)
      canvas.fill(*sheet.legend, paper_of(options.background), kLegendBacking);
    Legend(blocks, sheet.text_size)
        .draw(canvas, sheet.legend->left + sheet.margin, sheet.legend->top + sheet.margin, ink);
  }
  if (!sheet.axes) return;
  draw_axis_cross(canvas, sheet.camera->axes(), 0.5 * (sheet.axes->left + sheet.axes->right),
                  0.5 * (sheet.axes->top + sheet.axes->bottom), 0.32 * sheet.axes->width(), ink);
}

/// Texts on paper, so that they can be read on any colour.
void draw_labels(const std::vector<Label>& labels, const Sheet& sheet, Image& image) {
  Canvas canvas(image);
  const double size = kLabelSize * sheet.text_size;
  const Font& font = Font::sans();
  for (const Label& label : labels) {
    const Vector3 at = sheet.camera->project(label.place);
    const double half_width = 0.5 * font.width(label.text, size),
                 half_height = 0.5 * font.capital_height(size);
    const double rim = 0.25 * size;
    canvas.fill({at[0] - half_width - rim, at[1] - half_height - rim, at[0] + half_width + rim,
                 at[1] + half_height + rim},
                paper_of(PictureBackground::kLight), kLegendBacking);
    canvas.text(label.text, at[0] - half_width, at[1] + half_height, size, ink_on(PictureBackground::kLight));
  }
}

}  // namespace

void write_picture(OutputFile& file, const Drawing& drawing, const Sheet& sheet,
                   const PictureOptions& options, const std::vector<LegendBlock>& blocks,
                   const Monitor& monitor) {
  const bool is_transparent = options.background == PictureBackground::kTransparent;
  Image image(options.size[0], options.size[1],
              is_transparent ? Pixel{} : pixel_of(paper_of(options.background)));
  RenderOptions render_options;
  render_options.haze = paper_of(options.background);
  if (options.background == PictureBackground::kDark) render_options.haze_share *= 0.5f;  // dark hides more
  render(drawing, *sheet.camera, render_options, image, monitor);
  draw_labels(drawing.labels, sheet, image);
  if (shows(options, PicturePart::kLegend)) draw_legend(blocks, sheet, options, image);
  write_png(file, image, monitor, {.has_mark = true, .description = text_of(blocks)});
  file.commit();
}

}  // namespace crossgrain
