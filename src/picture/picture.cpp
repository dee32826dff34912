// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "crossgrain/error.hpp"
#include "display/shown_field.hpp"
#include "files/output_file.hpp"
#include "picture/answer_marks.hpp"
#include "picture/axis_cross.hpp"
#include "picture/canvas.hpp"
#include "picture/cell_colours.hpp"
#include "picture/cut_drawing.hpp"
#include "picture/field_drawing.hpp"
#include "picture/layout.hpp"
#include "picture/legend.hpp"
#include "picture/png_file.hpp"
#include "picture/renderer.hpp"
#include "picture/singular_lines.hpp"
#include "picture/streamlines.hpp"

namespace crossgrain {
namespace {

constexpr PictureOptions::View kUsualView{-55, 28};

/// Views of cuts across x, y and z: about 27 degrees off their normals, so that what is behind shows too.
constexpr std::array<PictureOptions::View, 3> kCutViews{{{-20, 18}, {-70, 18}, {-65, 62}}};

/// Opacity of the paper behind the legend.
constexpr float kLegendBacking = 0.85f;

constexpr int kLeastSide = 64, kLargestSide = 10000;
constexpr double kMostPixels = 64e6;

void check(bool sound, const std::string& message) {
  if (!sound) throw Error(ErrorKind::kUsage, message);
}

void check_options(const PictureOptions& options) {
  const auto is_side = [](int pixels) { return pixels >= kLeastSide && pixels <= kLargestSide; };
  check(is_side(options.width) && is_side(options.height) &&
            static_cast<double>(options.width) * options.height <= kMostPixels,
        fmt::format("a picture of {} x {} pixels is not possible: each side must have {} to {}, at most 64 "
                    "million in total",
                    options.width, options.height, kLeastSide, kLargestSide));
  check(!options.view ||
            (std::isfinite(options.view->azimuth_deg) && std::abs(options.view->elevation_deg) <= 90),
        "the azimuth must be finite and the elevation from -90 to 90 degrees");
  check(options.up_axis >= 0 && options.up_axis <= 2, "the axis that points up must be 0, 1 or 2");
  check(options.frame_spacing >= 4 && options.frame_spacing <= 1000,
        "the distance between frames must be from 4 to 1000 pixels");
  check(!options.opacity || (*options.opacity >= 0 && *options.opacity <= 1),
        "the opacity must be from 0 to 1");
  check(!options.cut || (options.cut->axis >= 0 && options.cut->axis <= 2),
        "the axis of the cut must be 0, 1 or 2");
  if (!options.range) return;
  const auto& [low, high] = *options.range;
  check(options.colour == PictureColour::kAlignment || options.colour == PictureColour::kEnergy,
        "a colour range needs colours by alignment or energy");
  check(std::isfinite(low) && std::isfinite(high) && low < high &&
            (low > 0 || options.colour == PictureColour::kAlignment),
        "the colour range must have its lower end first, above 0 for energy");
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

/// What fills the picture: the surface, clipped to what a cut leaves of it.
SolvedSurface kept_surface(const SolvedSurface& surface, const std::optional<PictureCut>& cut) {
  SolvedSurface kept;
  kept.vertices = surface.vertices;
  for (const auto& corners : surface.triangles) {
    std::array<std::uint32_t, 4> polygon{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = corners[k], to = corners[(k + 1) % 3];
      const Vector3 &a = surface.vertices[from], &b = surface.vertices[to];
      const bool is_kept = !cut || cut->keeps(a);
      if (is_kept) polygon[count++] = from;
      if (!cut || is_kept == cut->keeps(b)) continue;
      const double to_a = a[cut->plane.axis] - cut->plane.position,
                   to_b = b[cut->plane.axis] - cut->plane.position;
      polygon[count++] = static_cast<std::uint32_t>(kept.vertices.size());
      kept.vertices.push_back(a + to_a / (to_a - to_b) * (b - a));
    }
    for (std::size_t k = 2; k < count; ++k)
      kept.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
  }
  return kept;
}

/// The positions of the part, the legend and the axes.
struct Layout {
  double text_size, margin;
  std::optional<Camera> camera;
  std::optional<PixelBox> legend, axes;

  /// The part, or what a cut leaves of it, fills the picture, with the legend in a free corner. Without a
  /// free corner the part is moved aside; a legend that would take half of the picture is omitted.
  Layout(const PictureOptions& options, const ViewDirection& direction, const SolvedSurface& surface,
         const std::vector<LegendBlock>& blocks) {
    text_size = std::max(21 * std::min(options.width, options.height) / 1200.0, 10.0);
    margin = 1.5 * text_size;
    std::vector<Vector3> seen;
    for (const auto& corners : surface.triangles)
      for (const std::uint32_t vertex : corners) seen.push_back(surface.vertices[vertex]);
    const PixelBox whole{0, 0, static_cast<double>(options.width), static_cast<double>(options.height)};
    camera.emplace(direction, seen, whole);
    if (!options.legend) return;

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
};

void draw_legend(const std::vector<LegendBlock>& blocks, const Layout& layout, const PictureOptions& options,
                 Image& image) {
  Canvas canvas(image);
  const Colour ink = ink_on(options.background);
  if (layout.legend) {
    // Creases of what a cut removed would run through the text.
    if (options.background != PictureBackground::kTransparent)
      canvas.fill(*layout.legend, paper_of(options.background), kLegendBacking);
    Legend(blocks, layout.text_size)
        .draw(canvas, layout.legend->left + layout.margin, layout.legend->top + layout.margin, ink);
  }
  if (!layout.axes) return;
  draw_axis_cross(canvas, layout.camera->axes(), 0.5 * (layout.axes->left + layout.axes->right),
                  0.5 * (layout.axes->top + layout.axes->bottom), 0.32 * layout.axes->width(), ink);
}

std::vector<LegendBlock> legend_blocks(const ShownField& field, const CellColours& colours,
                                       const PictureOptions& options, const PictureCurves& curves) {
  std::vector<LegendBlock> blocks;
  if (!options.legend) return blocks;
  // The answer is about the tets.
  blocks.push_back(field.is_starting_grid() ? LegendBlock{"Starting grid of a field on tets"}
                                            : answer_legend(field.report(), options.lines));
  if (const auto block = colours.legend()) blocks.push_back(*block);
  if (options.lines)
    if (const auto block = legend_of(
            field, field.is_starting_grid() ? "Singular lines of the starting grid" : "Singular lines",
            ink_on(options.background)))
      blocks.push_back(*block);
  if (const auto block = streamline_legend(curves.streamlines)) blocks.push_back(*block);
  return blocks;
}

}  // namespace

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

namespace {

void render_shown(const ShownField& field, const std::filesystem::path& picture, PictureOptions options,
                  const PictureCurves& curves, const Monitor& monitor) {
  check_options(options);
  OutputFile file(picture);
  monitor.check();

  const ViewDirection direction = direction_of(options);
  const auto plane = picture_cut(options, field.surface(), ViewAxes(direction).towards);
  if (plane) options.cut->position = plane->plane.position;
  const CellColours colours(field, options);
  const PictureSubject subject{field, colours, curves.streamlines};
  std::optional<CutDrawing> cut;
  if (plane) cut.emplace(subject, options, *plane);
  const auto blocks = [&] {
    auto all = legend_blocks(field, colours, options, curves);
    if (cut && options.legend)
      if (auto block = cut->legend()) all.push_back(std::move(*block));
    return all;
  };
  const Layout layout(options, direction, kept_surface(field.surface(), plane), blocks());
  const Camera& camera = *layout.camera;
  Drawing drawing = field_drawing(subject, options, camera);
  if (cut) cut->add_to(drawing, camera);

  const bool is_transparent = options.background == PictureBackground::kTransparent;
  Image image(options.width, options.height,
              is_transparent ? Pixel{} : pixel_of(paper_of(options.background)));
  RenderOptions render_options;
  render_options.haze = paper_of(options.background);
  if (options.background == PictureBackground::kDark) render_options.haze_share *= 0.5f;  // dark hides more
  render(drawing, camera, render_options, image, monitor);
  if (options.legend) draw_legend(blocks(), layout, options, image);
  write_png(file, image, monitor, {.has_mark = true, .description = text_of(blocks())});
  file.commit();
}

}  // namespace

void render_picture(const FrameField& field, const std::filesystem::path& picture,
                    const PictureOptions& options, const PictureCurves& curves, const Monitor& monitor) {
  render_shown(ShownField(field, curves.singularities), picture, options, curves, monitor);
}

void render_picture(const TetFrameField& field, const std::filesystem::path& picture,
                    const PictureOptions& options, const PictureCurves& curves, const Monitor& monitor) {
  render_shown(ShownField(field, curves.singularities), picture, options, curves, monitor);
}

}  // namespace crossgrain
