// SPDX-License-Identifier: Apache-2.0
// The spectral shift: a form that penalises only what its constraints really exclude (docs/design.md section
// 3).
#pragma once

#include "constraint/quadratic_form.hpp"

namespace crossgrain {

/// The form without what no frame could avoid. On exact frames of unit norm it differs from `form` by a
/// constant only; it is never negative, and (nearly always) zero exactly on the frames that minimise `form`,
/// so that relaxed h are drawn to those and a form all of whose frames are alike vanishes. The weight is
/// kept. Degree 3: A - (smallest eigenvalue) I. Degree 4: multiples of the quadratics that vanish on all
/// frames are added too.
template <int D>
QuadraticForm<D> shifted(const QuadraticForm<D>& form);

}  // namespace crossgrain
