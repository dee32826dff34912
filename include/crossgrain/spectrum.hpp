// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup fields Fields
/// @{

/// A surface normal and its weight, an area or any other positive number.
struct WeightedNormal {
  Vector3 normal;  ///< any length except zero
  double weight;
};

/// The quadratic form E(h) = h^T A h - 2 b.h + c of a set of normals: the deviation of coefficients h, in the
/// order m = -degree ... degree, from a frame with an axis along each normal (arXiv 2309.13477).
struct SpectrumReport {
  int degree;
  std::vector<std::vector<double>> matrix;  ///< A, 7 x 7 or 9 x 9
  std::vector<double> eigenvalues;          ///< eigenvalues of A, ascending, not divided by the weight
  std::vector<std::vector<double>>
      null_space;              ///< after the shift; degree 4: a point, then orthonormal directions
  std::vector<double> linear;  ///< b; zeros in degree 3
  double constant;             ///< c; zero in degree 3
};

/// Returns the coefficients of frames in real orthonormal spherical harmonics, in the order m = -degree ...
/// degree: 7 (degree 3) or 9 (degree 4) numbers for each, of unit length. The 24 triples of axes of a frame
/// have the same coefficients; in degree 3 up to sign.
std::vector<double> coefficients_of(std::span<const Frame> frames, Degree degree);

/// Returns the form of a sum of weighted normals. Throws Error(kUsage) for an empty list, a zero or
/// non-finite normal, or a weight that is not positive and finite.
SpectrumReport spectrum_of_normals(std::span<const WeightedNormal> normals, Degree degree);

/// Returns the form of a shape: "plane" (normal z), "cube" (normals x, y, z, weight 3), "cylinder" (about z)
/// or "sphere" (both of weight 1, integrated exactly). Throws Error(kUsage) for any other name.
SpectrumReport spectrum_of_preset(std::string_view name, Degree degree);

/// @}

}  // namespace crossgrain
