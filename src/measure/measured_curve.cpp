// SPDX-License-Identifier: Apache-2.0
#include "measure/measured_curve.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Lines of a group, which are left out together if all of their length does not reach.
constexpr std::size_t kLinesInGroup = 8;

double angle_at_point(const Vector3& before, const Vector3& at, const Vector3& after) {
  const Vector3 a = at - before, b = after - at;
  return arc_tangent(norm(cross(a, b)), dot(a, b));
}

/// The nearest point of a line between two points: its share of the length.
double share_nearest(const Vector3& point, const Vector3& a, const Vector3& b) {
  const Vector3 along = b - a;
  const double square = dot(along, along);
  return square > 0 ? std::clamp(dot(point - a, along) / square, 0.0, 1.0) : 0;
}

}  // namespace

MeasuredCurve::MeasuredCurve(const FeatureComplex& complex, const FeatureComplex::Curve& curve)
    : is_closed_(curve.is_closed()) {
  for (const std::uint32_t v : curve.vertices) points_.push_back(complex.vertices[v]);
  box_ = box_of(points_);
  places_.push_back(0);
  for (std::size_t k = 1; k < points_.size(); ++k)
    places_.push_back(places_.back() + norm(points_[k] - points_[k - 1]));
  const std::size_t last = points_.size() - 1;
  std::vector<double> turns(points_.size(), 0);
  for (std::size_t k = 1; k < last; ++k)
    turns[k] = angle_at_point(points_[k - 1], points_[k], points_[k + 1]);
  if (is_closed_ && curve.corners[0] == FeatureComplex::kNone) {
    turns[0] = turns[last] = angle_at_point(points_[last - 1], points_[0], points_[1]);
  } else if (last > 1) {
    // An arc turns as much in its last line as in those before.
    turns[0] = turns[1];
    turns[last] = turns[last - 1];
  }
  turned_.push_back(0);
  for (std::size_t k = 1; k < points_.size(); ++k)
    turned_.push_back(turned_.back() + 0.5 * (turns[k - 1] + turns[k]));
}

double MeasuredCurve::within(double place) const {
  if (!is_closed_) return std::clamp(place, 0.0, length());
  const double rest = std::fmod(place, length());
  return rest < 0 ? rest + length() : rest;
}

std::size_t MeasuredCurve::line_at(double place) const {
  const auto after = std::upper_bound(places_.begin(), places_.end(), place);
  const auto index = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - places_.begin() - 1, 0));
  return std::min(index, points_.size() - 2);
}

Vector3 MeasuredCurve::at(double place) const {
  const double own = within(place);
  const std::size_t k = line_at(own);
  const double piece = places_[k + 1] - places_[k];
  const double share = piece > 0 ? std::min((own - places_[k]) / piece, 1.0) : 0;
  return points_[k] + share * (points_[k + 1] - points_[k]);
}

MeasuredCurve::Nearest MeasuredCurve::nearest(const Vector3& point, double reach) const {
  Nearest best;
  double least = reach;
  for (std::size_t first = 0; first + 1 < points_.size(); first += kLinesInGroup) {
    const std::size_t last = std::min(first + kLinesInGroup, points_.size() - 1);
    if (norm(point - points_[first]) - (places_[last] - places_[first]) > least) continue;
    for (std::size_t k = first; k < last; ++k) {
      const double share = share_nearest(point, points_[k], points_[k + 1]);
      const double distance = norm(point - (points_[k] + share * (points_[k + 1] - points_[k])));
      if (distance > reach || distance >= best.distance) continue;
      best = {places_[k] + share * (places_[k + 1] - places_[k]), distance};
      least = distance;
    }
  }
  if (is_closed_ && best.place >= length()) best.place = 0;
  return best;
}

MeasuredCurve::Nearest MeasuredCurve::nearest_between(const Vector3& point, double from, double to) const {
  Nearest best;
  const double turns = is_closed_ ? std::floor(from / length()) : 0;
  double base = turns * length();
  if (!is_closed_) {
    from = within(from);
    to = within(to);
  }
  std::size_t k = line_at(from - base);
  for (std::size_t passed = 0; passed <= 2 * points_.size(); ++passed) {
    const double begin = base + places_[k], piece = places_[k + 1] - places_[k];
    double share = share_nearest(point, points_[k], points_[k + 1]);
    if (piece > 0)
      share = std::clamp(share, std::clamp((from - begin) / piece, 0.0, 1.0),
                         std::clamp((to - begin) / piece, 0.0, 1.0));
    const double distance = norm(point - (points_[k] + share * (points_[k + 1] - points_[k])));
    if (distance < best.distance) best = {std::clamp(begin + share * piece, from, to), distance};
    if (begin + piece >= to) break;
    if (++k + 1 < points_.size()) continue;
    if (!is_closed_) break;
    k = 0;
    base += length();
  }
  return best;
}

double MeasuredCurve::turned_until(double place) const {
  const std::size_t k = line_at(place);
  const double piece = places_[k + 1] - places_[k];
  const double share = piece > 0 ? std::min((place - places_[k]) / piece, 1.0) : 0;
  return turned_[k] + share * (turned_[k + 1] - turned_[k]);
}

double MeasuredCurve::turn_rad(double from, double to) const {
  if (!is_closed_) return turned_until(within(to)) - turned_until(within(from));
  const double rounds = std::floor(to / length()) - std::floor(from / length());
  return rounds * turned_.back() + turned_until(within(to)) - turned_until(within(from));
}

}  // namespace crossgrain
