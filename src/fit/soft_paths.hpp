// SPDX-License-Identifier: Apache-2.0
// Soft curves beside those that are embedded.
#pragma once

#include <cstdint>
#include <vector>

#include "fit/coarser_features.hpp"
#include "fit/embedding.hpp"

namespace crossgrain {

/// What is embedded of features without their soft curves.
struct SharpPaths {
  const CoarserFeatures& sharp;                           ///< the features without soft curves
  std::vector<std::uint32_t> vertex_of_corner;            ///< of `sharp`; kNowhere without
  std::vector<std::vector<std::uint32_t>> path_of_curve;  ///< of `sharp`; empty without
};

/// Embeds the soft curves of `features` for which near, straight paths are left, takes the others out of it,
/// and returns the embedding of the rest with its faces. A path is straight if two quads or more lie on both
/// sides of each vertex inside.
Embedding with_soft_paths(const HexMesh& mesh, const QuadComplex& surface, FeatureComplex& features,
                          const SharpPaths& embedded, double size);

}  // namespace crossgrain
