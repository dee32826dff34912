// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/picture.hpp"

#include "display/shown_field.hpp"
#include "files/output_file.hpp"
#include "picture/answer_marks.hpp"
#include "picture/cell_colours.hpp"
#include "picture/cut_drawing.hpp"
#include "picture/face_labels.hpp"
#include "picture/field_drawing.hpp"
#include "picture/legend.hpp"
#include "picture/sheet.hpp"
#include "picture/singular_lines.hpp"
#include "picture/streamlines.hpp"

namespace crossgrain {
namespace {

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

std::vector<LegendBlock> legend_blocks(const ShownField& field, const CellColours& colours,
                                       const PictureOptions& options, const PictureCurves& curves) {
  std::vector<LegendBlock> blocks;
  const bool has_lines = shows(options, PicturePart::kLines);
  if (!shows(options, PicturePart::kLegend)) return blocks;
  // The answer is about the tets.
  blocks.push_back(field.is_starting_grid() ? LegendBlock{"Starting grid of a field on tets"}
                                            : answer_legend(field.report(), has_lines));
  if (const auto block = colours.legend()) blocks.push_back(*block);
  if (has_lines)
    if (const auto block = legend_of(
            field, field.is_starting_grid() ? "Singular lines of the starting grid" : "Singular lines",
            ink_on(options.background)))
      blocks.push_back(*block);
  if (const auto block = streamline_legend(curves.streamlines)) blocks.push_back(*block);
  return blocks;
}

void render_shown(const ShownField& field, const std::filesystem::path& picture, PictureOptions options,
                  const PictureCurves& curves, const Monitor& monitor) {
  check_options(options);
  check_picture_name(picture);
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
    if (cut && shows(options, PicturePart::kLegend))
      if (auto block = cut->legend()) all.push_back(std::move(*block));
    return all;
  };
  const Sheet sheet(options, direction, kept_surface(field.surface(), plane), blocks());
  const Camera& camera = *sheet.camera;
  Drawing drawing = field_drawing(subject, options, camera);
  if (cut) cut->add_to(drawing, camera);
  if (!colours.faces().empty())
    drawing.labels = face_labels(field.surface().vertices, field.surface().triangles, colours.faces(), camera,
                                 options.size, kLabelSize * sheet.text_size,
                                 drawing.section ? &*drawing.section : nullptr);

  write_picture(file, drawing, sheet, options, blocks(), monitor);
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
