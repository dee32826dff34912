// SPDX-License-Identifier: Apache-2.0
// Hexahedra that follow one repaired field.
#pragma once

#include <memory>
#include <vector>

#include "crossgrain/tet_frame_field.hpp"
#include "hex/hex_candidate.hpp"
#include "hex/hex_extraction.hpp"
#include "hex/hex_tuning.hpp"
#include "hex/surface_feet.hpp"
#include "map/integer_grid_map.hpp"
#include "reduction/demanded_splits.hpp"

namespace crossgrain {

/// A repaired field with all that a map of it needs: tets split where its matchings demand that, the cut, the
/// unknowns.
class FollowedField {
 public:
  /// Throws Error(kLimit) as MapUnknowns does.
  explicit FollowedField(TetFrameField repaired);

  const TetFrameField& field() const { return field_; }
  const MatchedField& matched() const { return *split_.field; }
  const TetSolid& solid() const { return *split_.solid; }
  const MapUnknowns& unknowns() const { return *unknowns_; }

  /// Middles of the arcs that no map gives a length (arcs_of_length_zero).
  const std::vector<Vector3>& arcs_without_length() const { return arcs_without_length_; }

 private:
  TetFrameField field_;
  std::vector<Vector3> arcs_without_length_;
  OwnedField split_;
  std::unique_ptr<CutSolid> cut_;
  std::unique_ptr<MapUnknowns> unknowns_;
};

/// The map that hexahedra were taken out of.
struct FollowingMap {
  IntegerGridMap map;
  std::vector<double> determinants;  ///< of its Jacobians
  ExtractedHexahedra extracted;
  std::vector<Foot> feet;  ///< of their vertices
};

/// Returns a repaired field as a candidate without hexahedra.
HexCandidate followed_candidate(TetFrameField field, double asked_size, std::size_t round);

/// Little: for a field that has no map, of which only a part is to be had.
enum class MappingEffort { kFull, kLittle };

/// Returns a candidate with hexahedra of a size on the field of `of`, and the work and seconds of these
/// alone.
HexCandidate mapped_candidate(const HexCandidate& of, double size, const HexTuning& tuning,
                              MappingEffort effort = MappingEffort::kFull);

}  // namespace crossgrain
