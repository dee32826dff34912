// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "crossgrain/solve.hpp"
#include "field/field_data.hpp"
#include "grid/leaf_finder.hpp"
#include "method_figures.hpp"
#include "picture/corner_normals.hpp"
#include "picture/cut_outline.hpp"
#include "picture/singular_lines.hpp"

namespace crossgrain::figures {
namespace {

constexpr std::array<int, 4> kResolutions{8, 16, 32, 64};
constexpr double kPanelWidth = 580, kPanelHeight = 456, kCaption = 54;
constexpr ViewDirection kView{-66, 52};
constexpr std::size_t kCutAxis = 2;

/// Smaller cells have faint edges, and one in four a cross.
constexpr double kCrossPixels = 12;

/// The axis of a frame that stands out of the cut, by its part along the normal, is left out of its cross.
constexpr double kAcross = std::numbers::sqrt2 / 2;

constexpr Colour kInside = colour_of(0xfdf6e6), kOutside = colour_of(0xdfe7ef),
                 kCellEdge = colour_of(0x9aa7b4), kCross = colour_of(0x2c6db3);

/// One solve, cut open along its cells.
class CutField {
 public:
  CutField(const FrameField& field, double pixel)
      : field_(field),
        data_(field.data()),
        surface_(data_.surface.get()),
        finder_(data_.tree),
        pixel_(pixel),
        position_(0.5 *
                  (box_of(surface_->vertices).low[kCutAxis] + box_of(surface_->vertices).high[kCutAxis])),
        outline_(surface_->vertices, surface_->triangles, kCutAxis, position_) {}

  Drawing drawing() const {
    Drawing drawing;
    drawing.meshes.push_back(part());
    drawing.rods.push_back(singular_lines(field_.singularities(), 3 * pixel_, kInk));
    drawing.rods.back().is_whole = true;  // they rise from the cut into what it takes away
    DrawnRods marks{RodLook::kInk, crosses(), {}, true};
    for (const CutOutline::Segment& segment : outline_.segments())
      marks.rods.push_back({segment.from, segment.to, 1.4 * pixel_, kInk});
    drawing.rods.push_back(std::move(marks));
    DrawnRods crossings{RodLook::kSolid, {}, {}, true};
    crossings.balls = crossings_of(drawing.rods.front(), normal(), position_);
    drawing.rods.push_back(std::move(crossings));
    drawing.section = Section{normal(), position_, [this](const Vector3& point, bool is_enclosed) {
                                return colour_on_cut(point, is_enclosed);
                              }};
    for (const std::vector<Vector3>& crease : surface_->creases)
      for (std::size_t i = 1; i < crease.size(); ++i)
        drawing.section->ghosts.push_back({crease[i - 1], crease[i], 1.2 * pixel_, kInk});
    return drawing;
  }

 private:
  static Vector3 normal() { return {0, 0, 1}; }

  DrawnMesh part() const {
    DrawnMesh mesh;
    mesh.vertices = surface_->vertices;
    mesh.triangles = surface_->triangles;
    mesh.corner_normals = corner_normals(mesh.vertices, mesh.triangles, 32);
    mesh.colour = colour_of(0xa9b7c6);
    mesh.opacity = 0.2f;
    mesh.grazing_opacity = 0.8f;
    mesh.bounds_solid = true;
    return mesh;
  }

  CellIndex leaf_at(const Vector3& point) const {
    const auto cell = data_.tree.root().locate(point);
    return cell ? finder_.containing(*cell) : kNoCell;
  }

  /// Cells are whole, the part of them that is outside too: the surface is immersed in them.
  std::optional<Colour> colour_on_cut(const Vector3& point, bool is_enclosed) const {
    const CellIndex leaf = leaf_at(point);
    if (leaf == kNoCell) return std::nullopt;
    const FrameField::Cell cell = field_.cell(leaf);
    double to_edge = cell.size;
    for (const std::size_t k : {0, 1})
      to_edge = std::min(to_edge, 0.5 * cell.size - std::abs(point[k] - cell.center[k]));
    const Colour colour = is_enclosed ? kInside : kOutside;
    return to_edge < 0.5 * pixel_ ? mix(colour, kCellEdge, cell.size > kCrossPixels * pixel_ ? 1.0f : 0.5f)
                                  : colour;
  }

