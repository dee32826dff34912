// SPDX-License-Identifier: Apache-2.0
// What steers attempts at hexahedra of a model; docs/notes/hexahedra.md has the measurements. Set by tests
// and bench only.
#pragma once

#include <cstddef>
#include <vector>

#include "hex/hex_tuning.hpp"

namespace crossgrain {

struct MeshingTuning {
  HexTuning hexahedra;

  /// Edges of tets in those of hexahedra.
  double tet_edge = 1.4;

  /// Sizes of made tets that are tried until hexahedra fill the model, relative to the first. Coarser tets
  /// make shorter work, and often simpler singular graphs.
  std::vector<double> tet_shares = {1, 4, 3, 3.5, 2.4, 1.7, 2, 1.4};

  /// No further size is tried after so many.
  std::size_t most_sizes = 5;

  /// Of sizes with more tets than this only the coarsest is tried.
  std::size_t large_tets = 50000;

  /// StartingField::work_share of each size.
  double work_share = 0.25;
};

}  // namespace crossgrain
