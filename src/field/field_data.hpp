// SPDX-License-Identifier: Apache-2.0
// The data of a solved field, as they are written to and read from files.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/quaternion.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/types.hpp"
#include "field/kept_forms.hpp"
#include "field/solved_surface.hpp"
#include "grid/octree.hpp"
#include "grid/share.hpp"

namespace crossgrain {

/// All vectors have one entry per leaf of `tree`. Of a field that processes share, each has its own leaves,
/// and the first the report and the singularities of the whole.
struct FieldData {
  Degree degree = Degree::kFour;
  Octree tree;
  std::vector<StoredQuaternion> frames;
  std::vector<std::uint8_t> open_faces;     ///< as in LeafConnections: bit f for an edge through face f
  std::vector<std::uint8_t> on_boundary;    ///< 1 if the leaf contains surface
  std::vector<float> energy_density;        ///< smoothness energy per volume, in (model unit)^-2
  std::vector<float> alignment_deg;         ///< mean angle between normal and nearest axis, by area; 0 inside
  std::vector<CellConstraint> constraints;  ///< empty in a field read from a file without them
  std::vector<std::int32_t> regions;        ///< as CellRegions::of_leaf; empty with a single region
  SolveReport report;

  /// Surface that the field was solved for; none in a field read from a folder without one.
  SurfaceSource surface;

  /// Empty unless SolveOptions::for_page; always empty in a field that was read.
  KeptForms kept_forms;

  /// Null in a field that was read; computed on demand.
  std::shared_ptr<const SingularityGraph> singularities;

  /// Set if leaves below a level of the octree have been merged into their ancestors (output_cells).
  struct Merged {
    std::uint64_t from;  ///< leaves before, of all processes
    int level;
  };
  std::optional<Merged> merged;

  /// Which leaves of the field these are, if processes share it.
  Share part;

  Share share() const { return share_of(part, tree.size()); }
};

/// Removes the leaves that the process does not own, and their values.
void leave_own_leaves(FieldData& data);

/// Moves leaves between processes that share a field, so that those in one cell of a depth are in one
/// process, the first of those that have some. All call it together, after leave_own_leaves.
void unite_cells(FieldData& data, int depth);

/// Numbers the leaves of all processes anew, after those of some have changed. All call it together.
void renumber(FieldData& data);

/// Moves the leaves of all processes that share a field to the first, which has the whole field then; others
/// have none. All call it together.
void move_to_first(FieldData& data);

}  // namespace crossgrain
