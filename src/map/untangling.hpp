// SPDX-License-Identifier: Apache-2.0
// Maps without flipped tets, as far as the unknowns allow.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "map/descent.hpp"
#include "map/map_energy.hpp"
#include "map/poisson_map.hpp"

namespace crossgrain {

struct UntanglingOptions {
  int rounds = 60;         ///< each with a smaller epsilon
  DescentOptions descent;  ///< of a round
};

/// Columns of a map after untangling, and what is left.
struct Untangled {
  Eigen::VectorXd columns;
  MapFlips flips;
  int steps = 0;
};

/// Whether an untangling changes integer columns too, other than those that are pinned.
enum class IntegerColumns : std::uint8_t { kHeld, kFree };

/// Changes the free columns so that no tet is flipped and the map is near to a similarity in each, where it
/// can: minimises the sum over tets of V (|J|^2 / chi^(2/3) + w (1 + d^2) / chi), with Jacobians J,
/// determinants d, shares V of the volume, and chi = (d + sqrt(d^2 + eps^2)) / 2, for eps that goes to zero.
/// Where that leaves more flips, as it may in a map without room, the columns are the given ones.
///
/// Garanzha, Kaporin, Kudryavtseva, Protais, Ray, Sokolov 2021 ("Foldover-free maps in 50 lines of code"),
/// with steps preconditioned by the energy of the map. The same to the bit for any number of threads.
Untangled untangled(const PoissonMap& poisson, Eigen::VectorXd columns, IntegerColumns integers,
                    const UntanglingOptions& options = {});

}  // namespace crossgrain
