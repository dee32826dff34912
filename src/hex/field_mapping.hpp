// SPDX-License-Identifier: Apache-2.0
// Hexahedra that follow one repaired field.
#pragma once

#include "crossgrain/tet_frame_field.hpp"
#include "hex/hex_candidate.hpp"
#include "hex/hex_smoothing.hpp"
#include "hex/hex_tuning.hpp"
#include "map/integer_grid_map.hpp"

namespace crossgrain {

/// How a map and its hexahedra are made.
struct MappingEffort {
  GridMapOptions map;
  HexSmoothingOptions smoothing;
};

/// For a field that has no map, of which only a part is to be had.
MappingEffort little_effort();

/// Returns a repaired field as a candidate without hexahedra.
HexCandidate followed_candidate(TetFrameField field, double asked_size, std::size_t round);

/// Returns a candidate with hexahedra of a size on the field of `of`.
HexCandidate mapped_candidate(const HexCandidate& of, double size, const HexTuning& tuning,
                              const MappingEffort& effort = {});

}  // namespace crossgrain
