// SPDX-License-Identifier: Apache-2.0
#include "constraint/classification.hpp"

#include <algorithm>

#include "constraint/spectrum.hpp"

namespace crossgrain {

ConstraintClass classify(const QuadraticForm<3>& form, const ClassificationTolerances& tolerances) {
  if (!(form.weight > 0)) return ConstraintClass::kFree;
  const Coefficients<3> eigenvalues = spectrum(form).eigenvalues;
  const double smallest = eigenvalues[0] / form.weight;
  const auto multiplicity = std::count_if(eigenvalues.begin(), eigenvalues.end(), [&](double eigenvalue) {
    return eigenvalue / form.weight <= smallest + tolerances.same_eigenvalue;
  });
  const bool fits = smallest <= tolerances.fits;
  switch (multiplicity) {
    case 7:
      return ConstraintClass::kFree;
    case 2:
      return fits ? ConstraintClass::kPlane : ConstraintClass::kAxis;
    case 1:
      return fits ? ConstraintClass::kFrame : ConstraintClass::kFrameCompromised;
    default:
      return ConstraintClass::kConflicted;
  }
}

bool compatible(ConstraintClass constraint_class) {
  return constraint_class == ConstraintClass::kPlane || constraint_class == ConstraintClass::kFrame;
}

}  // namespace crossgrain
