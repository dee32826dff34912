// SPDX-License-Identifier: Apache-2.0
// Hexahedra of any mesher put onto a model, and judged.
#pragma once

#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/hex_report.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/warning.hpp"
#include "fit/feature_fit.hpp"
#include "surface/feature_complex.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// A model that hexahedra are put onto.
struct FittingModel {
  /// Its tets; or no tets, but the triangles around them as `boundary`, with TetMesh::given.
  TetSolid solid;
  FeatureComplex features;
};

/// Returns a model without tets. `given` has the faces and the crease angle.
FittingModel fitting_model(GivenModel given);

/// Throws Error(kUsage) for corners that are no vertices and for regions of only some, and Error(kInput) if
/// there are no hexahedra, or if their boundary is no closed surface, with counts.
void check_fittable(const HexMesh& mesh);

/// Throws Error(kInput) if the box around hexahedra is not about that of the model, as where units differ.
void check_same_place(const HexMesh& mesh, const FittingModel& model);

/// Returns the median of the edges of hexahedra.
double median_edge(const HexMesh& mesh);

/// Puts hexahedra of about `sizes.edge`, which pass these checks, onto a model. The mesh gets boundary and
/// tags. The report has everything but attempts; `warnings` get what to know besides. Throws
/// Error(kInterrupted) for a stop before anything was tried.
HexReport fit_to_model(const FittingModel& model, const FitSizes& sizes, FitWays ways, const Monitor& monitor,
                       HexMesh& mesh, std::vector<Warning>& warnings);

}  // namespace crossgrain
