// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup hexahedra Hexahedra
/// @{

/// The map that hexahedra are cells of: tets with three coordinates at their corners, linear in each tet.
/// Hexahedra of the size `size` have edges of length 1 in it.
///
/// The coordinates of a tet go over into those of its neighbour by a rotation of the cube and a translation,
/// one for each inner face: the identity at most faces. On a face of the surface one of the three is
/// constant.
struct HexMap {
  using Corners = std::array<Vector3, 4>;  ///< coordinates at the corners of a tet, in their order

  /// Those that were mapped: the tets of the field, split where the map needed that. Of positive volume.
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 4>> tets;

  /// Before rounding: translations and the constant coordinates of surfaces are any numbers. Continuous to
  /// rounding.
  std::vector<Corners> seamless;

  /// After rounding, as hexahedra were taken out of it: translations, constant coordinates of surfaces, and
  /// the two coordinates that are constant along singular edges are whole numbers. Multiples of 2^-20, so
  /// that all this holds exactly.
  std::vector<Corners> integer_grid;

  double size = 0;  ///< HexReport::used_size, in model units
};

/// @}

}  // namespace crossgrain
