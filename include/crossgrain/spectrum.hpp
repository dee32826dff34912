// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// A surface normal and how much it counts: an area, or any positive number.
struct WeightedNormal {
  Vector3 normal;  ///< of any length but zero
  double weight;
};

/// The quadratic form E(h) = h^T A h - 2 b.h + c that says how far coefficients h, in the order m = -degree
/// ... degree, are from a frame with an axis along each of some normals (arXiv 2309.13477).
struct SpectrumReport {
  int degree;
  std::vector<std::vector<double>> matrix;  ///< A, 7 x 7 or 9 x 9
  std::vector<double> eigenvalues;          ///< of A, ascending, not divided by the weight
  std::vector<std::vector<double>>
      null_space;              ///< after the shift; degree 4: a point, then orthonormal directions
  std::vector<double> linear;  ///< b; zeros in degree 3
  double constant;             ///< c; zero in degree 3
};

/// The form of a sum of weighted normals. Throws Error(kUsage) for an empty list, a zero or non-finite
/// normal, or a weight that is not positive and finite.
SpectrumReport spectrum_of_normals(std::span<const WeightedNormal> normals, Degree degree);

/// The form of a shape: "plane" (normal z), "cube" (normals x, y, z, weight 3), "cylinder" (about z) and
/// "sphere" (both of weight 1, integrated exactly). Throws Error(kUsage) for another name.
SpectrumReport spectrum_of_preset(std::string_view name, Degree degree);

}  // namespace crossgrain
