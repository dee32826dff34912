// SPDX-License-Identifier: Apache-2.0
// The creases of a surface, and the alignment of a field with them.
#pragma once

#include <optional>
#include <vector>

#include "crossgrain/report.hpp"
#include "sampling/places.hpp"
#include "surface/creases.hpp"

namespace crossgrain {

/// The creases of a surface, as known before the solve.
struct CreaseNetwork {
  std::vector<CreaseCurve> curves;
  std::vector<CreaseCorner> corners;
  KnifeEdges knives;
  std::optional<Warning> faded;  ///< `faded_crease_warning`, of a mesh without creases

  /// Takes the creases of the mesh; if it has none, its sharp edges, those of `inner` faces and those where
  /// they meet the surface.
  CreaseNetwork(const Surface& surface, const TriangleMesh& inner, const CreaseAngles& angles,
                bool inside_out);
};

/// The section `creases` of the report, with angles at the middles of pieces of curves no longer than `step`,
/// model units.
SolveReport::Creases crease_report(const CreaseNetwork& creases, const PlaceSampler& sampler, double step);

/// Warnings about creases that fade out, and places where no frame fits all faces.
std::vector<Warning> crease_warnings(const CreaseNetwork& creases);

}  // namespace crossgrain
