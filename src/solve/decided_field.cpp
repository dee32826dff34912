// SPDX-License-Identifier: Apache-2.0
#include "solve/decided_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/stopwatch.hpp"
#include "constraint/minimising_frame.hpp"
#include "constraint/normal_form.hpp"
#include "crossgrain/error.hpp"
#include "surface/guides.hpp"
#include "surface/searchable_surface.hpp"

namespace crossgrain {
namespace {

/// Axes of space are the surface's own if the form of all its normals is within this share of its weight of
/// the least value there, as for a model that is turned by less than about 0.05 degrees, or of a round one.
constexpr double kSameAxes = 1e-6;

/// Differences of extents and moments that may be rounding, as shares.
constexpr double kRounding = 1e-9;

/// The lines are decided where the finest cells are at most so many times as large as those of the decision.
constexpr double kLargestDecided = 1.5;

/// Relaxation sweeps on each level of at most so many cells after the decision, under a penalty that is
/// weaker in finer cells, so that lines have cores as large as cells of the decision and move as in a
/// continuum. More sweeps move lines further from what was decided (docs/notes/solver.md).
constexpr int kDecidedRelaxation = 12;
constexpr std::size_t kDecidedRelaxedCells = 400000;

Vector3 centre_of(const Surface& surface) {
  Vector3 sum{};
  double area = 0;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    const auto [a, b, c] = surface.corners(t);
    sum += (surface.areas[t] / 3) * (a + b + c);
    area += surface.areas[t];
  }
  return (1 / area) * sum;
}

/// Directions to which most of the surface is normal or tangent.
std::array<Vector3, 3> axes_of_surface(const Surface& surface) {
  QuadraticForm<4> form;
  const double scale = 1 / (longest_side(surface.box) * longest_side(surface.box));
  for (std::size_t t = 0; t < surface.size(); ++t)
    add_normal(form, surface.normals[t], scale * surface.areas[t]);
  const Quaternion least = minimising_frame(form), space{1, 0, 0, 0};
  const auto energy = [&](const Quaternion& frame) { return value(form, frame_coefficients<4>(frame)); };
  return axes_of(energy(space) - energy(least) < kSameAxes * form.weight ? space : least);
}

struct Along {
  Vector3 axis;
  double extent;
};

/// The axis with the extent of the surface along it, towards the end with the larger third moment.
Along along(const Surface& surface, const Vector3& centre, const Vector3& axis) {
  double low = std::numeric_limits<double>::infinity(), high = -low, third = 0, all = 0;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    double mean = 0;
    for (const Vector3& corner : surface.corners(t)) {
      const double place = dot(corner - centre, axis);
      low = std::min(low, place);
      high = std::max(high, place);
      mean += place / 3;
    }
    const double moment = surface.areas[t] * mean * mean * mean;
    third += moment;
    all += std::abs(moment);
  }
  return {third < -kRounding * all ? -axis : axis, high - low};
}

Surface turned(const Surface& surface, const Quaternion& turn) {
  Surface result = surface;
  for (Vector3& vertex : result.mesh.vertices) vertex = rotate(turn, vertex);
  for (Vector3& normal : result.normals) normal = rotate(turn, normal);
  for (auto& corners : result.mesh.corner_normals)
    for (Vector3& normal : corners) normal = rotate(turn, normal);
  result.box = box_of_solid_triangles(result.mesh);
  return result;
}

void turn_segments(std::vector<GuideSegment>& segments, const Quaternion& turn) {
  for (GuideSegment& segment : segments) {
    for (Vector3& end : segment.ends) end = rotate(turn, end);
    for (Vector3& direction : segment.directions) direction = rotate(turn, direction);
  }
}

Guides turned(Guides guides, const Quaternion& turn) {
  turn_segments(guides.creases, turn);
  turn_segments(guides.segments, turn);
  for (Vector3& corner : guides.corners) corner = rotate(turn, corner);
  for (GuideFace& face : guides.faces) {
    for (Vector3& corner : face.corners) corner = rotate(turn, corner);
    for (Vector3& direction : face.directions) direction = rotate(turn, direction);
  }
  for (GuidePoint& point : guides.points) {
    point.place = rotate(turn, point.place);
    for (Vector3& direction : point.directions) direction = rotate(turn, direction);
  }
  return guides;
}

/// Whether a solve of this many finest cells is worth a decision before it.
bool is_wanted(const Solid& solid, const SolveTuning& options, double decided_size) {
  return finest_cell_size(solid.surface.box, options) <= kLargestDecided * decided_size;
}

