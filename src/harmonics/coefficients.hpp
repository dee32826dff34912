// SPDX-License-Identifier: Apache-2.0
// A homogeneous harmonic polynomial of degree D by its coefficients in the real orthonormal spherical
// harmonics, order m = -D ... D. This is the one place that knows how they are laid out.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

namespace crossgrain {

/// 7 for octupoles (degree 3), 9 for degree 4.
template <int D>
inline constexpr int kCoefficientCount = 2 * D + 1;

/// Coefficients in the order m = -D ... D. Here as in all of the arithmetic that sweeps are made of, Real is
/// double, or several doubles side by side (base/lanes.hpp).
template <int D, class Real = double>
using Coefficients = std::array<Real, kCoefficientCount<D>>;

/// Where the coefficient of order m stands.
template <int D>
constexpr int index_of_order(int m) {
  return m + D;
}

template <class Real, std::size_t N>
Real dot(const std::array<Real, N>& a, const std::array<Real, N>& b) {
  Real sum = 0;
  for (std::size_t i = 0; i < N; ++i) sum += a[i] * b[i];
  return sum;
}

template <class Real, std::size_t N>
Real squared_norm(const std::array<Real, N>& a) {
  return dot(a, a);
}

template <class Real, std::size_t N>
std::array<Real, N> scaled(const std::array<Real, N>& a, const std::type_identity_t<Real>& factor) {
  std::array<Real, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = factor * a[i];
  return result;
}

/// a += factor * b.
template <class Real, std::size_t N>
void add_scaled(std::array<Real, N>& a, const std::type_identity_t<Real>& factor,
                const std::array<Real, N>& b) {
  for (std::size_t i = 0; i < N; ++i) a[i] += factor * b[i];
}

/// a - b.
template <class Real, std::size_t N>
std::array<Real, N> difference(const std::array<Real, N>& a, const std::array<Real, N>& b) {
  std::array<Real, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = a[i] - b[i];
  return result;
}

}  // namespace crossgrain
