// SPDX-License-Identifier: Apache-2.0
// The best frame for normals that are nearly parallel, as on a curved part with fine facets, by a formula.
//
// Notation: n a normal, m the mean one, z = n.u + i n.v its part across m. A frame with the axes m and e,
// e at the angle f from u, has
//
//   E_n = 20/3 |z|^2 + (a - 35/24 cos 4 (arg z - f)) |z|^4 + O(z^6).
//
// The first term is least for the mean of the normals, whatever f; the second, for 4 f = arg sum w z^4.
#pragma once

#include <array>
#include <complex>
#include <optional>

#include "base/quaternion.hpp"
#include "base/vector3.hpp"

namespace crossgrain {

/// Sums over unit normals with weights; n and -n count as the same. The first normal is the one that all
/// should be near.
class ParallelNormals {
 public:
  explicit ParallelNormals(const Vector3& first);

  void add(const Vector3& normal, double weight);

  /// The frame whose sum of weight * E_n is the least, to a share of seven times the fourth power of
  /// the largest angle between a normal and the first (2.5 times where they spread to all sides; normals in
  /// one plane are the worst); nothing if that is above kLargestAngle.
  std::optional<Quaternion> best_frame() const;

  /// In radians: the least value is met to a share of 7e-4.
  static constexpr double kLargestAngle = 0.1;

 private:
  using Complex = std::complex<double>;

  Vector3 first_, u_, v_;
  Vector3 sum_{0, 0, 0};
  std::array<Complex, 5> moments_{};  ///< sums of weight * z^k, z across the first normal
  double largest_ = 0;                ///< |z|^2
};

}  // namespace crossgrain
