// SPDX-License-Identifier: Apache-2.0
// The arithmetic of geometry, which is written in doubles and branches, counted by hand from its formulas.
#pragma once

namespace crossgrain::bench {

/// surface/clipping.cpp: a triangle that its plane or its extent tells apart from the box. Two edges 6, their
/// product 9, half sides and offset 15, four lengths 8, the reach 5, the slack 4, the distance 5.
inline constexpr double kRejectedClipFlops = 52;

/// A triangle that is clipped: the same; two crossings of 12 for each of about three planes; a fan of three
/// triangles with two edges 6, product 9, length 6 and moment 10.
inline constexpr double kClipFlops = kRejectedClipFlops + 2 * 3 * 12 + 3 * 31;

/// surface/segment_crossing.hpp, once for a triangle and all segments from one point: edges 6, their product
/// 9, lengths and bound 6, the way to the point 3, its distance 5, length and bound 3; whether the triangle
/// covers its plane, for each of the one or two edges that settle it two ways 6, a product 9, a distance 5,
/// lengths and bound 7; and then the ways to the corners 9, their lengths 6, and for each edge a product 9
/// and a bound 2.
inline constexpr double kCrossingTriangleFlops = 32 + 1.5 * 27 + 15 + 3 * 11;

/// For each segment: the way to its end 3, its distance 5, length and bound 3, the sum 1; and where the ends
/// are on different sides, as one in five is in cells of the bracket and the torus, the direction 3, its
/// length 2, and for each edge a volume 5 and a bound 1.
inline constexpr double kCrossingEndFlops = 12 + 0.2 * (5 + 3 * 6);

/// One of `ends` segments from one point, and its share of the triangle. A triangle that covers its plane
/// takes the three tests of 27 and nothing for edges, which comes to a fifth less: that is not told apart.
constexpr double crossing_flops(int ends) {
  return kCrossingTriangleFlops / ends + kCrossingEndFlops;
}

/// surface/winding_number.cpp: the way to a cluster 3, its square 5.
inline constexpr double kClusterFlops = 8;

/// A cluster far away: squares and inverse 6, dipole 5, quadrupole 14, octupole 36, sum 8.
inline constexpr double kFarClusterFlops = 69;

/// A triangle nearby: three edges 9, their lengths 18, numerator 14, denominator 25, the product of complex
/// numbers that sums angles 6.
inline constexpr double kNearTriangleFlops = 72;

}  // namespace crossgrain::bench
