// SPDX-License-Identifier: Apache-2.0
// A function on the sphere as a surface: in the direction u its distance from the centre is |f(u)|, and its
// colour the sign of f.
#pragma once

#include "harmonics/coefficients.hpp"
#include "picture/drawing.hpp"

namespace crossgrain::figures {

/// About the origin. D is 3 or 4.
template <int D>
DrawnMesh harmonic_shape(const Coefficients<D>& h);

}  // namespace crossgrain::figures
