// SPDX-License-Identifier: Apache-2.0
// A feature curve by its length: points, turns, and nearest points on stretches of it.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "crossgrain/types.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

/// Places on a curve are lengths from its first point. On a closed curve any number is a place, counted
/// around it; on an open one places beyond an end are the end.
class MeasuredCurve {
 public:
  MeasuredCurve(const FeatureComplex& complex, const FeatureComplex::Curve& curve);

  double length() const { return places_.back(); }
  bool is_closed() const { return is_closed_; }
  const Box& box() const { return box_; }

  Vector3 at(double place) const;

  struct Nearest {
    double place = 0, distance = INFINITY;
  };

  /// Returns the nearest point; on a closed curve 0 <= place < length. `reach`: points farther off need not
  /// be found.
  Nearest nearest(const Vector3& point, double reach = INFINITY) const;

  /// Returns the nearest point of a stretch, from < to, of at most one length of a closed curve.
  Nearest nearest_between(const Vector3& point, double from, double to) const;

  /// Returns by how much the curve turns on a stretch, in radians. The turn at each of its points is spread
  /// over half the lines beside it.
  double turn_rad(double from, double to) const;

 private:
  /// Index of the line, and the place in it, of a place in [0, length].
  std::size_t line_at(double place) const;
  double within(double place) const;
  double turned_until(double place) const;

  std::vector<Vector3> points_;
  std::vector<double> places_;  ///< of the points
  std::vector<double> turned_;  ///< from the first point to each
  bool is_closed_;
  Box box_;
};

}  // namespace crossgrain
