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

/// Smallest difference of a turn from a symmetry of the coordinate axes, rad: below it, coordinates change
/// places and signs without rounding.
constexpr double kSameAxes = 1e-4;

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

/// Directions along which most of the surface is normal or tangent.
std::array<Vector3, 3> axes_of(const Surface& surface) {
  QuadraticForm<4> form;
  const double scale = 1 / (longest_side(surface.box) * longest_side(surface.box));
  for (std::size_t t = 0; t < surface.size(); ++t)
    add_normal(form, surface.normals[t], scale * surface.areas[t]);
  const Quaternion frame = minimising_frame(form);
  std::array<Vector3, 3> axes;
  for (std::size_t k = 0; k < 3; ++k) {
    Vector3 axis{};
    axis[k] = 1;
    axes[k] = rotate(frame, axis);
    const bool is_one_of_space = std::any_of(axes[k].begin(), axes[k].end(), [](double part) {
      return std::abs(part) > 1 - kSameAxes * kSameAxes / 2;
    });
    if (is_one_of_space)
      for (double& part : axes[k]) part = std::round(part);
  }
  return axes;
}

struct Along {
  Vector3 axis;
  double extent;
};

/// The axis with the extent of the surface along it, towards the end with the larger third moment.
Along along(const Surface& surface, const Vector3& centre, const Vector3& axis) {
  double low = std::numeric_limits<double>::infinity(), high = -low, third = 0;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    double mean = 0;
    for (const Vector3& corner : surface.corners(t)) {
      const double place = dot(corner - centre, axis);
      low = std::min(low, place);
      high = std::max(high, place);
      mean += place / 3;
    }
    third += surface.areas[t] * mean * mean * mean;
  }
  return {third < 0 ? -axis : axis, high - low};
}

Surface turned(const Surface& surface, const Turn& turn) {
  Surface result = surface;
  for (Vector3& vertex : result.mesh.vertices) vertex = turn.of_point(vertex);
  for (Vector3& normal : result.normals) normal = turn.of_direction(normal);
  for (auto& corners : result.mesh.corner_normals)
    for (Vector3& normal : corners) normal = turn.of_direction(normal);
  result.box = box_of_solid_triangles(result.mesh);
  return result;
}

void turn_segments(std::vector<GuideSegment>& segments, const Turn& turn) {
  for (GuideSegment& segment : segments) {
    for (Vector3& end : segment.ends) end = turn.of_point(end);
    for (Vector3& direction : segment.directions) direction = turn.of_direction(direction);
  }
}

Guides turned(Guides guides, const Turn& turn) {
  turn_segments(guides.creases, turn);
  turn_segments(guides.segments, turn);
  for (Vector3& corner : guides.corners) corner = turn.of_point(corner);
  for (GuideFace& face : guides.faces) {
    for (Vector3& corner : face.corners) corner = turn.of_point(corner);
    for (Vector3& direction : face.directions) direction = turn.of_direction(direction);
  }
  for (GuidePoint& point : guides.points) {
    point.place = turn.of_point(point.place);
    for (Vector3& direction : point.directions) direction = turn.of_direction(direction);
  }
  return guides;
}

/// Whether a solve of this many finest cells is worth a decision before it.
bool is_wanted(const Solid& solid, const SolveOptions& options, double decided_size) {
  return finest_cell_size(solid.surface.box, options) <= options.solver.largest_decided * decided_size;
}

/// Number of levels after the decision, as far as known before it.
int levels_from(double decided_size, const Solid& solid, const SolveOptions& options) {
  const double finest = finest_cell_size(solid.surface.box, options);
  return 1 + std::max(1, static_cast<int>(std::lround(std::log2(decided_size / finest))));
}

SolveOptions on_one_grid(SolveOptions options, double cell_size) {
  options.resolution = 0;
  options.cell_size = cell_size;
  options.solver.relaxed_cells = std::numeric_limits<std::size_t>::max() / 8;  // all levels are uniform
  return options;
}

/// The field of the turned solid.
SolvedField solved_in(const Turn& turn, const Solid& solid, const SolveOptions& options, const WholeRun& run,
                      const Monitor& monitor) {
  const SearchableSurface surface(turned(solid.surface, turn));
  const Guides guides = solid.guides ? turned(*solid.guides, turn) : Guides();
  const Solid turned_solid{surface.surface(), surface.bvh(), surface.winding(), solid.closed, &guides};
  return nested_solve(turned_solid, options, monitor, {}, run);
}

}  // namespace

Turn turn_to_own_axes(const Surface& surface) {
  const Vector3 centre = centre_of(surface);
  std::array<Along, 3> sides;
  const std::array<Vector3, 3> axes = axes_of(surface);
  for (std::size_t k = 0; k < 3; ++k) sides[k] = along(surface, centre, axes[k]);
  std::stable_sort(sides.begin(), sides.end(),
                   [](const Along& a, const Along& b) { return a.extent > b.extent; });
  const Vector3 third = cross(sides[0].axis, sides[1].axis);
  return {conjugate(quaternion_of({sides[0].axis, sides[1].axis, third})), centre};
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

std::unique_ptr<const DecidedField> DecidedField::solved(const Solid& solid, const SolveOptions& options,
                                                         const Monitor& monitor) {
  if (options.solver.decision_cells == 0) return nullptr;
  Stopwatch watch;
  watch.start();
  const double size = cell_size_for(solid.surface, solid.closed, options.solver.decision_cells);
  if (!is_wanted(solid, options, size)) return nullptr;
  const SolveOptions own = on_one_grid(options, size);
  const WholeRun run{0, 0, levels_from(size, solid, options)};
  try {
    const bool turns = solid.surface.size() <= options.solver.turned_triangles;
    const Turn turn = turns ? turn_to_own_axes(solid.surface) : Turn();
    SolvedField field =
        turns ? solved_in(turn, solid, own, run, monitor) : nested_solve(solid, own, monitor, {}, run);
    return std::unique_ptr<const DecidedField>(new DecidedField(turn, std::move(field), watch.restart()));
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::kInterrupted) throw;
    return nullptr;
  }
}

DecidedField::DecidedField(const Turn& turn, SolvedField field, double seconds)
    : turn_(turn),
      field_(std::move(field)),
      seconds_(seconds),
      sampler_(field_.level.tree, field_.frames, field_.open_faces) {}

Quaternion DecidedField::frame_at(const Vector3& point) const {
  return conjugate(turn_.rotation) * sampler_.at(turn_.of_point(point)).frame;
}

InitialField DecidedField::initial_field(const SolverOptions& options) const {
  const double size = description().cell_size;
  return {[this](const Vector3& point) { return frame_at(point); }, size, size / options.decided_ratio};
}

SolveReport::Decision DecidedField::description() const {
  return {field_.level.tree.root().cell_size(field_.levels.back().depth), field_.level.size(),
          field_.energy.total() + field_.energy.unavoidable, seconds_};
}

}  // namespace crossgrain
