// SPDX-License-Identifier: Apache-2.0
// Repaired fields and the maps that follow them, of candidates.
#pragma once

#include <utility>
#include <vector>

#include "crossgrain/tet_frame_field.hpp"
#include "hex/followed_field.hpp"
#include "hex/hex_extraction.hpp"
#include "hex/surface_feet.hpp"
#include "map/integer_grid_map.hpp"

namespace crossgrain {

/// A repaired field that a map can follow.
struct MappableField {
  TetFrameField field;
  FollowedField followed;

  explicit MappableField(TetFrameField repaired) : field(std::move(repaired)), followed(field) {}
};

/// The map that hexahedra were taken out of.
struct FollowingMap {
  IntegerGridMap map;
  std::vector<double> determinants;  ///< of its Jacobians
  ExtractedHexahedra extracted;
  std::vector<Foot> feet;  ///< of their vertices
};

}  // namespace crossgrain
