// SPDX-License-Identifier: Apache-2.0
// The frame that minimises a form.
#pragma once

#include "base/quaternion.hpp"
#include "constraint/quadratic_form.hpp"

namespace crossgrain {

/// The frame at the minimum of E(h(R)) near `start`, by guarded Newton steps on so(3).
template <int D>
Quaternion refine_minimising_frame(const QuadraticForm<D>& form, const Quaternion& start, int max_steps = 30);

/// The frame at the minimum of E(h(R)) over all rotations R, from several starts that depend on the form
/// only. If several frames are equally good it is one of them.
template <int D>
Quaternion minimising_frame(const QuadraticForm<D>& form);

}  // namespace crossgrain
