// SPDX-License-Identifier: Apache-2.0
#include "shape_spectra.hpp"

#include <cmath>
#include <numbers>

#include "constraint/normal_form.hpp"
#include "constraint/spectrum.hpp"

namespace crossgrain::figures {
namespace {

/// Forms of degree 3 are polynomials of degree 6 in the normal, so that these rules integrate them exactly.
constexpr int kDegreeInNormal = 6;

}  // namespace

ShapeSpectrum spectrum_of(std::span<const QuadraturePoint> normals) {
  QuadraticForm<3> form;
  for (const QuadraturePoint& normal : normals) add_normal(form, normal.direction, normal.weight);
  return {scaled(spectrum(form).eigenvalues, 1 / form.weight), classify(form)};
}

ShapeSpectrum plane_spectrum() {
  return spectrum_of(std::array<QuadraturePoint, 1>{{{{0, 0, 1}, 1}}});
}

ShapeSpectrum crease_spectrum(double angle_deg) {
  const double half = angle_deg * std::numbers::pi / 360, x = std::cos(half), y = std::sin(half);
  return spectrum_of(std::array<QuadraturePoint, 2>{{{{x, y, 0}, 1}, {{x, -y, 0}, 1}}});
}

ShapeSpectrum corner_spectrum() {
  return spectrum_of(std::array<QuadraturePoint, 3>{{{{1, 0, 0}, 1}, {{0, 1, 0}, 1}, {{0, 0, 1}, 1}}});
}

ShapeSpectrum cylinder_spectrum() {
  return spectrum_of(circle_quadrature<kDegreeInNormal>());
}

ShapeSpectrum sphere_spectrum() {
  return spectrum_of(sphere_quadrature<kDegreeInNormal>());
}

const char* name_of(ConstraintClass constraint_class) {
  switch (constraint_class) {
    case ConstraintClass::kFree:
      return "free";
    case ConstraintClass::kPlane:
      return "plane";
    case ConstraintClass::kAxis:
      return "axis";
    case ConstraintClass::kFrame:
      return "frame";
    case ConstraintClass::kFrameCompromised:
      return "frame, compromised";
    case ConstraintClass::kConflicted:
      break;
  }
  return "conflicted";
}

}  // namespace crossgrain::figures
