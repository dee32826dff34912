// SPDX-License-Identifier: Apache-2.0
// Points spread over a triangle.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/vector3.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// Pieces of a triangle along an edge at most.
inline constexpr int kMostPiecesOfTriangle = 64;

/// Triangles so many times as long as high are cut across only as far as they need it: of a cylinder of
/// thousands of facets, each of these would have as many pieces along its height as along its length.
inline constexpr int kSliver = 4;

/// Calls add(point, share) for the middles of rows of pieces along the first edge of a triangle, with their
/// shares of its area.
template <class Add>
void for_each_in_rows(const std::array<Vector3, 3>& corners, int columns, int rows, const Add& add) {
  const auto& [a, b, c] = corners;
  for (int j = 0; j < rows; ++j) {
    const double low = static_cast<double>(j) / rows, high = (j + 1.0) / rows, middle = (low + high) / 2;
    // The width of the triangle at the middle of the row times its height.
    const double share = 2 * (1 - middle) * (high - low);
    for (int i = 0; i < columns; ++i)
      add(a + ((1 - middle) * (i + 0.5) / columns) * (b - a) + middle * (c - a), share / columns);
  }
}

/// Calls add(point, share) for the centres of pieces^2 equal pieces of a triangle.
template <class Add>
void for_each_piece(const std::array<Vector3, 3>& corners, int pieces, const Add& add) {
  const auto& [a, b, c] = corners;
  const double share = 1.0 / (pieces * pieces);
  const auto add_at = [&](double u, double v) {
    add(a + (u / pieces) * (b - a) + (v / pieces) * (c - a), share);
  };
  for (int i = 0; i < pieces; ++i) {
    for (int j = 0; i + j < pieces; ++j) {
      add_at(i + 1.0 / 3, j + 1.0 / 3);
      if (i + j + 1 < pieces) add_at(i + 2.0 / 3, j + 2.0 / 3);
    }
  }
}

/// Calls add(point, weight) for points of a triangle about `spacing` apart, or farther for long ones
/// (kMostPiecesOfTriangle). Weights add up to its area; corners have none.
template <class Add>
void for_each_sample(std::array<Vector3, 3> corners, double spacing, const Add& add) {
  std::array<double, 3> lengths;
  for (std::size_t k = 0; k < 3; ++k) lengths[k] = norm(corners[(k + 1) % 3] - corners[k]);
  const auto longest = std::ranges::max_element(lengths);
  const double area = norm(cross(corners[1] - corners[0], corners[2] - corners[0])) / 2;
  const auto count_in = [&](double length) {
    return static_cast<int>(std::clamp(std::ceil(length / spacing), 1.0, 1.0 * kMostPiecesOfTriangle));
  };
  const int along = count_in(*longest), across = count_in(*longest > 0 ? 2 * area / *longest : 0);
  const auto add_share = [&](const Vector3& point, double share) { add(point, share * area); };
  if (along < kSliver * across) {
    for_each_piece(corners, along, add_share);
  } else {
    std::ranges::rotate(corners, corners.begin() + (longest - lengths.begin()));
    for_each_in_rows(corners, along, across, add_share);
  }
  for (const Vector3& corner : corners) add_share(corner, 0);
}

}  // namespace crossgrain
