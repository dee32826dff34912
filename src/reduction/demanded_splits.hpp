// SPDX-License-Identifier: Apache-2.0
// Splits of tets that would be flat in any map.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/quaternion.hpp"
#include "reduction/map_unknowns.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// A matched field with all that it refers to.
struct OwnedField {
  std::unique_ptr<const TetSolid> solid;
  std::vector<Quaternion> frames;
  std::unique_ptr<const TetComplex> complex;
  std::unique_ptr<const MatchedField> field;
};

/// The field on its own.
OwnedField owned(const MatchedField& field);

/// Edges and inner faces whose vertices the map keeps on more common lines and planes of the grid than it
/// should: a coordinate that is an integer for either end of an edge and the same unknown, beyond the two
/// across a singular edge, the one or two of an edge of the surface, and none elsewhere; the same for the
/// three vertices of an inner face. Tets beside them are flat in every map.
struct DemandedSplits {
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< without an edge of the list

  bool empty() const { return edges.empty() && faces.empty(); }
};

DemandedSplits demanded_splits(const MapUnknowns& unknowns);

/// The field on tets that are split there, longest edges first; parts inherit frames and matchings.
OwnedField with_splits(const OwnedField& field, const DemandedSplits& splits);

/// Splits as long as any are demanded, in so many rounds at most.
OwnedField split_for_map(const MatchedField& field, int most_rounds = 5);

}  // namespace crossgrain
