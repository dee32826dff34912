// SPDX-License-Identifier: Apache-2.0
// The spectral shift: a form that penalises only what its constraints exclude (docs/design.md section 3).
#pragma once

#include "base/quaternion.hpp"
#include "base/vector3.hpp"
#include "constraint/quadratic_form.hpp"

namespace crossgrain {

/// The form minus the energy that no frame can avoid. On exact frames of unit norm it differs from `form` by
/// a constant only; it is never negative, and (nearly always) zero exactly on the frames that minimise
/// `form`, so that relaxed h are drawn to those and a form with equal energy on all frames vanishes. The
/// weight is kept. Degree 3: A - (smallest eigenvalue) I. Degree 4: multiples of the quadratics that vanish
/// on all frames are added too.
template <int D>
QuadraticForm<D> shifted(const QuadraticForm<D>& form);

/// The smallest value of the form over all frames. The search begins at `start`, which affects only the time:
/// all frames are searched unless a shifted form that is nowhere negative proves the minimum found from there
/// to be the global one (true of 19 of 20 cells).
double least_value(const QuadraticForm<4>& form, const Quaternion& start);

/// The smallest value of weight_a E_a + weight_b E_b over all frames for two unit vectors, by a formula. The
/// best frames have both vectors in one of their coordinate planes: found by search over all angles and
/// shares, not proven (tests/constraint/spectral_shift_test.cpp).
double least_value_of_two(const Vector3& a, double weight_a, const Vector3& b, double weight_b);

}  // namespace crossgrain
