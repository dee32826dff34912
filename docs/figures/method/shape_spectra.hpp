// SPDX-License-Identifier: Apache-2.0
// What the degree-3 form of the surface in a cell knows, for a few shapes (docs/design.md section 3).
#pragma once

#include <array>
#include <span>

#include "base/vector3.hpp"
#include "constraint/classification.hpp"
#include "harmonics/sphere_quadrature.hpp"

namespace crossgrain::figures {

struct ShapeSpectrum {
  Coefficients<3> eigenvalues;  ///< ascending, over the weight: 0 to 1
  ConstraintClass constraint_class;
};

/// Of normals that share the weight by theirs.
ShapeSpectrum spectrum_of(std::span<const QuadraturePoint> normals);

ShapeSpectrum plane_spectrum();

/// Two faces of equal area whose normals are that far apart; the normals are x turned half of it about z both
/// ways.
ShapeSpectrum crease_spectrum(double angle_deg);

/// Three faces at right angles, of equal area.
ShapeSpectrum corner_spectrum();

/// The round side of a cylinder.
ShapeSpectrum cylinder_spectrum();

ShapeSpectrum sphere_spectrum();

/// As docs/report.md calls it.
const char* name_of(ConstraintClass constraint_class);

}  // namespace crossgrain::figures
