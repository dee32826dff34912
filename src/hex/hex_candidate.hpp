// SPDX-License-Identifier: Apache-2.0
// What an attempt made, and which of two is better.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/hex_report.hpp"

namespace crossgrain {

/// Hexahedra with what they are judged by.
struct MadeHexahedra {
  HexMesh mesh;
  HexReport::Quality quality;
  bool fills = false;        ///< they close up to a surface near that of the model
  bool is_coarse = false;    ///< far fewer than would fill the model at the size asked for
  bool is_faithful = true;   ///< nothing is known that they do not keep of the model
  double volume_missed = 0;  ///< |their volume / that of the model - 1|
  std::size_t left_out = 0;  ///< cells of the grid

  bool are_complete() const { return fills && quality.inverted == 0; }

  HexOutcome outcome() const {
    if (mesh.hexahedra.empty()) return HexOutcome::kNone;
    if (!are_complete()) return HexOutcome::kPartial;
    return is_faithful ? HexOutcome::kAllHex : HexOutcome::kApproximate;
  }
};

struct FeatureFit;
class FollowedField;
struct FollowingMap;
struct LatticeHexahedra;

/// Seconds of the steps of an attempt.
struct HexSeconds {
  double repair = 0, map = 0, extraction = 0, smoothing = 0;

  double sum() const { return repair + map + extraction + smoothing; }
};

/// What an attempt made: perhaps a mesh; if that follows a field, the field and perhaps the map.
struct HexCandidate {
  HexAttempt attempt;
  double asked_size = 0;   ///< of the hexahedra
  std::size_t number = 0;  ///< in AttemptQueue::attempts
  std::optional<MadeHexahedra> made = {};
  std::shared_ptr<const FollowedField> followed = {};
  std::shared_ptr<const FollowingMap> following = {};
  std::shared_ptr<const FeatureFit> fit = {};            ///< that made `made`, without its mesh
  std::shared_ptr<const LatticeHexahedra> lattice = {};  ///< that `made` is of, without its mesh
  std::string text = {};                                 ///< how it ended, if that is known
  HexSeconds seconds = {};

  /// Whether the hexahedra fill the model, and are not far fewer than asked for.
  bool is_filled() const { return made && made->are_complete() && !made->is_coarse; }
};

/// Whether a candidate is worth more than another of the same round: first one that is good; then one that
/// fills the model; then one that is complete; then one that closes up; then the one with fewer hexahedra
/// left out or inverted; then a field with fewer faults and fewer arcs without length.
bool is_better_in_round(const HexCandidate& candidate, const HexCandidate& other, double least_quality);

/// Whether a candidate is worth more than another of an earlier round: first one that is good; then one that
/// keeps the model; then one that is complete, with shapes that may be computed on; then one that closes up;
/// then the one that misses less of the volume.
bool is_better(const HexCandidate& candidate, const HexCandidate& other, double least_quality);

/// Whether hexahedra fill the model, keep its features as far as that is known, and have no worse shapes.
bool is_good(const HexCandidate& candidate, double least_quality);

}  // namespace crossgrain
