// SPDX-License-Identifier: Apache-2.0
// Operation counts of geometry, counted by hand from its formulas, which are written in doubles with
// branches.
#pragma once

namespace crossgrain::bench {

/// surface/clipping.cpp: a triangle whose plane or extent misses the box. Two edges 6, their product 9, half
/// sides and offset 15, four lengths 8, the reach 5, the slack 4, the distance 5.
inline constexpr double kRejectedClipFlops = 52;

/// A triangle that is clipped: the same, plus two crossings of 12 for each of about three planes, plus a fan
/// of three triangles with two edges 6, product 9, length 6 and moment 10.
inline constexpr double kClipFlops = kRejectedClipFlops + 2 * 3 * 12 + 3 * 31;

/// surface/segment_crossing.hpp, once for a triangle and all segments from one point: edges 6, their product
/// 9, lengths and bound 6, the vector to the point 3, its distance 5, length and bound 3. Whether the
/// triangle covers its plane, for each of the one or two edges that decide it: two vectors 6, a product 9, a
/// distance 5, lengths and bound 7. Then the vectors to the corners 9, their lengths 6, and for each edge a
/// product 9 and a bound 2.
inline constexpr double kCrossingTriangleFlops = 32 + 1.5 * 27 + 15 + 3 * 11;

/// For each segment: the vector to its end 3, its distance 5, length and bound 3, the sum 1. If the ends are
/// on different sides (one in five in cells of the bracket and the torus), also the direction 3, its length
/// 2, and for each edge a volume 5 and a bound 1.
inline constexpr double kCrossingEndFlops = 12 + 0.2 * (5 + 3 * 6);

/// Returns the operations of one of `ends` segments from one point, with its share of the triangle. A
/// triangle that covers its plane takes the three tests of 27 and nothing for edges, about a fifth less,
/// which is ignored.
constexpr double crossing_flops(int ends) {
  return kCrossingTriangleFlops / ends + kCrossingEndFlops;
}

/// surface/winding_number.cpp: the vector to a cluster 3, its square 5.
inline constexpr double kClusterFlops = 8;

/// A cluster far away: squares and inverse 6, dipole 5, quadrupole 14, octupole 36, sum 8.
inline constexpr double kFarClusterFlops = 69;

/// A triangle nearby: three edges 9, their lengths 18, numerator 14, denominator 25, the product of complex
/// numbers that sums angles 6.
inline constexpr double kNearTriangleFlops = 72;

}  // namespace crossgrain::bench
