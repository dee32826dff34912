// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "constraint/quadratic_form.hpp"

namespace crossgrain {

/// The spectral shift of degree 4 in full: the largest t such that E - t plus some combination of the 15
/// quadratics that vanish on all frames (|h|^2 - 1, the five of D, the nine of (h x h)_4 - c h) is nowhere
/// negative, to 1e-7 of the weight, and that combination. t never exceeds the minimum of E over frames, and
/// nearly always equals it. About a millisecond. Needs form.weight > 0.
QuadraticForm<4> log_det_shifted(const QuadraticForm<4>& form);

}  // namespace crossgrain
