// SPDX-License-Identifier: Apache-2.0
// What a field is made of once it is solved, and what is written to and read from files.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/quaternion.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/types.hpp"
#include "field/cell_constraint.hpp"
#include "field/solved_surface.hpp"
#include "grid/octree.hpp"
#include "page/shown_cells.hpp"

namespace crossgrain {

/// All vectors have one entry per leaf of `tree`.
struct FieldData {
  Degree degree = Degree::kFour;
  Octree tree;
  std::vector<StoredQuaternion> frames;
  std::vector<std::uint8_t> open_faces;     ///< as in LeafConnections: which neighbours a leaf is joined to
  std::vector<std::uint8_t> on_boundary;    ///< 1 where the leaf holds surface
  std::vector<float> energy_density;        ///< smoothness energy per volume, model units to the power of -2
  std::vector<float> alignment_deg;         ///< mean angle between normal and nearest axis, by area; 0 inside
  std::vector<CellConstraint> constraints;  ///< empty in a field read from a file that has none
  std::vector<std::int32_t> regions;        ///< as CellRegions::of_leaf; empty where there are not several
  SolveReport report;

  /// What was solved with; none in a field read from a folder that has none.
  SurfaceSource surface;

  /// None in a field that was read.
  ShownForms shown_forms;

  /// Null in a field that was read: made when asked for.
  std::shared_ptr<const SingularityGraph> singularities;
};

}  // namespace crossgrain
