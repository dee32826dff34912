// SPDX-License-Identifier: Apache-2.0
// Shares the levels of a solve out among processes.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/exchange.hpp"
#include "crossgrain/processes.hpp"
#include "distributed/ghost_search.hpp"
#include "distributed/kept_solve.hpp"
#include "distributed/leaf_records.hpp"
#include "field/nested_solve.hpp"

namespace crossgrain {

/// Returns where shares begin and end: ranks + 1 numbers of leaves, ascending from 0, the last being
/// `leaves`, the others multiples of kShareUnit.
using Cuts = std::function<std::vector<std::uint64_t>(std::uint64_t leaves, int ranks)>;

/// Shares of one size, as far as the unit allows.
std::vector<std::uint64_t> equal_cuts(std::uint64_t leaves, int ranks);

/// The shares follow the order of addresses. Only levels that are swept in blocks are shared; smaller ones
/// are solved by every process.
class LevelShares : public LevelSharing {
 public:
  /// `checkpoint` may be null.
  explicit LevelShares(Exchange& exchange, Cuts cuts = equal_cuts, KeptSolve* checkpoint = nullptr)
      : exchange_(exchange), cuts_(std::move(cuts)), checkpoint_(checkpoint), bounds_(exchange, nullptr) {}

  bool is_first() const override { return exchange_.rank() == 0; }
  int processes() const override { return exchange_.ranks(); }
  std::uint64_t fewest_leaves() const override;
  std::optional<LevelStart> begin(const Solid& solid, const SolveTuning& options,
                                  LevelVisitor* visitor) override;
  void end_alone(bool has_failed) override;
  Level started(const LevelStart& start, Level level, const Solid& solid) override;
  Level shared_out(Level level, const Solid& solid) override;
  void keep_seen(int depth, const Bytes& seen) override;
  SweepKeeper* keeper_of(int depth, const Share& share) override;
  void complete(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
                std::span<const ReachedPlace> elsewhere, int finest_depth, Marks& marks) override;

  /// Leaves of this process on the level that was shared out last.
  struct Sizes {
    std::uint64_t own = 0, ghosts = 0;
  };
  const Sizes& last_share() const { return sizes_; }

 private:
  /// Numbers of leaves, from the first to before the last.
  struct Range {
    std::uint64_t begin, end;
  };

  void check_same(std::uint64_t identity);
  void update_ghosts(std::span<std::byte> values, std::size_t size) override;
  std::size_t ranks() const { return static_cast<std::size_t>(exchange_.ranks()); }
  LeafRecords moved_to_owners(const Level& level, const Range& own, std::span<const std::uint64_t> cuts);
  LeafRecords found_ghosts(const LeafRecords& own, const RootCube& root, std::uint64_t before);
  bool agree_on_marks(Marks& marks);

  Exchange& exchange_;
  const Cuts cuts_;
  KeptSolve* const checkpoint_;
  bool is_resuming_ = false;  ///< the next level to share out is in the checkpoint
  bool has_begun_ = false;    ///< all processes have the start of the first level that is shared

  // Of the level that was shared out last.
  Sizes sizes_;
  ShareBounds bounds_;
  std::vector<std::vector<CellIndex>>
      held_by_;  ///< for each rank the own leaves that it has as ghosts, ascending
  std::vector<std::vector<CellIndex>>
      ghosts_of_;  ///< for each rank its leaves that are ghosts here, ascending
};

}  // namespace crossgrain
