// SPDX-License-Identifier: Apache-2.0
// Eigenvalues and eigenvectors of a form's matrix.
#pragma once

#include "constraint/quadratic_form.hpp"

namespace crossgrain {

template <int D>
struct Spectrum {
  Coefficients<D> eigenvalues;                                     ///< ascending, not divided by the weight
  std::array<Coefficients<D>, kCoefficientCount<D>> eigenvectors;  ///< orthonormal, in the same order
};

/// The spectrum of A. Accurate to rounding of the largest eigenvalue.
template <int D>
Spectrum<D> spectrum(const QuadraticForm<D>& form);

}  // namespace crossgrain
