// SPDX-License-Identifier: Apache-2.0
// The camera of a picture: a parallel projection, so that lengths and line widths are the same near and far.
#pragma once

#include <span>

#include "base/vector3.hpp"

namespace crossgrain {

/// An upright view of a model. Angles are given as if its z axis pointed up.
struct ViewDirection {
  double azimuth_deg;    ///< direction of the viewer about +z, from +x towards +y
  double elevation_deg;  ///< elevation of the viewer above the xy plane, -90 to 90

  /// Axis of the model that points up. If y, the model's z axis replaces -y; if x, its y axis replaces x.
  int up_axis = 2;
};

/// Right-handed axes of the picture, as vectors of the model.
struct ViewAxes {
  Vector3 right, up, towards;  ///< unit vectors; `towards` the viewer

  explicit ViewAxes(const ViewDirection& direction);
};

/// A part of a picture, in pixels from its upper left corner.
struct PixelBox {
  double left, top, right, bottom;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

class Camera {
 public:
  /// Makes the points fill `window` except for a margin, a share of its shorter side. Needs at least one
  /// point.
  Camera(const ViewDirection& direction, std::span<const Vector3> points, const PixelBox& window,
         double margin = 0.04);

  const ViewAxes& axes() const { return axes_; }

  /// Size of a pixel, model units.
  double pixel_size() const { return pixel_size_; }

  /// Extent of the points along `axes().towards`.
  double nearest() const { return nearest_; }
  double farthest() const { return farthest_; }

  /// The model point of a pixel position, in the plane through the origin across the view.
  Vector3 point_at(double x, double y) const;

  /// The pixel position of a point, with its height along `axes().towards`, in model units, as third
  /// coordinate.
  Vector3 project(const Vector3& point) const;

 private:
  ViewAxes axes_;
  double pixel_size_ = 1;
  double origin_x_ = 0, origin_y_ = 0;  ///< pixel position of the model's origin
  double nearest_ = 0, farthest_ = 0;
};

}  // namespace crossgrain
