// SPDX-License-Identifier: Apache-2.0
// Where segments cross triangles, with the cases that rounding cannot tell set apart.
//
// Notation: c the corners, n = (c1 - c0) x (c2 - c0); a and b the ends, d = b - a. The segment crosses the
// plane where n.(a - c0) and n.(b - c0) differ in sign, and its line passes inside where the three volumes
// d.((p - a) x (q - a)) over the edges pq have the same sign.
#pragma once

#include <array>
#include <cmath>

#include "base/lanes.hpp"
#include "base/vector3.hpp"

namespace crossgrain {

/// Change of the winding number through a triangle along segments that begin at one point.
class CrossingsFrom {
 public:
  /// No segment is longer than `reach` along any axis. If the triangle covers all of its plane that they can
  /// reach, as a large one does in a small cell, only crossings of the plane are tested.
  CrossingsFrom(const std::array<Vector3, 3>& corners, const Vector3& begin, double reach = INFINITY);

  /// `change` is +1 if the segment to an end crosses the triangle against its normal (by the right-hand rule
  /// over its corners), so that it enters the solid, -1 along the normal, and 0 if it misses. It is not
  /// `certain` if the segment passes an edge, or begins or ends at the triangle's plane, so closely that
  /// rounding in double precision could change the result.
  template <class Real>
  struct Change {
    using Mask = decltype(Real() > Real());
    Real change;
    Mask certain;
  };

  /// Real is double, or several doubles side by side (base/lanes.hpp).
  template <class Real>
  Change<Real> to(const BasicVector3<Real>& end) const;

 private:
  /// Bound of the rounding of a triple product of differences, in units of the product of their lengths:
  /// about twelve roundings of 1.1e-16 each.
  static constexpr double kRounding = 4e-15;

  template <class Real>
  static BasicVector3<Real> in_all_lanes(const Vector3& v) {
    return {in_every_lane<Real>(v.data()), in_every_lane<Real>(v.data() + 1),
            in_every_lane<Real>(v.data() + 2)};
  }
  template <class Real>
  static Real length(const BasicVector3<Real>& v) {
    using std::abs;
    return abs(v[0]) + abs(v[1]) + abs(v[2]);
  }

  Vector3 begin_, corner_, normal_;
  std::array<Vector3, 3> edge_normals_;     ///< (p - a) x (q - a)
  std::array<double, 3> edge_sizes_;        ///< |p - a| |q - a|, times the rounding
  double plane_size_ = 0;                   ///< of the normal, times the rounding
  double side_ = 0;                         ///< of `begin`: -1, 1, or 0 if rounding decides
  bool covers_ = false;                     ///< no segment can pass the triangle's edges
  std::array<double, 8> read_beyond_ = {};  ///< so that lanes can be filled from any of the numbers above
};

template <class Real>
CrossingsFrom::Change<Real> CrossingsFrom::to(const BasicVector3<Real>& end) const {
  using std::abs;
  using Mask = typename Change<Real>::Mask;
  const BasicVector3<Real> from_corner = end - in_all_lanes<Real>(corner_);
  const Real height = dot(in_all_lanes<Real>(normal_), from_corner);
  const Real height_noise = in_every_lane<Real>(&plane_size_) * length(from_corner);
  const Mask above = height > height_noise, below = height < -height_noise;
  const Real side = in_every_lane<Real>(&side_);
  const Mask begins_above = side > 0.0, begins_below = side < 0.0;
  const Mask same_side = Mask((begins_above & above) | (begins_below & below));
  if (all(same_side)) return {0.0, same_side};
  if (covers_) {
    const Mask crossed = Mask((begins_above & below) | (begins_below & above));
    return {select(crossed, side, Real(0.0)), Mask(same_side | crossed)};
  }

  const BasicVector3<Real> direction = end - in_all_lanes<Real>(begin_);
  const Real reach = length(direction);
  std::array<Mask, 3> left, right;
  for (std::size_t k = 0; k < 3; ++k) {
    const Real volume = dot(direction, in_all_lanes<Real>(edge_normals_[k]));
    const Real noise = in_every_lane<Real>(&edge_sizes_[k]) * reach;
    left[k] = volume > noise;
    right[k] = volume < -noise;
  }
  const Mask passes_by = Mask(Mask(left[0] | left[1] | left[2]) & Mask(right[0] | right[1] | right[2]));
  const Mask missed = Mask(same_side | passes_by);
  // Neither ruled out nor certain. A flat triangle is never certain, and never crossed.
  const Mask inside = Mask(Mask(left[0] & left[1] & left[2]) | Mask(right[0] & right[1] & right[2]));
  const Mask crossed = Mask(inside & Mask(above | below) & Mask(begins_above | begins_below) & Mask(!missed));
  return {select(crossed, side, Real(0.0)), Mask(missed | crossed)};
}

}  // namespace crossgrain
