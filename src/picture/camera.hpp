// SPDX-License-Identifier: Apache-2.0
// Where a picture is seen from: in parallel projection, so that lengths and line weights are the same near
// and far.
#pragma once

#include <span>

#include "base/vector3.hpp"

namespace crossgrain {

/// An upright view of a model. Angles are as if its z axis pointed up.
struct ViewDirection {
  double azimuth_deg;    ///< of the viewer about +z, from +x towards +y
  double elevation_deg;  ///< of the viewer above the xy plane, -90 to 90
  int up_axis = 2;       ///< of the model; where it is y, its z axis stands for -y, where it is x, y for x
};

/// Right-handed axes of the picture in the model.
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
  /// So that the points fill `window` but for a margin, a share of its shorter side. At least one point.
  Camera(const ViewDirection& direction, std::span<const Vector3> points, const PixelBox& window,
         double margin = 0.04);

  const ViewAxes& axes() const { return axes_; }

  /// Model units.
  double pixel_size() const { return pixel_size_; }

  /// Extent of the points along `axes().towards`.
  double nearest() const { return nearest_; }
  double farthest() const { return farthest_; }

  /// The point at a place of the picture, in pixels, in the plane through the origin across the view.
  Vector3 point_at(double x, double y) const;

  /// Where a point is in the picture, in pixels; third its height along `axes().towards`, model units.
  Vector3 project(const Vector3& point) const;

 private:
  ViewAxes axes_;
  double pixel_size_ = 1;
  double origin_x_ = 0, origin_y_ = 0;  ///< pixels, of the model's origin
  double nearest_ = 0, farthest_ = 0;
};

}  // namespace crossgrain
