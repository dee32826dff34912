// SPDX-License-Identifier: Apache-2.0
// Parts of a surface of quads between paths of edges.
#pragma once

#include <cstdint>
#include <vector>

#include "fit/feature_loops.hpp"
#include "fit/quad_complex.hpp"

namespace crossgrain {

/// Quads that are connected over edges of no path, between the same two solids.
struct QuadPart {
  std::vector<std::uint32_t> quads;  ///< ascending
  int euler = 0;                     ///< with its border, as FeatureComplex::Face::euler
  std::vector<FeatureLoop> loops;    ///< of its border, from their least steps on, ascending

  /// Whether it ends at edges of no path, where not just two quads between its solids meet.
  bool is_torn = false;
};

/// Returns the parts of a surface between the paths of curves, by their first quads. A curve whose path is
/// empty has none.
std::vector<QuadPart> parts_between(const QuadComplex& surface,
                                    const std::vector<std::vector<std::uint32_t>>& path_of_curve);

}  // namespace crossgrain
