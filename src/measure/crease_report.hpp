// SPDX-License-Identifier: Apache-2.0
// The creases of a surface, and how well a field runs along them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "crossgrain/report.hpp"
#include "sampling/sampling.hpp"
#include "surface/creases.hpp"

namespace crossgrain {

/// All that is known of the creases of a surface before the solve.
struct CreaseNetwork {
  std::vector<CreaseCurve> curves;
  std::vector<CreaseCorner> corners;
  KnifeEdges knives;

  /// Those that the mesh brings along; where it brings none, its sharp edges, those of `inner` faces and
  /// those where they meet the surface.
  CreaseNetwork(const Surface& surface, const TriangleMesh& inner, const CreaseAngles& angles,
                bool inside_out);
};

/// Angles are taken at the middles of pieces of curves no longer than `step`, model units.
SolveReport::Creases crease_report(const CreaseNetwork& creases, const Sampler& sampler, double step);

/// Warnings of places where no frame is near to all faces.
std::vector<Warning> crease_warnings(const CreaseNetwork& creases);

}  // namespace crossgrain
