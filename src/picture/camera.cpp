// SPDX-License-Identifier: Apache-2.0
#include "picture/camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace crossgrain {
namespace {

/// Exact at multiples of a right angle, so that views along an axis show faces along it as lines.
double sine_deg(double angle_deg) {
  const double quarters = std::remainder(angle_deg, 360.0) / 90;
  if (quarters == std::round(quarters)) return quarters == 1 ? 1 : quarters == -1 ? -1 : 0;
  return std::sin(angle_deg * std::numbers::pi / 180);
}
double cosine_deg(double angle_deg) {
  return sine_deg(angle_deg + 90);
}

/// A vector of a model whose z axis points up, in one where it is another.
Vector3 in_model(const Vector3& v, int up_axis) {
  if (up_axis == 0) return {v[2], v[0], v[1]};
  if (up_axis == 1) return {v[0], v[2], -v[1]};
  return v;
}

}  // namespace

ViewAxes::ViewAxes(const ViewDirection& direction) {
  const double cosine = cosine_deg(direction.azimuth_deg), sine = sine_deg(direction.azimuth_deg);
  const double level = cosine_deg(direction.elevation_deg), height = sine_deg(direction.elevation_deg);
  towards = {level * cosine, level * sine, height};
  right = {-sine, cosine, 0};
  up = cross(towards, right);
  for (Vector3* axis : {&right, &up, &towards}) *axis = in_model(*axis, direction.up_axis);
}

Camera::Camera(const ViewDirection& direction, std::span<const Vector3> points, const PixelBox& window,
               double margin)
    : axes_(direction) {
  Box seen = empty_box();
  for (const Vector3& point : points)
    include(seen, {dot(point, axes_.right), dot(point, axes_.up), dot(point, axes_.towards)});
  const auto& [low, high] = seen;
  const double border = margin * std::min(window.width(), window.height());
  pixel_size_ = std::max((high[0] - low[0]) / std::max(window.width() - 2 * border, 1.0),
                         (high[1] - low[1]) / std::max(window.height() - 2 * border, 1.0));
  if (!(pixel_size_ > 0)) pixel_size_ = 1;
  origin_x_ = 0.5 * (window.left + window.right) - 0.5 * (low[0] + high[0]) / pixel_size_;
  origin_y_ = 0.5 * (window.top + window.bottom) + 0.5 * (low[1] + high[1]) / pixel_size_;
  nearest_ = high[2];
  farthest_ = low[2];
}

Vector3 Camera::point_at(double x, double y) const {
  return pixel_size_ * (x - origin_x_) * axes_.right + pixel_size_ * (origin_y_ - y) * axes_.up;
}

Vector3 Camera::project(const Vector3& point) const {
  return {origin_x_ + dot(point, axes_.right) / pixel_size_, origin_y_ - dot(point, axes_.up) / pixel_size_,
          dot(point, axes_.towards)};
}

}  // namespace crossgrain
