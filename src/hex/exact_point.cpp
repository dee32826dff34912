// SPDX-License-Identifier: Apache-2.0
#include "hex/exact_point.hpp"

#include <algorithm>
#include <cstddef>

namespace crossgrain {
namespace {

using Axis = std::array<Int128, 3>;

Axis exact_cross(const Axis& a, const Axis& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Whether the cube, centred at the origin with sides of 2 units, lies on one side of the triangle along an
/// axis. Lengths are twice as long as given, so that the centre is whole.
bool separates(const Axis& axis, const std::array<Axis, 3>& triangle) {
  Int128 low = 0, high = 0, reach = 0;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    Int128 at = 0;
    for (std::size_t k = 0; k < 3; ++k) at += axis[k] * triangle[corner][k];
    low = corner == 0 ? at : std::min(low, at);
    high = corner == 0 ? at : std::max(high, at);
  }
  for (const Int128 part : axis) reach += (part < 0 ? -part : part) * kGridUnit;
  if (reach == 0) return false;  // no axis
  return low >= reach || high <= -reach;
}

}  // namespace

bool meets_open_cell(const std::array<ExactPoint, 3>& triangle, const ExactPoint& low) {
  std::array<Axis, 3> corners{};
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (std::size_t k = 0; k < 3; ++k) corners[corner][k] = 2 * (triangle[corner][k] - low[k]) - kGridUnit;
  std::array<Axis, 3> edges{};
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (std::size_t k = 0; k < 3; ++k)
      edges[corner][k] = triangle[(corner + 1) % 3][k] - triangle[corner][k];
  for (std::size_t k = 0; k < 3; ++k) {
    Axis unit{0, 0, 0};
    unit[k] = 1;
    if (separates(unit, corners)) return false;
    for (const Axis& edge : edges)
      if (separates(exact_cross(edge, unit), corners)) return false;
  }
  return !separates(exact_cross(edges[0], edges[1]), corners);
}

}  // namespace crossgrain
