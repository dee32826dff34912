// SPDX-License-Identifier: Apache-2.0
// The repair of a field that hexahedra can follow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "crossgrain/hexahedra.hpp"
#include "hex/followed_field.hpp"
#include "hex/hex_extraction.hpp"
#include "hex/hex_smoothing.hpp"
#include "hex/surface_feet.hpp"
#include "map/integer_grid_map.hpp"
#include "solve/repair_search.hpp"

namespace crossgrain {

/// A map with the hexahedra in it.
struct MappedHexahedra {
  IntegerGridMap map;
  std::vector<double> determinants;  ///< of its Jacobians
  ExtractedHexahedra hexahedra;
  std::vector<Foot> feet;  ///< of their vertices
  HexMesh smoothed;
  HexReport::Quality quality;
  bool fills = false;
  bool is_coarse = false;  ///< far fewer of them than would fill the model at the size asked for

  bool is_complete() const { return fills && quality.inverted == 0; }
};

/// How long the steps of an attempt took.
struct HexSeconds {
  double repair = 0, map = 0, extraction = 0, smoothing = 0;

  double sum() const { return repair + map + extraction + smoothing; }
};

/// A field that an attempt was made on.
struct HexCandidate {
  TetFrameField field;
  std::unique_ptr<FollowedField> followed;
  HexAttempt attempt;
  std::optional<MappedHexahedra> mapped;
  HexSeconds seconds;

  bool is_good() const { return mapped && mapped->is_complete() && !mapped->is_coarse; }

  /// Less is better.
  auto rank() const {
    constexpr std::size_t kMany = SIZE_MAX;
    return std::tuple(!is_good(), !mapped || !mapped->is_complete(), !mapped || !mapped->fills,
                      mapped ? mapped->hexahedra.left_out + mapped->quality.inverted : kMany, attempt.faults,
                      attempt.arcs_without_length);
  }
};

/// How a map and its hexahedra are made.
struct HexEffort {
  GridMapOptions map;
  HexSmoothingOptions smoothing;
};

/// Finds the repair that a map can follow.
class HexSearch {
 public:
  /// All must outlive it. The options are in range, and the field can be repaired.
  HexSearch(const TetFrameField& given, const HexOptions& options, const Monitor& monitor);

  /// The best candidate, with a map.
  HexCandidate best();

  HexReport& report() { return report_; }

 private:
  using Tries = std::vector<const RepairTry*>;

  HexCandidate candidate(TetFrameField field) const;
  void map(HexCandidate& candidate, double size, const HexEffort& effort = {}) const;
  void map_best(double size, const HexEffort& effort = {});
  void add(HexCandidate candidate);
  void count(const HexSeconds& seconds);
  Tries next_of(const Tries& tries, std::size_t& at);
  void take(const RepairSearch& search, const Tries& tries);
  void try_finer_sizes();
  void try_repairs();
  bool is_done() const { return best_ && best_->is_good(); }

  const TetFrameField& given_;
  const HexOptions& options_;
  const Monitor& monitor_;
  HexReport report_;
  std::optional<HexCandidate> best_;
  std::size_t candidates_ = 0, maps_left_ = 1, fields_left_ = 1;
  std::vector<std::vector<CubeRotation>> taken_;
};

}  // namespace crossgrain
