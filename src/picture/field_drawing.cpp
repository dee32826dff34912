// SPDX-License-Identifier: Apache-2.0
#include "picture/field_drawing.hpp"

#include <algorithm>

#include "display/smooth_corners.hpp"
#include "picture/answer_marks.hpp"
#include "picture/sheet.hpp"
#include "picture/singular_lines.hpp"
#include "picture/streamlines.hpp"

namespace crossgrain {
namespace {

// Radii in units of PictureWeights.
constexpr double kSingularRadius = 4.2, kCreaseRadius = 1.0;

DrawnMesh part(const PictureSubject& subject) {
  DrawnMesh mesh;
  mesh.vertices = subject.field.surface().vertices;
  mesh.triangles = subject.field.surface().triangles;
  mesh.corner_normals = corner_normals(SmoothCorners(mesh.vertices, mesh.triangles), mesh.triangles.size());
  mesh.colour = kPlainPart;
  mesh.bounds_solid = true;
  const bool is_plain = subject.colours.is_none();
  mesh.opacity = is_plain ? 0.2f : 0.85f;
  mesh.grazing_opacity = is_plain ? 0.82f : 0.95f;
  if (!is_plain) {
    mesh.has_front_only = true;
    mesh.colour_at = [&colours = subject.colours](const MeshPoint& point) {
      return colours.on_surface(point);
    };
  }
  return mesh;
}

std::vector<Rod> rods_along(const std::vector<std::vector<Vector3>>& lines, double radius,
                            const Colour& colour) {
  std::vector<Rod> rods;
  for (const std::vector<Vector3>& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) rods.push_back({line[i - 1], line[i], radius, colour});
  return rods;
}

}  // namespace

PictureWeights::PictureWeights(const PictureOptions& options, const Camera& camera)
    : unit(std::max(std::min(options.size[0], options.size[1]) / 1200.0, 0.4) * camera.pixel_size()) {}

Colour ink_on(PictureBackground background) {
  return background == PictureBackground::kDark ? colour_of(0xe6ebf0) : colour_of(0x1d2630);
}

Colour paper_of(PictureBackground background) {
  return background == PictureBackground::kDark ? colour_of(0x15191e) : colour_of(0xffffff);
}

Drawing field_drawing(const PictureSubject& subject, const PictureOptions& options, const Camera& camera) {
  const double unit = PictureWeights(options, camera).unit;
  Drawing drawing;
  drawing.meshes.push_back(part(subject));
  if (shows(options, PicturePart::kLines)) {
    drawing.rods.push_back(
        singular_lines(drawn_lines(subject.field), kSingularRadius * unit, ink_on(options.background)));
    // The answer is about the tets.
    if (!subject.field.is_starting_grid())
      answer_marks(subject.field.report(), kSingularRadius * unit, drawing.rods.back().facets);
  }
  drawing.rods.push_back({RodLook::kSolid, streamlines(subject.streamlines, kStreamlineRadius * unit), {}});
  if (shows(options, PicturePart::kCreases))
    drawing.rods.push_back(
        {RodLook::kInk,
         rods_along(subject.field.surface().creases, kCreaseRadius * unit, ink_on(options.background)),
         {}});
  return drawing;
}

}  // namespace crossgrain
