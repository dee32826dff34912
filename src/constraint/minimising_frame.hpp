// SPDX-License-Identifier: Apache-2.0
// The frame that a form likes best.
#pragma once

#include "base/quaternion.hpp"
#include "constraint/quadratic_form.hpp"

namespace crossgrain {

/// The minimum of E(h(R)) near `start`, by guarded Newton steps on so(3).
template <int D>
Quaternion refine_minimising_frame(const QuadraticForm<D>& form, const Quaternion& start, int max_steps = 30);

/// The minimum of E(h(R)) over all rotations R, from several starts that depend on the form only. Where
/// several frames are equally good it is one of them.
template <int D>
Quaternion minimising_frame(const QuadraticForm<D>& form);

}  // namespace crossgrain
