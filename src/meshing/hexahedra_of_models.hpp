// SPDX-License-Identifier: Apache-2.0
// Hexahedra of models with a tuning: for tests and bench.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "crossgrain/hex_meshing.hpp"
#include "hex/hex_tuning.hpp"
#include "tet_making/tet_making_tuning.hpp"

namespace crossgrain {

/// Tets that take a minute or two to solve on and repair; more do not bring hexahedra more often.
inline constexpr std::size_t kLargeTets = 50000;

/// What steers attempts at hexahedra of a model; docs/notes/hexahedra.md has the measurements.
struct MeshingTuning {
  HexTuning hexahedra;

  /// Sizes of made tets that are tried until hexahedra fill the model, relative to the first. Coarser tets
  /// make shorter work, and often simpler singular graphs.
  std::vector<double> tet_shares = {1, 4, 3, 3.5, 2.4, 1.7, 2, 1.4};

  /// No further size is tried after so many.
  std::size_t most_sizes = 5;

  /// Sizes with more tets than this are not tried, but for a first one that the user gives, and for the
  /// coarsest where the first has more.
  std::size_t large_tets = kLargeTets;
};

using MakeTets = std::function<TetMesh(const TetMakingTuning& options, const Monitor& monitor)>;

/// As `make_hexahedra` of a model of which `make` makes tets.
Hexahedra hexahedra_in_tets_of(const MakeTets& make, const HexMeshingOptions& options,
                               const MeshingTuning& tuning, const Monitor& monitor);

}  // namespace crossgrain
