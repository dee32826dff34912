// SPDX-License-Identifier: Apache-2.0
#include "measure/constraint_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/place.hpp"
#include "measure/alignment.hpp"
#include "measure/angle_statistics.hpp"
#include "surface/clipping.hpp"
#include "surface/constraint_faults.hpp"
#include "surface/constraint_guides.hpp"

namespace crossgrain {
namespace {

/// Smallest gap at which an eigenvector is measured: below it hardly counts, and its angle says nothing about
/// the field.
constexpr double kMeasuredGap = 0.1;

bool has_place(const Box& box, const Vector3& place) {
  return !clip_segment({place, place}, box).empty();
}

/// Returns whether an active leaf holds a place.
using IsInside = std::function<bool(const Vector3& place)>;

/// Collects the axes that constraints prescribe inside the cells, and counts those outside. Asks about the
/// same places in the same order whatever the answers.
class Collector {
 public:
  Collector(const Solid& solid, const GridLevel& level, double step, IsInside is_inside)
      : solid_(solid), level_(level), step_(step), is_inside_(std::move(is_inside)) {}

  void add(const Constraints& constraints) {
    for (const Constraints::Point& point : constraints.points) add(point);
    for (const Constraints::Stress& stress : constraints.stresses) add(stress);
    for (const Constraints::Polyline& polyline : constraints.polylines) add(polyline);
  }

  void add(const Constraints::Point& point) {
    ++asked_.counts.points.count;
    if (!is_inside_(point.at)) {
      note_outside(point.at);
      ++asked_.counts.points.outside;
      return;
    }
    for (const Vector3& axis : directions_of(point.axes)) asked_.points.push_back({point.at, axis, 1});
  }

  void add(const Constraints::Stress& stress) {
    ++asked_.counts.stresses.count;
    const StressAxes axes = stress_axes(stress.tensor);
    asked_.counts.isotropic_stresses += axes.say_nothing();
    if (!is_inside_(stress.at)) {
      note_outside(stress.at);
      ++asked_.counts.stresses.outside;
      return;
    }
    for (int k = 0; k < 3; ++k) {
      if (axes.gaps[k] >= kMeasuredGap) asked_.stresses.push_back({stress.at, axes.directions[k], 1});
    }
  }

  void add(const Constraints::Polyline& polyline) {
    ++asked_.counts.polylines.count;
    double length = 0, inside = 0;
    bool is_outside = false;
    for (std::size_t k = 0; k + 1 < polyline.points.size(); ++k) {
      const std::array<Vector3, 2> ends{polyline.points[k], polyline.points[k + 1]};
      if (ends[0] == ends[1]) continue;
      length += norm(ends[1] - ends[0]);
      const auto directions = polyline.axes.empty() ? std::vector<Vector3>{unit_vector(ends[1] - ends[0])}
                                                    : directions_of(polyline.axes);
      is_outside |= !add_piece(ends, directions, inside);
    }
    asked_.counts.polylines.length += length;
    asked_.counts.polylines.outside_length += is_outside ? std::max(0.0, length - inside) : 0;
    asked_.counts.polylines.outside += is_outside;
  }

  void add_faces(const std::vector<Constraints::Face>& faces) {
    asked_.counts.faces.count = faces.size();
    if (faces.empty()) return;
    std::map<std::int32_t, std::vector<std::vector<Vector3>>> axes_of;
    for (const Constraints::Face& face : faces)
      axes_of[face.face].push_back(face.axes.empty() ? std::vector<Vector3>{} : directions_of(face.axes));
    std::vector<double> areas;
    const Share share = level_.share();
    for (CellIndex i = share.begin; i < share.end; ++i) {
      for (const SurfacePiece& piece : level_.pieces_of(i)) {
        const auto found = axes_of.find(solid_.surface.mesh.faces[piece.triangle]);
        if (found == axes_of.end()) continue;
        areas.push_back(piece.area);
        for (const std::vector<Vector3>& axes : found->second) add_piece(i, piece, axes);
      }
    }
    asked_.counts.faces.area = sum_of_all(share, areas);
  }

  RequestedAxes result() && { return std::move(asked_); }

 private:
  void note_outside(const Vector3& place) {
    if (!asked_.first_outside) asked_.first_outside = place;
  }

  /// Adds a piece of a polyline. Returns whether all of it is inside; adds the length inside to `inside`.
  bool add_piece(const std::array<Vector3, 2>& ends, const std::vector<Vector3>& directions, double& inside) {
    const Vector3 along = ends[1] - ends[0];
    const ClippedSegment near = clip_segment(ends, level_.tree.root().box(CellAddress::root()));
    if (near.empty()) {
      note_outside(ends[0]);
      return false;
    }
    bool all_inside = near.from == 0 && near.to == 1;
    if (!all_inside) note_outside(near.from > 0 ? ends[0] : ends[1]);
    const double length = (near.to - near.from) * norm(along);
    const int parts = std::max(1, static_cast<int>(std::ceil(length / step_)));
    for (int part = 0; part < parts; ++part) {
      const double t = near.from + (part + 0.5) / parts * (near.to - near.from);
      const Vector3 place = ends[0] + t * along;
      if (!is_inside_(place)) {
        note_outside(place);
        all_inside = false;
        continue;
      }
      inside += length / parts;
      for (const Vector3& axis : directions) asked_.polylines.push_back({place, axis, length / parts});
    }
    return all_inside;
  }

