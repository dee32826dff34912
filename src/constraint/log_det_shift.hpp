// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "constraint/quadratic_form.hpp"

namespace crossgrain {

/// The complete spectral shift of degree 4: E - t plus a combination of the 15 quadratics that vanish on all
/// frames (|h|^2 - 1, the five of D, the nine of (h x h)_4 - c h), nowhere negative, with the largest such t,
/// to 1e-7 of the weight. t never exceeds the minimum of E over frames, and nearly always equals it. Takes
/// about a millisecond. Needs form.weight > 0.
QuadraticForm<4> log_det_shifted(const QuadraticForm<4>& form);

}  // namespace crossgrain
