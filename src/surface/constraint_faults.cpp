// SPDX-License-Identifier: Apache-2.0
#include "surface/constraint_faults.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "surface/constraint_guides.hpp"

namespace crossgrain {
namespace {

template <class Numbers>
bool all_finite(const Numbers& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

/// Throws the first fault of an item; `what` and `index` name it.
class ItemCheck {
 public:
  ItemCheck(const Constraints& constraints, const char* what, std::size_t index, std::size_t line)
      : constraints_(constraints), what_(what), index_(index), line_(line) {}

  void demand(const std::string& fault) const {
    if (fault.empty()) return;
    const std::string item = counted_from_0(("constraint " + what_).c_str(), index_);
    throw Error(ErrorKind::kInput, message_on(constraints_, line_, item, fault));
  }

 private:
  const Constraints& constraints_;
  std::string what_;
  std::size_t index_, line_;
};

}  // namespace

std::string fault_of_place(const Vector3& place) {
  const bool in_range =
      std::all_of(place.begin(), place.end(), [](double x) { return std::abs(x) < kSurfaceReach; });
  return in_range ? "" : "coordinates must be finite numbers below 1e100";
}

std::string fault_of_weight(double weight) {
  return weight > 0 && weight <= kLargestConstraintWeight ? ""
                                                          : "a weight must be a positive number up to 10000";
}

std::string fault_of_direction(const Vector3& direction) {
  if (!all_finite(direction)) return "a direction must be of finite numbers";
  return direction == Vector3{0, 0, 0} ? "a direction must not be zero" : "";
}

std::string fault_of_axes(std::span<const Vector3> axes) {
  if (axes.size() != 1 && axes.size() != 3) return "axes must be one, or the three of a frame";
  for (const Vector3& axis : axes) {
    const std::string fault = fault_of_direction(axis);
    if (!fault.empty()) return fault;
  }
  const double most = std::sin(kFrameToleranceDeg * std::numbers::pi / 180);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (std::abs(dot(unit_vector(axes[i]), unit_vector(axes[j]))) > most)
        return "the three axes of a frame must be at right angles, within 1 degree";
    }
  }
  return "";
}

std::string fault_of_polyline(std::span<const Vector3> points) {
  if (points.size() < 2) return "a polyline needs two points at least";
  const bool has_length =
      std::any_of(points.begin(), points.end(), [&](const Vector3& point) { return point != points[0]; });
  return has_length ? "" : "a polyline must not have all its points at one place";
}

std::string fault_of_tensor(const std::array<double, 6>& tensor) {
  return all_finite(tensor) ? "" : "a stress tensor must be of finite numbers";
}

Message message_on(const Constraints& constraints, std::size_t line, const std::string& item,
                   const std::string& text, Remedy remedy) {
  if (line > 0) return {constraints.source, "line " + std::to_string(line), text, remedy};
  return {constraints.source, item, text, remedy};
}

void check_constraints(const Constraints& constraints) {
  for (std::size_t i = 0; i < constraints.points.size(); ++i) {
    const Constraints::Point& point = constraints.points[i];
    const ItemCheck check(constraints, "point", i, point.line);
    check.demand(fault_of_place(point.at));
    check.demand(fault_of_axes(point.axes));
    check.demand(fault_of_weight(point.weight));
  }
  for (std::size_t i = 0; i < constraints.polylines.size(); ++i) {
    const Constraints::Polyline& polyline = constraints.polylines[i];
    const ItemCheck check(constraints, "polyline", i, polyline.line);
    for (const Vector3& point : polyline.points) check.demand(fault_of_place(point));
    check.demand(fault_of_polyline(polyline.points));
    if (!polyline.axes.empty()) check.demand(fault_of_axes(polyline.axes));
    check.demand(fault_of_weight(polyline.weight));
  }
  for (std::size_t i = 0; i < constraints.faces.size(); ++i) {
    const Constraints::Face& face = constraints.faces[i];
    const ItemCheck check(constraints, "face", i, face.line);
    if (!face.axes.empty()) check.demand(fault_of_axes(face.axes));
    check.demand(fault_of_weight(face.weight));
  }
  for (std::size_t i = 0; i < constraints.stresses.size(); ++i) {
    const Constraints::Stress& stress = constraints.stresses[i];
    const ItemCheck check(constraints, "stress", i, stress.line);
    check.demand(fault_of_place(stress.at));
    check.demand(fault_of_tensor(stress.tensor));
    check.demand(fault_of_weight(stress.weight));
  }
}

}  // namespace crossgrain
