// SPDX-License-Identifier: Apache-2.0
// The surface of a model with several solids as one set of triangles, each face between two solids once.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "surface/surface.hpp"

namespace crossgrain {

struct FeatureSurface {
  /// Without inner faces. Vertices as given; triangles use the first of equal ones.
  Surface surface;

  std::vector<std::array<std::int32_t, 2>> solids;  ///< FeatureComplex::Face::below and above, per triangle
  std::vector<std::uint32_t> source_of;             ///< index in the given surface, per triangle
};

/// Returns the triangles of a surface, of a pair between solids (`split_solids`) that of the higher solid. If
/// the solids are united, without pairs and their creases.
FeatureSurface feature_surface(const Surface& surface, bool unite_solids);

}  // namespace crossgrain