  void add_piece(CellIndex leaf, const SurfacePiece& piece, const std::vector<Vector3>& axes) {
    const Box box = level_.tree.root().box(level_.tree[leaf]);
    const Vector3 place = clip_triangle(solid_.surface.corners(piece.triangle), box).centroid;
    if (axes.empty())
      asked_.faces.push_back({place, solid_.surface.normal_at(piece.triangle, place), piece.area, leaf});
    for (const Vector3& axis : axes) asked_.faces.push_back({place, axis, piece.area, leaf});
  }

  const Solid& solid_;
  const GridLevel& level_;
  double step_;
  IsInside is_inside_;
  RequestedAxes asked_;
};

SolveReport::AngleSummary angles_of(const std::vector<AskedAxis>& asked, const PlaceSampler& sampler) {
  if (asked.empty()) return {};
  std::vector<Vector3> places;
  for (const AskedAxis& axis : asked) places.push_back(axis.place);
  const std::vector<Quaternion> frames = sampler.frames_at(places);
  std::vector<WeightedAngle> angles(asked.size());
  parallel_for(asked.size(), [&](std::size_t k) {
    angles[k] = {angle_to_nearest_axis_deg(frames[k], asked[k].direction), asked[k].weight};
  });
  return summary_of(std::move(angles));
}

/// `asked` are in own leaves. Returns the angles of all processes, in the first.
SolveReport::AngleSummary angles_on_faces(const std::vector<AskedAxis>& asked, const PlaceSampler& sampler) {
  std::vector<WeightedAngle> angles(asked.size());
  parallel_for(asked.size(), [&](std::size_t k) {
    const auto& [place, direction, weight, leaf] = asked[k];
    angles[k] = {angle_to_nearest_axis_deg(sampler.in_leaf(leaf, place), direction), weight};
  });
  return summary_of(on_first(sampler.share(), std::move(angles)));
}

}  // namespace

void check_places(const Constraints& constraints, const Box& model) {
  if (constraints.empty() || !constraints.faces.empty()) return;
  for (const Constraints::Point& point : constraints.points)
    if (has_place(model, point.at)) return;
  for (const Constraints::Stress& stress : constraints.stresses)
    if (has_place(model, stress.at)) return;
  for (const Constraints::Polyline& polyline : constraints.polylines) {
    for (std::size_t k = 0; k + 1 < polyline.points.size(); ++k)
      if (!clip_segment({polyline.points[k], polyline.points[k + 1]}, model).empty()) return;
  }
  throw Error(ErrorKind::kInput,
              message_on(constraints, 0, "constraints",
                         fmt::format("all places lie outside the model, which extends from {} to {}",
                                     words_of_place(model.low, longest_side(model)),
                                     words_of_place(model.high, longest_side(model))),
                         Remedy::kMatchUnits));
}

RequestedAxes requested_axes(const Constraints& constraints, const Solid& solid, const GridLevel& level,
                             double step) {
  // Processes that share the level answer for all places together.
  std::vector<Vector3> places;
  Collector asker(solid, level, step, [&](const Vector3& place) {
    places.push_back(place);
    return false;
  });
  asker.add(constraints);
  const std::vector<std::uint8_t> inside = are_inside(places, level.tree, level.share());
  Collector collector(solid, level, step,
                      [next = inside.begin()](const Vector3&) mutable { return *next++ != 0; });
  collector.add(constraints);
  collector.add_faces(constraints.faces);
  return std::move(collector).result();
}

SolveReport::Constraints constraint_report(const RequestedAxes& asked, const PlaceSampler& sampler) {
  SolveReport::Constraints report = asked.counts;
  report.points.angle_deg = angles_of(asked.points, sampler);
  report.polylines.angle_deg = angles_of(asked.polylines, sampler);
  report.faces.angle_deg = angles_on_faces(asked.faces, sampler);
  report.stresses.angle_deg = angles_of(asked.stresses, sampler);
  return report;
}

std::optional<Warning> outside_constraints_warning(const RequestedAxes& asked, const std::string& source) {
  if (!asked.first_outside) return std::nullopt;
  const auto& [points, polylines, faces, stresses, isotropic] = asked.counts;
  std::vector<std::string> parts;
  const auto count = [&](std::size_t outside, const std::string& all) {
    if (outside > 0) parts.push_back(fmt::format("{} of {}", outside, all));
  };
  count(points.outside, counted(points.count, "point"));
  count(stresses.outside, counted(stresses.count, "stress", "stresses"));
  count(polylines.outside, counted(polylines.count, "polyline") + " (in part)");
  return Warning(WarningKind::kConstraintsOutside,
                 {source, "",
                  fmt::format("constraints outside the solid: {}, the first at {}; they have no effect",
                              fmt::join(parts, ", "), words_of_place(*asked.first_outside))});
}

}  // namespace crossgrain
