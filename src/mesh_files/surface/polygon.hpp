// SPDX-License-Identifier: Apache-2.0
// Triangulates polygonal faces.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// Triangulates polygons in the plane of their mean (Newell) normal: convex ones as a fan about their first
/// corner, others by ear clipping. A polygon of n corners gives n - 2 triangles of its corners, with its
/// orientation. Their areas add up to its own if it is planar and does not cross itself; otherwise the
/// triangulation is arbitrary.
class PolygonTriangulator {
 public:
  /// Maximum number of corner tests per file, about half a second. Ear clipping takes about n^2 for n
  /// corners, so a single polygon of 10,000 corners is possible.
  static constexpr std::size_t kEarTests = 200'000'000;

  explicit PolygonTriangulator(std::size_t ear_tests = kEarTests) : ear_tests_left_(ear_tests) {}

  /// Appends the triangles of a polygon of three or more corners, as indices into `vertices`. Returns false,
  /// with nothing appended, once the ear tests are used up.
  bool triangulate(std::span<const std::uint32_t> corners, const std::vector<Vector3>& vertices,
                   std::vector<std::array<std::uint32_t, 3>>& triangles);

 private:
  using Point = std::array<double, 2>;

  void project(std::span<const std::uint32_t> corners, const std::vector<Vector3>& vertices);
  bool is_convex() const;
  bool clip_ears(std::span<const std::uint32_t> corners,
                 std::vector<std::array<std::uint32_t, 3>>& triangles);
  bool is_ear(std::size_t corner);
  double turn(std::size_t corner) const;
  std::size_t flattest_corner(std::size_t any);
  void unlink(std::size_t corner);
  void count_test() {
    if (ear_tests_left_ > 0) --ear_tests_left_;
  }

  std::size_t ear_tests_left_;
  // The current polygon: its corners in the plane, counter-clockwise, and the ring of the remaining ones.
  std::vector<Point> points_;
  std::vector<std::size_t> next_, previous_;
  std::vector<bool> convex_;
};

}  // namespace crossgrain
