// SPDX-License-Identifier: Apache-2.0
#include "picture/cut_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "crossgrain/error.hpp"
#include "display/axis_colours.hpp"
#include "display/cut_lines.hpp"
#include "picture/cut_frames.hpp"
#include "picture/field_drawing.hpp"
#include "picture/sheet.hpp"
#include "picture/singular_lines.hpp"
#include "picture/streamlines.hpp"

namespace crossgrain {
namespace {

// Radii in units of PictureWeights.
constexpr double kGhostRadius = 0.9, kOutlineRadius = 1.5, kInterfaceRadius = 1.1, kSeamRadius = 1.2,
                 kCutEdgeRadius = 0.35, kLineRadius = 1.7;

/// Distance from the cut within which streamlines are drawn on it, in units of PictureWeights.
constexpr double kOnCutReach = 8;

/// Distance between curves or frames on the cut, in units of PictureWeights: larger pictures show as many.
constexpr double kFrameSpacing = 34;

/// Sides of boxes and lengths of crosses as a share of the distance between frames: in any orientation they
/// stay within their place.
constexpr double kBoxShare = 0.58, kCrossShare = 0.9;

/// Distance of frames from the outline, as a share of the distance between frames.
constexpr double kClearance = 0.3;

/// Length of the dashes of a seam and the gaps between them, in units of PictureWeights.
constexpr double kDash = 9, kPartsPerDash = 3;

/// Smallest mean size of polygons, in units of PictureWeights, whose edges are drawn.
constexpr double kLeastPolygon = 9;

/// Depth of a cut below the plane that is asked for, as a share of the part: a face in that plane, as in
/// assemblies cut along their middle, is then cut off, or left out, as a whole. Above single precision.
constexpr double kInto = 1e-5;

/// Share of the part below which a coordinate is 0 but for rounding.
constexpr double kRounding = 1e-9;

constexpr Colour kSeamColour = colour_of(0x5f6b78), kEdgeColour = colour_of(0xb9c3cd);

Box box_of(const SolvedSurface& surface) {
  Box box = empty_box();
  for (const auto& corners : surface.triangles)
    for (const std::uint32_t vertex : corners) include(box, surface.vertices[vertex]);
  return box;
}

}  // namespace

std::optional<PictureCut> picture_cut(const PictureOptions& options, const SolvedSurface& surface,
                                      const Vector3& towards) {
  if (!options.cut) return std::nullopt;
  const Box box = box_of(surface);
  const auto axis = static_cast<std::size_t>(options.cut->axis);
  const double extent = box.high[axis] - box.low[axis];
  const auto shown = [&](double x) { return std::abs(x) < kRounding * extent ? 0 : x; };
  const double position = shown(options.cut->position.value_or(0.5 * (box.low[axis] + box.high[axis])));
  if (!(position > box.low[axis] && position < box.high[axis])) {
    throw Error(ErrorKind::kUsage,
                fmt::format("the cut at {} = {:.6g} is outside the part, which extends from {:.6g} to {:.6g}",
                            "xyz"[axis], position, shown(box.low[axis]), shown(box.high[axis])));
  }
  constexpr double kFromItsEdge = 0.02;
  if (std::abs(towards[axis]) < kFromItsEdge)
    throw Error(ErrorKind::kUsage, fmt::format("the cut across {} is seen edge-on", "xyz"[axis]),
                Remedy::kTurnView);
  PictureCut cut{{axis, position}, position, {0, 0, 0}};
  cut.normal[axis] = towards[axis] > 0 ? 1 : -1;
  cut.plane.position -= kInto * extent * cut.normal[axis];
  return cut;
}

CutDrawing::CutDrawing(const PictureSubject& subject, const PictureOptions& options, const PictureCut& cut)
    : subject_(subject),
      options_(options),
      cut_(cut),
      outline_(subject.field.surface().vertices, subject.field.surface().triangles, cut.plane.axis,
               cut.plane.position),
      mesh_(subject.field, cut.plane) {
  if (options.frames != PictureFrames::kNone) names_ = mesh_.named_axes();
}

bool CutDrawing::is_inside(const Vector3& point) const {
  const auto piece = mesh_.piece_at(point);
  if (!piece || subject_.field.is_on_tets()) return piece.has_value();
  return subject_.field.grid().on_boundary[mesh_.pieces()[*piece].element] == 0 || outline_.encloses(point);
}

void CutDrawing::add_to(Drawing& drawing, const Camera& camera) {
  const double unit = PictureWeights(options_, camera).unit;
  Section section;
  section.normal = cut_.normal;
  section.offset = cut_.normal[cut_.plane.axis] * cut_.plane.position;
  section.colour_at = [this](const Vector3& point,
                             const std::function<bool()>& is_enclosed) -> std::optional<Colour> {
    if (!subject_.field.is_on_tets()) return subject_.colours.on_cut(point, is_enclosed);
    const auto piece = mesh_.piece_at(point);
    if (!piece) return std::nullopt;
    return subject_.colours.of_tet(mesh_.pieces()[*piece].element);
  };
  if (subject_.field.is_on_tets()) add_edges(drawing, unit);
  if (shows(options_, PicturePart::kCreases)) add_outline(drawing, section, unit);
  if (shows(options_, PicturePart::kLines)) {
    DrawnRods crossings{RodLook::kSolid, {}, {}, true};
    crossings.facets =
        crossings_of(drawing.rods.front(), cut_.normal, section.offset, ink_on(options_.background));
    drawing.rods.push_back(std::move(crossings));
  }
  drawing.section = std::move(section);
  if (!subject_.streamlines.empty())
    drawing.rods.push_back(
        {RodLook::kSolid,
         streamlines_on(*drawing.section, subject_.streamlines, kOnCutReach * unit, kStreamlineRadius * unit),
         {},
         true});
  if (options_.frames == PictureFrames::kNone) return;
  add_seams(drawing, unit);
  options_.frames == PictureFrames::kLines
      ? add_lines(drawing, unit)
      : add_glyphs(drawing, unit, std::abs(camera.axes().towards[cut_.plane.axis]));
}

void CutDrawing::add_outline(Drawing& drawing, Section& section, double unit) const {
  const Colour ink = ink_on(options_.background);
  for (const auto& crease : subject_.field.surface().creases)
    for (std::size_t i = 1; i < crease.size(); ++i)
      section.ghosts.push_back({crease[i - 1], crease[i], kGhostRadius * unit, ink});
  DrawnRods outline{RodLook::kInk, {}, {}, true};
  for (const CutOutline::Segment& segment : outline_.segments())
    outline.rods.push_back({segment.from, segment.to, kOutlineRadius * unit, ink});
  const SolvedSurface& surface = subject_.field.surface();
  const CutOutline interfaces(surface.vertices, surface.interfaces, cut_.plane.axis, cut_.plane.position);
  for (const CutOutline::Segment& segment : interfaces.segments())
    outline.rods.push_back({segment.from, segment.to, kInterfaceRadius * unit, ink});
  drawing.rods.push_back(std::move(outline));
}

void CutDrawing::add_edges(Drawing& drawing, double unit) const {
  double sizes = 0;
  for (const CutMesh::Piece& piece : mesh_.pieces()) sizes += piece.size;
  if (sizes < kLeastPolygon * unit * static_cast<double>(mesh_.pieces().size())) return;
  DrawnRods edges{RodLook::kInk, {}, {}, true};
  for (const CutMesh::Side& side : mesh_.sides())
    edges.rods.push_back({side.from, side.to, kCutEdgeRadius * unit, kEdgeColour});
  drawing.rods.push_back(std::move(edges));
}

/// Adds the seams as dashes.
void CutDrawing::add_seams(Drawing& drawing, double unit) {
  DrawnRods seams{RodLook::kInk, {}, {}, true};
  for (const std::vector<Vector3>& line : mesh_.seams(names_)) {
    double along = 0;
    for (std::size_t k = 1; k < line.size(); ++k) {
      const Vector3 way = line[k] - line[k - 1];
      const double length = norm(way);
      const int parts = static_cast<int>(std::ceil(kPartsPerDash * length / (kDash * unit)));
      for (int i = 0; i < parts; ++i, along += length / parts) {
        const Vector3 from = line[k - 1] + static_cast<double>(i) / parts * way,
                      to = from + 1.0 / parts * way;
        const bool is_dash = std::fmod(along, 2 * kDash * unit) < kDash * unit;
        if (is_dash && is_inside(0.5 * (from + to)))
          seams.rods.push_back({from, to, kSeamRadius * unit, kSeamColour});
      }
    }
  }
  has_seam_ = !seams.rods.empty();
  drawing.rods.push_back(std::move(seams));
}

/// Adds the frames as glyphs that stand on the cut. On a plane that is seen obliquely they are further apart
/// and smaller, so that none hides another.
void CutDrawing::add_glyphs(Drawing& drawing, double unit, double towards) const {
  const double askew = std::sqrt(std::max(towards, 0.1));
  const double usual = kFrameSpacing * unit, spacing = usual / askew;
  std::vector<PlacedFrame> frames;
  const Box box = box_of(subject_.field.surface());
  for (const Vector3& place :
       places_on_plane(box, cut_.plane.axis, cut_.plane.position, spacing, [&](const Vector3& point) {
         return is_inside(point) && outline_.distance_to(point) > kClearance * spacing;
       })) {
    const std::uint32_t piece = *mesh_.piece_at(place);
    frames.push_back({place, mesh_.frames()[piece], names_[piece]});
  }
  if (options_.frames == PictureFrames::kBoxes)
    for (DrawnMesh& mesh : frame_boxes(frames, kBoxShare * usual * askew, cut_.normal))
      drawing.meshes.push_back(std::move(mesh));
  else
    drawing.rods.push_back(frame_crosses(frames, kCrossShare * usual * askew, cut_.normal));
}

void CutDrawing::add_lines(Drawing& drawing, double unit) {
  DrawnRods rods{RodLook::kInk, {}, {}, true};
  has_axis_ = {};
  for (const CutLine& line :
       cut_lines(mesh_, names_, kFrameSpacing * unit, [&](const Vector3& point) { return is_inside(point); }))
    for (std::size_t k = 1; k < line.points.size(); ++k) {
      const std::uint8_t name = line.names[k - 1];
      has_axis_[name] = true;
      rods.rods.push_back(
          {line.points[k - 1], line.points[k], kLineRadius * unit, colour_of(kAxisColours[name])});
    }
  drawing.rods.push_back(std::move(rods));
}

std::optional<LegendBlock> CutDrawing::legend() const {
  if (options_.frames == PictureFrames::kNone) return std::nullopt;
  LegendBlock block{
      fmt::format("Frames on the cut {} = {:.4g}", "xyz"[cut_.plane.axis], cut_.asked_position)};
  const bool has_lines = options_.frames == PictureFrames::kLines;
  for (std::size_t k = 0; k < 3; ++k)
    if (has_axis_[k])
      block.signs.push_back({has_lines ? Sign::Shape::kThinLine : Sign::Shape::kBox,
                             colour_of(kAxisColours[k]), std::string("axis ") + "xyz"[k]});
  if (has_seam_)
    block.signs.push_back({Sign::Shape::kDashes, kSeamColour, "seam, across which names change"});
  return block;
}

}  // namespace crossgrain