SolveTuning on_one_grid(SolveTuning options, double cell_size) {
  options.resolution = 0;
  options.cell_size = cell_size;
  options.solver.relaxed_cells = std::numeric_limits<std::size_t>::max() / 8;  // all levels are uniform
  return options;
}

constexpr PlaceInRun kPlace{0, true};

SolvedField solved_in(const Quaternion& turn, const Solid& solid, const SolveTuning& options,
                      const Monitor& monitor) {
  const SearchableSurface surface(turned(solid.surface, turn));
  const Guides guides = solid.guides ? turned(*solid.guides, turn) : Guides();
  const Solid turned_solid{surface.surface(), surface.bvh(), surface.winding(), solid.closed, &guides};
  return nested_solve(turned_solid, options, monitor, {}, kPlace);
}

}  // namespace

Quaternion turn_to_own_axes(const Surface& surface) {
  const Vector3 centre = centre_of(surface);
  std::array<Along, 3> sides;
  const std::array<Vector3, 3> axes = axes_of_surface(surface);
  for (std::size_t k = 0; k < 3; ++k) sides[k] = along(surface, centre, axes[k]);
  const double same = kRounding * longest_side(surface.box);
  // By hand, since "longer by more than rounding" is no order.
  for (const auto& [i, j] : {std::pair{0, 1}, {1, 2}, {0, 1}})
    if (sides[j].extent > sides[i].extent + same) std::swap(sides[i], sides[j]);
  const Vector3 third = cross(sides[0].axis, sides[1].axis);
  return conjugate(quaternion_of({sides[0].axis, sides[1].axis, third}));
}

double cell_size_for(const Surface& surface, bool closed, std::size_t cells) {
  const Box& box = surface.box;
  const double whole = (box.high[0] - box.low[0]) * (box.high[1] - box.low[1]) * (box.high[2] - box.low[2]);
  const double volume = closed ? std::min(enclosed_volume(surface), whole) : whole / 2;
  double area = 0;
  for (const double part : surface.areas) area += part;
  // A cell at the surface is one if it holds a part of it; on average surface crosses 3/2 of its area in
  // cells, and half of their volume is inside.
  const auto count = [&](double size) { return volume / (size * size * size) + 0.75 * area / (size * size); };
  double low = 1e-6 * longest_side(box), high = longest_side(box);
  for (int step = 0; step < 60; ++step) {
    const double middle = std::sqrt(low * high);
    (count(middle) > static_cast<double>(cells) ? low : high) = middle;
  }
  return high;
}

std::unique_ptr<const DecidedField> DecidedField::solved(const Solid& solid, const SolveTuning& options,
                                                         const Monitor& monitor) {
  if (options.solver.decision_cells == 0) return nullptr;
  Stopwatch watch;
  const double size = cell_size_for(solid.surface, solid.closed, options.solver.decision_cells);
  if (!is_wanted(solid, options, size)) return nullptr;
  const SolveTuning own = on_one_grid(options, size);
  try {
    const bool turns = solid.surface.size() <= options.solver.turned_triangles;
    const Quaternion turn = turns ? turn_to_own_axes(solid.surface) : Quaternion{1, 0, 0, 0};
    SolvedField field =
        turns ? solved_in(turn, solid, own, monitor) : nested_solve(solid, own, monitor, {}, kPlace);
    return std::unique_ptr<const DecidedField>(new DecidedField(turn, std::move(field), watch.restart()));
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::kInterrupted) throw;
    return nullptr;
  }
}

DecidedField::DecidedField(const Quaternion& turn, SolvedField field, double seconds)
    : turn_(turn),
      field_(std::move(field)),
      seconds_(seconds),
      sampler_(field_.level.tree, field_.frames, field_.open_faces) {}

Quaternion DecidedField::frame_at(const Vector3& point) const {
  return conjugate(turn_) * sampler_.at(rotate(turn_, point)).frame;
}

InitialField DecidedField::initial_field() const {
  const double size = description().cell_size;
  InitialField initial;
  initial.frame_at = [this](const Vector3& point) { return frame_at(point); };
  initial.first_cell_size = size;
  // The coarser of two levels may have merged lines that the decision tells apart.
  initial.last_cell_size = size / 2;
  initial.relaxed = {kDecidedRelaxedCells, kDecidedRelaxation, size};
  return initial;
}

SolveReport::Decision DecidedField::description() const {
  return {field_.level.tree.root().cell_size(field_.levels.back().depth), field_.level.size(),
          field_.energy.total() + field_.energy.unavoidable};
}

}  // namespace crossgrain
