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

/// surface/segment_crossing.cpp: edges 6, their product 9, both ends 6, two distances 10, lengths and bounds
/// 13; and in the half of cases where the ends are on different sides the direction 3, the corners 9, and for
/// each edge a product 9, a volume 5 and a bound 9.
inline constexpr double kCrossingFlops = 44 + 0.5 * (12 + 3 * 23);

/// surface/winding_number.cpp: the way to a cluster 3, its square 5.
inline constexpr double kClusterFlops = 8;

/// A cluster far away: squares and inverse 6, dipole 5, quadrupole 14, octupole 36, sum 8.
inline constexpr double kFarClusterFlops = 69;

/// A triangle nearby: three edges 9, their lengths 18, numerator 14, denominator 25, the product of complex
/// numbers that sums angles 6.
inline constexpr double kNearTriangleFlops = 72;

}  // namespace crossgrain::bench
