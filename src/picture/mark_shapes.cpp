// SPDX-License-Identifier: Apache-2.0
#include "picture/mark_shapes.hpp"

#include <cstddef>

namespace crossgrain {
namespace {

/// Adds a ring of corners around a unit vector, `count` of them with the cosine and sine of one step.
std::vector<Vector3> ring(const Vector3& axis, double radius, int count, double cosine, double sine) {
  const Vector3 first = orthogonal_unit(axis), second = cross(axis, first);
  std::vector<Vector3> corners;
  double x = radius, y = 0;
  for (int k = 0; k < count; ++k) {
    corners.push_back(x * first + y * second);
    const double next = cosine * x - sine * y;
    y = sine * x + cosine * y;
    x = next;
  }
  return corners;
}

}  // namespace

void add_disc(const Vector3& centre, const Vector3& across, double radius, double thickness,
              const Colour& colour, std::vector<Facet>& facets) {
  // 24 corners: cos and sin of 15 degrees, so that pictures do not depend on the library of functions.
  const std::vector<Vector3> rim = ring(across, radius, 24, 0.96592582628906829, 0.25881904510252076);
  const Vector3 up = centre + (0.5 * thickness) * across, down = centre - (0.5 * thickness) * across;
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const Vector3 &a = rim[k], &b = rim[(k + 1) % rim.size()];
    facets.push_back({{up, up + a, up + b}, colour});
    facets.push_back({{down, down + b, down + a}, colour});
    facets.push_back({{up + a, down + a, down + b}, colour});
    facets.push_back({{up + a, down + b, up + b}, colour});
  }
}

void add_double_pyramid(const Vector3& centre, const Vector3& along, double radius, double length,
                        const Colour& colour, std::vector<Facet>& facets) {
  const std::vector<Vector3> square = ring(along, radius, 4, 0, 1);
  const Vector3 up = centre + (0.5 * length) * along, down = centre - (0.5 * length) * along;
  for (std::size_t k = 0; k < square.size(); ++k) {
    const Vector3 a = centre + square[k], b = centre + square[(k + 1) % square.size()];
    facets.push_back({{up, a, b}, colour});
    facets.push_back({{down, b, a}, colour});
  }
}

void add_cube(const Vector3& centre, double side, const Colour& colour, std::vector<Facet>& facets) {
  const double half = 0.5 * side;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Vector3 normal{0, 0, 0}, u{0, 0, 0}, v{0, 0, 0};
      normal[axis] = sign * half;
      u[(axis + 1) % 3] = sign * half;
      v[(axis + 2) % 3] = half;
      const Vector3 face = centre + normal;
      facets.push_back({{face - u - v, face + u - v, face + u + v}, colour});
      facets.push_back({{face - u - v, face + u + v, face - u + v}, colour});
    }
  }
}

}  // namespace crossgrain
