// SPDX-License-Identifier: Apache-2.0
// Points of a model's surface that pull the nearest quads of hexahedra: what lies between vertices, a narrow
// fillet or a rounded edge, is followed so, not cut off.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fit/hex_carriers.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

struct SurfaceSample {
  Vector3 point;
  std::uint32_t group;
  double area;  ///< of the surface that it stands for
};

/// Returns points on all faces, about `spacing` apart.
std::vector<SurfaceSample> surface_samples(const FeatureComplex& complex,
                                           const std::vector<std::uint32_t>& group_of_face, double spacing);

/// Pulls the point sum of shares[k] * places[vertices[k]] along `direction`, to where its product with it is
/// `target`: with the energy weight * (difference)^2.
struct QuadPull {
  std::array<std::uint32_t, 3> vertices;
  std::array<double, 3> shares;
  Vector3 direction;
  double target;
  double weight;  ///< the area of the sample, in squared sizes

  double difference(const std::vector<Vector3>& places) const;
};

/// Returns the pulls of those samples from which the nearest quad of their group is farther than a share of
/// the size, kUnfelt, and nearer than one; they pull as far as it.
std::vector<QuadPull> quad_pulls(const std::vector<SurfaceSample>& samples, const HexMesh& mesh,
                                 const HexCarriers& carriers, double size);

}  // namespace crossgrain
