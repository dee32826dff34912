// SPDX-License-Identifier: Apache-2.0
// Fields on further grids inside a tet mesh, from which its own may come.
#pragma once

#include <cstddef>
#include <vector>

#include "base/quaternion.hpp"
#include "crossgrain/tet_domain.hpp"
#include "crossgrain/types.hpp"
#include "field/solve_tuning.hpp"

namespace crossgrain {

/// Frames of the vertices of a tet mesh, as carried_frames has them.
struct StartFrames {
  std::size_t number = 0;  ///< k for the k-th of OntoTuning::other_starts, from 1
  std::vector<Quaternion> frames;
};

/// Returns the frames of each of `options.onto.other_starts` that the mesh can use; none at all where
/// OntoTuning says so. `box` is that of the solid of the field on the grid. Only the thread's WatchedLoops
/// can end it.
std::vector<StartFrames> other_starts(const TetDomain& domain, const Box& box, const SolveTuning& options);

}  // namespace crossgrain
