// SPDX-License-Identifier: Apache-2.0
// Integers for a map.
#pragma once

#include <Eigen/Core>

#include "map/poisson_map.hpp"
#include "map/separations.hpp"

namespace crossgrain {

struct Quantised {
  Eigen::VectorXd integers;  ///< of PoissonMap::integers
  double cost = 0;           ///< growth of the energy from the relaxed map
  double missing = 0;        ///< sum by which separations fall short of 1
};

/// Rounds relaxed integers z one after the other, each time the one nearest to an integer, with the others
/// following as the energy says; then changes single ones and pairs by 1 as long as that lowers the energy
/// with a penalty for separations below 1, which rises in up to `breakouts` rounds while some are. Pinned
/// integers are rounded first. The same to the bit on every run.
Quantised quantised(const PoissonMap& poisson, const Eigen::VectorXd& relaxed, const Separations& separations,
                    int breakouts = 200);

}  // namespace crossgrain
