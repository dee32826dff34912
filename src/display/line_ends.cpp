// SPDX-License-Identifier: Apache-2.0
#include "display/line_ends.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace crossgrain {
namespace {

/// Distance within which an end is on the surface, in cells: rounding.
constexpr double kOnSurface = 1e-6;

/// Least part of a line that stays as it is.
constexpr double kKeptShare = 0.5;

class End {
 public:
  End(LineEnd end, double cell_size, const SolidRays& rays, const LineEndOptions& options)
      : points_(std::move(end.points)),
        axes_(std::move(end.axes)),
        cell_size_(cell_size),
        rays_(rays),
        options_(options) {
    measure();
    most_ = std::min(options_.most_replaced * cell_size_, (1 - kKeptShare) * lengths_.back());
  }

  /// Cuts off what is outside beyond the last place where the line leaves the solid.
  void cut_off() {
    for (std::size_t k = 0; k + 1 < points_.size() && lengths_[k + 1] <= most_; ++k) {
      const Vector3 step = points_[k] - points_[k + 1];
      const auto hit = rays_.first_hit(points_[k + 1], normalised(step), norm(step));
      if (!hit) continue;
      if (!hit->is_exit) return;
      most_ -= lengths_[k];
      cut_ = k + 1;
      points_.erase(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(k));
      axes_.erase(axes_.begin(), axes_.begin() + static_cast<std::ptrdiff_t>(std::min(k, axes_.size())));
      points_.front() = hit->place;
      measure();
      return;
    }
  }

  StraightEnd straightened() const {
    for (std::size_t k = 0; k < points_.size() && lengths_[k] <= most_; ++k)
      if (const auto place = straight_ahead(k)) return ended_at(*place, k);
    return ended_at(extension().value_or(points_.front()), 0);
  }

 private:
  void measure() {
    lengths_.assign(1, 0);
    for (std::size_t k = 1; k < points_.size(); ++k)
      lengths_.push_back(lengths_.back() + norm(points_[k] - points_[k - 1]));
  }

  Vector3 point_at(double length) const {
    const auto above = std::upper_bound(lengths_.begin(), lengths_.end(), length);
    if (above == lengths_.end()) return points_.back();
    const auto k = static_cast<std::size_t>(above - lengths_.begin());
    const double share = (length - lengths_[k - 1]) / (lengths_[k] - lengths_[k - 1]);
    return points_[k - 1] + share * (points_[k] - points_[k - 1]);
  }

  /// Direction of the line over a length behind a point, outwards.
  Vector3 direction_at(std::size_t k) const {
    return normalised(points_[k] - point_at(lengths_[k] + options_.direction_length * cell_size_));
  }

  /// Whether the line before a point runs in a direction over twice the length of `direction_at`.
  bool is_straight_before(std::size_t k, const Vector3& direction) const {
    const double reach = options_.direction_length * cell_size_;
    if (lengths_[k] + reach >= lengths_.back()) return true;
    const Vector3 before = point_at(lengths_[k] + reach) - point_at(lengths_[k] + 2 * reach);
    return dot(normalised(before), direction) >= options_.straight_cosine;
  }

  /// Mean of the axes of points from k up to a length, turned along a direction; zero without axes.
  Vector3 mean_axis(std::size_t k, double length, const Vector3& direction) const {
    Vector3 sum{0, 0, 0};
    for (; k < axes_.size() && lengths_[k] <= length; ++k)
      sum += dot(axes_[k], direction) < 0 ? -axes_[k] : axes_[k];
    return normalised(sum);
  }

  /// Whether the axes before point k point along a direction, in the mean over those below the surface layer.
  bool agree_before(std::size_t k, const Vector3& direction) const {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < std::min(k, axes_.size()); ++i) {
      if (axes_[i] == Vector3{0, 0, 0}) continue;
      if (rays_.nearest(points_[i]).distance < options_.surface_layer * cell_size_) continue;
      sum += std::abs(dot(axes_[i], direction));
      count += 1;
    }
    return sum >= options_.along_cosine * count;
  }

  /// Where the line that goes on straight from point k meets the surface; none if it should not.
  std::optional<Vector3> straight_ahead(std::size_t k) const {
    const Vector3 direction = direction_at(k);
    if (direction == Vector3{0, 0, 0}) return std::nullopt;
    const Vector3 axis = mean_axis(k, lengths_[k] + options_.direction_length * cell_size_, direction);
    const bool has_axis = axis != Vector3{0, 0, 0};
    if (has_axis ? dot(axis, direction) < options_.along_cosine : k > 0) return std::nullopt;
    if (k > 0 && !is_straight_before(k, direction)) return std::nullopt;
    if (!agree_before(k, direction)) return std::nullopt;
    std::optional<SolidRays::Hit> hit =
        rays_.first_hit(points_[k], direction, lengths_[k] + options_.most_ahead * cell_size_);
    if (k == 0 && is_on_surface()) hit = rays_.nearest(points_[k]);
    if (!hit || dot(hit->normal, direction) < options_.steep_sine) return std::nullopt;
    if (k == 0 ? !is_of_nearest_face(*hit) : is_across_wall(*hit)) return std::nullopt;
    return hit->place;
  }

  /// Whether a place straight ahead of the end is on the face that is nearest to the end. In a thin wall it
  /// may be on the other side.
  bool is_of_nearest_face(const SolidRays::Hit& hit) const {
    return hit.distance * options_.steep_sine <=
           rays_.nearest(points_.front()).distance + kOnSurface * cell_size_;
  }

  bool is_across_wall(const SolidRays::Hit& hit) const {
    return dot(rays_.nearest(points_.front()).normal, hit.normal) < options_.facing_cosine;
  }

  bool is_on_surface() const { return rays_.nearest(points_.front()).distance <= kOnSurface * cell_size_; }

  std::optional<Vector3> extension() const {
    if (is_on_surface()) return std::nullopt;
    const Vector3 direction = direction_at(0);
    if (direction != Vector3{0, 0, 0}) {
      const auto hit = rays_.first_hit(points_.front(), direction, options_.most_ahead * cell_size_);
      if (hit && hit->is_exit && is_of_nearest_face(*hit)) return hit->place;
    }
    const SolidRays::Hit nearest = rays_.nearest(points_.front());
    if (nearest.distance <= options_.most_ahead * cell_size_) return nearest.place;
    return std::nullopt;
  }

  /// The end from a place to point k, with points about a cell apart.
  StraightEnd ended_at(const Vector3& place, std::size_t k) const {
    StraightEnd end;
    const Vector3 way = points_[k] - place;
    const auto count = static_cast<int>(std::ceil(norm(way) / cell_size_ - kOnSurface));
    for (int i = 0; i < count; ++i) end.points.push_back(place + (static_cast<double>(i) / count) * way);
    if (cut_ == 0) {
      end.next = k;
    } else {
      if (k == 0) end.points.push_back(points_.front());
      end.next = cut_ + (k == 0 ? 0 : k - 1);
    }
    return end;
  }

  std::vector<Vector3> points_, axes_;
  std::vector<double> lengths_;  ///< along the line from its end to each point
  double cell_size_;
  double most_ = 0;      ///< largest length of what is replaced
  std::size_t cut_ = 0;  ///< number of points of the line that were cut off; then the first one is new
  const SolidRays& rays_;
  const LineEndOptions& options_;
};

}  // namespace

StraightEnd straight_end(const LineEnd& end, double cell_size, const SolidRays& rays,
                         const LineEndOptions& options) {
  End line(end, cell_size, rays, options);
  line.cut_off();
  return line.straightened();
}

}  // namespace crossgrain
