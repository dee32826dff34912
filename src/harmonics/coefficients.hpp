// SPDX-License-Identifier: Apache-2.0
// Coefficients of a homogeneous harmonic polynomial of degree D in the real orthonormal spherical harmonics,
// order m = -D ... D. Only this file knows their layout.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

namespace crossgrain {

/// Number of coefficients: 7 for octupoles (degree 3), 9 for degree 4.
template <int D>
inline constexpr int kCoefficientCount = 2 * D + 1;

/// Coefficients in the order m = -D ... D. Real is double, or several doubles side by side (base/lanes.hpp),
/// here and in all arithmetic of the sweeps.
template <int D, class Real = double>
using Coefficients = std::array<Real, kCoefficientCount<D>>;

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
