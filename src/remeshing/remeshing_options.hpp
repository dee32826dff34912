// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crossgrain/tet_making.hpp"

namespace crossgrain {

/// How a surface is cut into new triangles.
struct Remeshing : RemeshingOptions {
  double size = 0;  ///< largest edge, model units
};

}  // namespace crossgrain
