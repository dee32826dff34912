// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace crossgrain {

/// Share at which a straight path from share 0 to 1 enters the points nearer to a convex set than `radius`; 1
/// if it does not. distance(share) is the distance of a point of the path from the set.
template <class Distance>
double tube_entry(const Distance& distance, double radius) {
  constexpr int kHalvings = 30;  // a share to 1e-9
  constexpr double kGolden = 0.6180339887498949;
  if (distance(0.0) <= radius) return 0;
  // The distance to a convex set is convex along the path: find its minimum by golden section, unless the end
  // is inside, and then the point of entry.
  double inside = 1;
  if (distance(1.0) > radius) {
    double low = 0, high = 1;
    for (int k = 0; k < kHalvings && distance(0.5 * (low + high)) > radius; ++k) {
      const double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
      (distance(a) < distance(b) ? high : low) = distance(a) < distance(b) ? b : a;
    }
    inside = 0.5 * (low + high);
    if (distance(inside) > radius) return 1;
  }
  double outside = 0;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (outside + inside);
    (distance(middle) > radius ? outside : inside) = middle;
  }
  return inside == 1 ? std::nextafter(1.0, 0.0) : inside;
}

}  // namespace crossgrain
