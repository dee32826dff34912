// SPDX-License-Identifier: Apache-2.0
// Integers for a map.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "map/poisson_map.hpp"
#include "map/separations.hpp"

namespace crossgrain {

struct QuantisationOptions {
  /// What a separation costs for each unit by which it falls short of 1, relative to the largest entry of the
  /// Schur complement's diagonal.
  double penalty = 10;

  int breakouts = 200;               ///< rounds with higher penalties, while separations are too short
  int sweeps = 50;                   ///< of single changes by 1, until none helps
  std::size_t most_for_pairs = 400;  ///< integers up to which pairs of changes are tried too
};

struct Quantised {
  Eigen::VectorXd integers;  ///< of PoissonMap::integers
  double cost = 0;           ///< growth of the energy from the relaxed map
  double missing = 0;        ///< sum by which separations fall short of 1
};

/// Rounds relaxed integers z one after the other, each time the one nearest to an integer, with the others
/// following as the energy says; then changes single ones and pairs by 1 as long as that lowers the energy
/// with the penalty for separations. Pinned integers are rounded first. The same to the bit on every run.
Quantised quantised(const PoissonMap& poisson, const Eigen::VectorXd& relaxed, const Separations& separations,
                    const QuantisationOptions& options = {});

}  // namespace crossgrain
