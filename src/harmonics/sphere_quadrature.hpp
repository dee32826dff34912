// SPDX-License-Identifier: Apache-2.0
// Exact means of polynomials over the circle and the sphere.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "base/vector3.hpp"

namespace crossgrain {

struct QuadraturePoint {
  Vector3 direction;  ///< a unit vector
  double weight;      ///< all weights of a rule sum to 1
};

/// Quadrature rule for the mean over the circle about z, exact for polynomials up to `Degree`.
template <int Degree>
std::array<QuadraturePoint, Degree + 1> circle_quadrature() {
  std::array<QuadraturePoint, Degree + 1> rule{};
  for (int i = 0; i <= Degree; ++i) {
    const double phi = 2 * std::numbers::pi * i / (Degree + 1);
    rule[i] = {{std::cos(phi), std::sin(phi), 0}, 1.0 / (Degree + 1)};
  }
  return rule;
}

/// Nodes and weights (summing to 1) of the Gauss-Legendre rule with Count nodes on [-1, 1]: exact up to
/// degree 2 Count - 1.
template <int Count>
std::array<std::array<double, 2>, Count> gauss_legendre() {
  std::array<std::array<double, 2>, Count> rule{};
  for (int i = 0; i < Count; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (Count + 0.5));  // asymptotic node, accurate to 1e-3
    double slope = 1;
    for (int iteration = 0; iteration < 6; ++iteration) {  // Newton doubles the digits: 4 suffice
      double previous = 1, value = x;
      for (int k = 2; k <= Count; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * previous) / k;
        previous = value;
        value = next;
      }
      slope = Count * (x * value - previous) / (x * x - 1);
      x -= value / slope;
    }
    rule[i] = {x, 1 / ((1 - x * x) * slope * slope)};
  }
  return rule;
}

/// Quadrature rule for the mean over the sphere, exact for polynomials up to `Degree`: Gauss-Legendre in z
/// times circles.
template <int Degree>
std::array<QuadraturePoint, (Degree / 2 + 1) * (Degree + 1)> sphere_quadrature() {
  std::array<QuadraturePoint, (Degree / 2 + 1) * (Degree + 1)> rule{};
  std::size_t next = 0;
  for (const auto& [z, ring_weight] : gauss_legendre<Degree / 2 + 1>()) {
    const double radius = std::sqrt(1 - z * z);
    for (const auto& [direction, weight] : circle_quadrature<Degree>()) {
      rule[next++] = {{radius * direction[0], radius * direction[1], z}, ring_weight * weight};
    }
  }
  return rule;
}

}  // namespace crossgrain
