// SPDX-License-Identifier: Apache-2.0
// Maps of a solid to a grid of unit cubes.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "map/map_energy.hpp"
#include "map/quantisation.hpp"
#include "map/untangling.hpp"

namespace crossgrain {

struct GridMapOptions {
  UntanglingOptions untangling;
  int breakouts = 200;  ///< of `quantised`
};

/// A map, linear in each tet, that takes faces of the surface to integer planes and singular edges to integer
/// lines, with integer translations where tets are glued: without flips the cubes of the grid, pulled back,
/// are hexahedra that fill the solid.
struct IntegerGridMap {
  MapCoordinates coordinates;           ///< at the copies of vertices (CutSolid)
  MapCoordinates seamless_coordinates;  ///< the same before rounding, untangled

  MapFlips seamless, untangled;  ///< before rounding: of the least energy, and after untangling
  MapFlips rounded, flips;       ///< after rounding, and in the end
  std::size_t integers = 0;
  double missing = 0;  ///< Quantised::missing
};

/// The map of hexahedra of the size of the energy: least energy, untangling, rounding with separations,
/// untangling. The same to the bit for any number of threads. Interrupted as its watched loops say.
IntegerGridMap integer_grid_map(const MapEnergy& energy, const GridMapOptions& options = {});

}  // namespace crossgrain
