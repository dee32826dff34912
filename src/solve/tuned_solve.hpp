// SPDX-License-Identifier: Apache-2.0
// The functions of crossgrain/solve.hpp with all that tests and sweeps set besides, and from where the
// program begins.
#pragma once

#include <functional>
#include <optional>

#include "crossgrain/solve.hpp"
#include "field/solve_tuning.hpp"

namespace crossgrain {

FrameField solve(const TriangleMesh& mesh, const SolveTuning& options, const Monitor& monitor = {});
FrameField solve_from(const FrameField& earlier, const TriangleMesh& mesh, const SolveTuning& options,
                      const Monitor& monitor = {});
SolveTuning sized_for(const TetDomain& domain, SolveTuning options);
TetFrameField carry_onto(const FrameField& field, const TetDomain& domain, const SolveTuning& options,
                         const Monitor& monitor = {});
TetFrameField solve_onto(const TetDomain& domain, const SolveTuning& options, const Monitor& monitor = {});

/// Where a field for tets begins.
struct OntoStart {
  /// Surface of the solid that the tets fill; null: their boundary.
  const TriangleMesh* surface = nullptr;

  /// The field to begin with; null: none. Only what it becomes is carried onto the tets.
  const FrameField* earlier = nullptr;

  /// Called in place of `solve`, or of `solve_from` if there is an earlier field. Whoever solves with other
  /// processes returns nothing in those that only help.
  std::function<std::optional<FrameField>(const FrameField* earlier, const TriangleMesh& surface,
                                          const SolveTuning& options, const Monitor& monitor)>
      solve;
};

/// Likewise from a start. Returns nothing if `start.solve` does. A stop after the field on the grid is
/// complete throws kInterrupted: who wants that field keeps what `start.solve` returns.
std::optional<TetFrameField> solve_onto(const TetDomain& domain, const OntoStart& start,
                                        const SolveTuning& options, const Monitor& monitor);

class Processes;
struct CheckpointFolders;

/// Processes::solve with all that tests and sweeps set besides, in the library crossgrain::processes.
struct TunedProcesses {
  static std::optional<FrameField> solve(Processes& processes, const FrameField* earlier,
                                         const TriangleMesh& mesh, const SolveTuning& options,
                                         const Monitor& monitor, const CheckpointFolders& checkpoint);
};

}  // namespace crossgrain
