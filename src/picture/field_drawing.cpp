// SPDX-License-Identifier: Apache-2.0
#include "picture/field_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "crossgrain/error.hpp"
#include "picture/answer_marks.hpp"
#include "picture/corner_normals.hpp"
#include "picture/cut_frames.hpp"
#include "picture/cut_outline.hpp"
#include "picture/singular_lines.hpp"
#include "picture/streamlines.hpp"

namespace crossgrain {
namespace {

// Radii in units of PictureWeights.
constexpr double kSingularRadius = 4.2, kCreaseRadius = 1.0, kGhostRadius = 0.9, kOutlineRadius = 1.5,
                 kStreamlineRadius = 1.6;

/// Distance from the cut within which streamlines are drawn on it, in units of PictureWeights.
constexpr double kOnCutReach = 8;

/// Largest angle between faces that are shaded as one curved face.
constexpr double kSmoothDeg = 32;

/// Sides of boxes and lengths of crosses as a share of the distance between frames: in any orientation they
/// stay within their place.
constexpr double kBoxShare = 0.58, kCrossShare = 0.84;

/// Distance of frames from the outline, as a share of the distance between frames.
constexpr double kClearance = 0.3;

constexpr Colour kBoxColour = colour_of(0x74a9dc), kCrossColour = colour_of(0x2c6db3);

Box box_of(const SolvedSurface& surface) {
  Box box = empty_box();
  for (const auto& corners : surface.triangles)
    for (const std::uint32_t vertex : corners) include(box, surface.vertices[vertex]);
  return box;
}

DrawnMesh part(const PictureSubject& subject, const PictureOptions& options) {
  DrawnMesh mesh;
  mesh.vertices = subject.field.surface().vertices;
  mesh.triangles = subject.field.surface().triangles;
  mesh.corner_normals = corner_normals(mesh.vertices, mesh.triangles, kSmoothDeg);
  mesh.colour = kPlainPart;
  mesh.bounds_solid = true;
  const bool is_plain = subject.colours.is_none();
  mesh.opacity = static_cast<float>(options.opacity.value_or(is_plain ? 0.2 : 0.72));
  mesh.grazing_opacity = std::max(mesh.opacity, is_plain ? 0.82f : 0.92f);
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

/// A cut through the part, and the frames on it.
class Cut {
 public:
  Cut(const PictureSubject& subject, const PictureOptions& options, const Camera& camera)
      : subject_(subject),
        options_(options),
        unit_(PictureWeights(options, camera).unit),
        box_(box_of(subject.field.surface())),
        axis_(static_cast<std::size_t>(options.cut->axis)),
        position_(options.cut->position.value_or(0.5 * (box_.low[axis_] + box_.high[axis_]))),
        outline_(subject.field.surface().vertices, subject.field.surface().triangles, axis_, position_) {
    if (!(position_ > box_.low[axis_] && position_ < box_.high[axis_]))
      throw Error(
          ErrorKind::kUsage,
          fmt::format("the cut at {} = {:.6g} is outside the part, which extends from {:.6g} to {:.6g}",
                      "xyz"[axis_], position_, box_.low[axis_], box_.high[axis_]));
    const double towards = camera.axes().towards[axis_];
    towards_ = std::abs(towards);
    constexpr double kFromItsEdge = 0.02;
    if (towards_ < kFromItsEdge)
      throw Error(ErrorKind::kUsage, fmt::format("the cut across {} is seen edge-on", "xyz"[axis_]),
                  Remedy::kTurnView);
    normal_ = {0, 0, 0};
    normal_[axis_] = towards > 0 ? 1 : -1;
  }

  void add_to(Drawing& drawing) const {
    Section section;
    section.normal = normal_;
    section.offset = normal_[axis_] * position_;
    section.colour_at = [&colours = subject_.colours](const Vector3& point, bool is_enclosed) {
      return colours.on_cut(point, is_enclosed);
    };
    const Colour ink = ink_on(options_.background);
    if (options_.creases) {
      section.ghosts = rods_along(subject_.field.surface().creases, kGhostRadius * unit_, ink);
      DrawnRods outline{RodLook::kInk, {}, {}, true};
      for (const CutOutline::Segment& segment : outline_.segments())
        outline.rods.push_back({segment.from, segment.to, kOutlineRadius * unit_, ink});
      drawing.rods.push_back(std::move(outline));
    }
    if (options_.lines) {  // the lines are the first rods
      DrawnRods crossings{RodLook::kSolid, {}, {}, true};
      crossings.balls = crossings_of(drawing.rods.front(), normal_, section.offset);
      drawing.rods.push_back(std::move(crossings));
    }
    drawing.section = std::move(section);
    add_frames(drawing);
  }

 private:
  /// Adds the frames on the cut. On a plane that is seen obliquely they are further apart and smaller, so
  /// that none hides another.
  void add_frames(Drawing& drawing) const {
    if (options_.frames == PictureFrames::kNone) return;
    const double askew = std::sqrt(std::max(towards_, 0.1));
    const double usual = options_.frame_spacing * unit_, spacing = usual / askew;
    std::vector<PlacedFrame> frames;
    for (const Vector3& place : places_on_plane(box_, axis_, position_, spacing, [&](const Vector3& point) {
           return is_inside(point) && outline_.distance_to(point) > kClearance * spacing;
         }))
      frames.push_back({place, from_stored(subject_.field.grid().frames[subject_.colours.leaf_at(place)])});
    if (options_.frames == PictureFrames::kBoxes)
      drawing.meshes.push_back(frame_boxes(frames, kBoxShare * usual * askew, kBoxColour));
    else
      drawing.rods.push_back(frame_crosses(frames, kCrossShare * usual * askew, kCrossColour));
  }

  bool is_inside(const Vector3& point) const {
    const CellIndex leaf = subject_.colours.leaf_at(point);
    return leaf != kNoCell && (subject_.field.grid().on_boundary[leaf] == 0 || outline_.encloses(point));
  }

  const PictureSubject& subject_;
  const PictureOptions& options_;
  double unit_;
  Box box_;
  std::size_t axis_;
  double position_;
  CutOutline outline_;
  double towards_;  ///< cosine between the cut's normal and the view
  Vector3 normal_;
};

}  // namespace

PictureWeights::PictureWeights(const PictureOptions& options, const Camera& camera)
    : unit(std::max(std::min(options.width, options.height) / 1200.0, 0.4) * camera.pixel_size()) {}

Colour ink_on(PictureBackground background) {
  return background == PictureBackground::kDark ? colour_of(0xe6ebf0) : colour_of(0x1d2630);
}

Colour paper_of(PictureBackground background) {
  return background == PictureBackground::kDark ? colour_of(0x15191e) : colour_of(0xffffff);
}

Drawing field_drawing(const PictureSubject& subject, const PictureOptions& options, const Camera& camera) {
  const double unit = PictureWeights(options, camera).unit;
  Drawing drawing;
  drawing.meshes.push_back(part(subject, options));
  if (options.lines) {
    drawing.rods.push_back(
        singular_lines(subject.field.lines(), kSingularRadius * unit, ink_on(options.background)));
    std::vector<Ball>& balls = drawing.rods.back().balls;
    const std::vector<Ball> marks = answer_marks(subject.field.report(), kSingularRadius * unit);
    balls.insert(balls.end(), marks.begin(), marks.end());
  }
  drawing.rods.push_back({RodLook::kSolid, streamlines(subject.streamlines, kStreamlineRadius * unit), {}});
  if (options.creases)
    drawing.rods.push_back(
        {RodLook::kInk,
         rods_along(subject.field.surface().creases, kCreaseRadius * unit, ink_on(options.background)),
         {}});
  if (options.cut) Cut(subject, options, camera).add_to(drawing);
  if (drawing.section && !subject.streamlines.empty())
    drawing.rods.push_back(
        {RodLook::kSolid,
         streamlines_on(*drawing.section, subject.streamlines, kOnCutReach * unit, kStreamlineRadius * unit),
         {},
         true});
  return drawing;
}

}  // namespace crossgrain
