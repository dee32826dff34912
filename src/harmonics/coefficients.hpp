// SPDX-License-Identifier: Apache-2.0
// A homogeneous harmonic polynomial of degree D by its coefficients in the real orthonormal spherical
// harmonics, order m = -D ... D. This is the one place that knows how they are laid out.
#pragma once

#include <array>
#include <cstddef>

namespace crossgrain {

/// 7 for octupoles (degree 3), 9 for degree 4.
template <int D>
inline constexpr int kCoefficientCount = 2 * D + 1;

/// Coefficients in the order m = -D ... D.
template <int D>
using Coefficients = std::array<double, kCoefficientCount<D>>;

/// Where the coefficient of order m stands.
template <int D>
constexpr int index_of_order(int m) {
  return m + D;
}

template <std::size_t N>
double dot(const std::array<double, N>& a, const std::array<double, N>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < N; ++i) sum += a[i] * b[i];
  return sum;
}

template <std::size_t N>
double squared_norm(const std::array<double, N>& a) {
  return dot(a, a);
}

template <std::size_t N>
std::array<double, N> scaled(const std::array<double, N>& a, double factor) {
  std::array<double, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = factor * a[i];
  return result;
}

/// a += factor * b.
template <std::size_t N>
void add_scaled(std::array<double, N>& a, double factor, const std::array<double, N>& b) {
  for (std::size_t i = 0; i < N; ++i) a[i] += factor * b[i];
}

/// a - b.
template <std::size_t N>
std::array<double, N> difference(const std::array<double, N>& a, const std::array<double, N>& b) {
  std::array<double, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = a[i] - b[i];
  return result;
}

}  // namespace crossgrain