  /// A cross for each cell on the plane, at the middle of its square, where that is inside; of small cells
  /// for one in four, at the middle of the four.
  std::vector<Rod> crosses() const {
    std::vector<Rod> rods;
    for (std::size_t i = 0; i < field_.size(); ++i) {
      const FrameField::Cell cell = field_.cell(i);
      if (std::abs(cell.center[kCutAxis] - position_) > 0.5 * cell.size) continue;
      Vector3 place = cell.center;
      double size = cell.size;
      if (size < kCrossPixels * pixel_) {
        const CellAddress address = data_.tree[i];
        if (!is_even(address, 0) || !is_even(address, 1)) continue;
        place = cell.center + Vector3{0.5 * size, 0.5 * size, 0};
        size *= 2;
      }
      place[kCutAxis] = position_;
      if (!outline_.encloses(place)) continue;
      const double reach = 0.36 * size, radius = std::min(1.5 * pixel_, 0.05 * size);
      for (const Vector3& axis : cell.frame.axes)
        if (std::abs(axis[kCutAxis]) < kAcross)
          rods.push_back({place - reach * axis, place + reach * axis, radius, kCross});
    }
    return rods;
  }

  /// Whether a cell is the first of two in a parent.
  static bool is_even(CellAddress address, std::size_t axis) {
    return address.corner()[axis] / address.width() % 2 == 0;
  }

  const FrameField& field_;
  const FieldData& data_;
  std::shared_ptr<const SolvedSurface> surface_;
  LeafFinder finder_;
  double pixel_;
  double position_;
  CutOutline outline_;
};

/// Along z, round but for a flat side at y = -kFlat: that holds the frames, which all stand alike on a round
/// bar turned any way.
TriangleMesh bar_with_flat() {
  constexpr double kFlat = 0.5, kHeight = 1.1;
  constexpr std::uint32_t kAround = 161, kBottom = 2 * kAround, kTop = kBottom + 1;
  const double end = std::asin(kFlat);  // where the flat side begins, below x
  TriangleMesh bar;
  for (const double z : {0.0, kHeight}) {
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const double angle = -end + (std::numbers::pi + 2 * end) * i / (kAround - 1);
      bar.vertices.push_back({std::cos(angle), std::sin(angle), z});
    }
  }
  bar.vertices.insert(bar.vertices.end(), {{0, 0, 0}, {0, 0, kHeight}});
  for (std::uint32_t i = 0; i < kAround; ++i) {
    const std::uint32_t next = (i + 1) % kAround;
    bar.triangles.insert(bar.triangles.end(), {{i, next, next + kAround},
                                               {i, next + kAround, i + kAround},
                                               {kBottom, next, i},
                                               {kTop, i + kAround, next + kAround}});
  }
  return bar;
}

/// The part and the cells around it.
std::vector<Vector3> seen_of(const TriangleMesh& part) {
  std::vector<Vector3> seen = part.vertices;
  const Box box = box_of(part.vertices);
  const double middle = 0.5 * (box.low[kCutAxis] + box.high[kCutAxis]), margin = 0.09 * longest_side(box);
  for (const double x : {box.low[0] - margin, box.high[0] + margin})
    for (const double y : {box.low[1] - margin, box.high[1] + margin}) seen.push_back({x, y, middle});
  return seen;
}

void draw_level(Figure& figure, const TriangleMesh& part, int resolution, const PixelBox& box) {
  SolveOptions options;
  options.resolution = resolution;
  const FrameField field = solve(part, options);
  const std::vector<Vector3> seen = seen_of(part);
  const Camera camera(kView, seen, {0, 0, box.width(), box.height()}, 0);
  const CutField cut(field, camera.pixel_size());
  figure.draw(cut.drawing(), kView, seen, box);
  figure.text(fmt::format("{} cells across, {} in all", resolution, field.size()),
              0.5 * (box.left + box.right), box.bottom + 32, 22);
}

}  // namespace

Figure levels_figure() {
  const TriangleMesh part = bar_with_flat();
  Figure figure(static_cast<int>(2 * kPanelWidth), static_cast<int>(2 * (kPanelHeight + kCaption)));
  for (std::size_t i = 0; i < kResolutions.size(); ++i) {
    const double left = kPanelWidth * static_cast<double>(i % 2),
                 top = (kPanelHeight + kCaption) * static_cast<double>(i / 2);
    draw_level(figure, part, kResolutions[i],
               {left + 6, top + 6, left + kPanelWidth - 6, top + kPanelHeight});
  }
  return figure;
}

}  // namespace crossgrain::figures
