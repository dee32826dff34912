// SPDX-License-Identifier: Apache-2.0
// The form of a whole frame.
#pragma once

#include "constraint/quadratic_form.hpp"
#include "harmonics/frame.hpp"

namespace crossgrain {

/// form += weight * |h - g|^2 with g = h(R); degree 3: weight * (|h|^2 - (g.h)^2), since -g is the same
/// frame.
template <int D>
void add_frame(QuadraticForm<D>& form, const Quaternion& rotation, double weight) {
  const Coefficients<D> g = frame_coefficients<D>(rotation);
  add_identity(form, weight);
  if constexpr (D == 3) {
    add_outer_product(form, -weight, g);
  } else {
    add_scaled(form.linear, weight, g);
    form.constant += weight;
  }
  form.weight += weight;
}

}  // namespace crossgrain
