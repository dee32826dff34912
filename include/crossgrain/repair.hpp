// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "crossgrain/monitor.hpp"
#include "crossgrain/tet_frame_field.hpp"

namespace crossgrain {

/// \addtogroup solving Solving
/// @{

/// How matchings are repaired.
struct RepairOptions {
  /// Whether vertices of prepared tets (TetDomain::prepared_for_map; not of a field that was read) may move,
  /// those inside and in flat parts of the surface, so that arcs run straight. The result then has a domain
  /// of its own.
  bool moves_vertices = true;

  /// Largest memory of the process in bytes; 0 for nine tenths of what the machine or the container has.
  std::size_t max_memory_bytes = 0;
};

/// Returns the field with matchings that hexahedra can follow, as far as they were found, and with frames
/// smoothed for them. Matchings, singular graph, report and files are those of the repair; the report has a
/// section about it (SolveReport::Onto::repair) and the answer about the repaired field. The mesh is the
/// same, but for vertices of prepared tets (RepairOptions::moves_vertices). The method follows Liu and Bommes
/// 2023 ("Locally Meshable Frame Fields") in what is demanded of edges and vertices, not in how it is found.
/// The same to the bit for any number of threads.
///
/// Frames keep to walls between regions and tagged edges, though matchings are judged at the outer boundary
/// only.
///
/// Errors: as `check_repairable`; kUsage for a field with constraints, which smoothed frames would leave;
/// kLimit if the memory does not suffice; kInterrupted by the monitor.
TetFrameField repaired(const TetFrameField& field, const RepairOptions& options = {},
                       const Monitor& monitor = {});

/// Throws Error(kInput) for a mesh that `repaired` refuses: with tets without volume or duplicates, which
/// leave gaps that no matching crosses, or with tets that overlap.
void check_repairable(const TetDomain& domain);

/// @}

}  // namespace crossgrain
