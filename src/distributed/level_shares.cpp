// SPDX-License-Identifier: Apache-2.0
#include "distributed/level_shares.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "field/leaf_stencil.hpp"
#include "grid/leaf_finder.hpp"

namespace crossgrain {
namespace {

/// What the first process says in place of a start.
constexpr std::byte kNothing{0}, kFailure{1};

Bytes message_of(const LevelStart& start) {
  const LevelStartNumbers& numbers = start;
  Bytes message;
  append_to(message, std::span(&numbers, 1));
  append_to(message, std::span(start.levels));
  return message;
}

LevelStart start_in(const Bytes& message) {
  MessageReader reader(message);
  const auto numbers = reader.take<LevelStartNumbers>();
  return {numbers, reader.take<LevelStatistics>(reader.size() / sizeof(LevelStatistics))};
}

/// Makes a level of own leaves and of ghosts, both in the order of their numbers.
LevelSharing::Level joined(const RootCube& root, LeafRecords own, const LeafRecords& ghosts,
                           std::uint64_t before) {
  const auto below = static_cast<std::size_t>(
      std::lower_bound(ghosts.numbers.begin(), ghosts.numbers.end(), before) - ghosts.numbers.begin());
  const std::size_t size = own.size() + ghosts.size();
  if (size >= kNoCell || own.pieces.size() + ghosts.pieces.size() >= kNoCell)
    throw Error(ErrorKind::kLimit, "a share of the grid needs more than 4 billion cells",
                Remedy::kLowerResolution);
  const auto in_order = [&]<class T>(std::vector<T>& middle, const std::vector<T>& around,
                                     std::size_t first) {
    std::vector<T> all = sized_vector<T>(middle.size() + around.size());
    const auto split = around.begin() + static_cast<std::ptrdiff_t>(first);
    const auto at = std::copy(around.begin(), split, all.begin());
    std::copy(split, around.end(), std::copy(middle.begin(), middle.end(), at));
    middle = std::vector<T>();
    return all;
  };
  LevelSharing::Level level;
  GridLevel& grid = level.made.level;
  const std::uint64_t pieces_below =
      std::accumulate(ghosts.piece_counts.begin(),
                      ghosts.piece_counts.begin() + static_cast<std::ptrdiff_t>(below), std::uint64_t{0});
  const std::vector<std::uint32_t> counts = in_order(own.piece_counts, ghosts.piece_counts, below);
  grid.piece_begin.assign(size + 1, 0);
  std::partial_sum(counts.begin(), counts.end(), grid.piece_begin.begin() + 1);
  grid.pieces = in_order(own.pieces, ghosts.pieces, pieces_below);
  grid.centre_winding = in_order(own.centre_winding, ghosts.centre_winding, below);
  const auto begin = static_cast<CellIndex>(below);
  const auto end = static_cast<CellIndex>(below + own.size());
  grid.part = Share{begin, end, before, 0, nullptr};
  grid.tree = Octree(root, in_order(own.addresses, ghosts.addresses, below));
  grid.ghosts.numbers = ghosts.numbers;
  for (std::size_t f = 0; f < own.frames.size(); ++f)
    level.frames.push_back(in_order(own.frames[f], ghosts.frames[f], below));
  return level;
}

/// Leaves that a process has kept: [begin, end) before, and after that `after` on.
struct KeptLeaves {
  CellIndex begin = 0, end = 0, after = 0;
};

/// Returns the neighbours of all leaves. Those of kept leaves are known, if they are kept too.
std::vector<FaceNeighbours> neighbours_after(const Octree& tree, std::span<const FaceNeighbours> before,
                                             const KeptLeaves& kept) {
  const LeafFinder finder(tree);
  auto result = sized_vector<FaceNeighbours>(tree.size());
  parallel_for(tree.size(), [&](std::size_t k) {
    const auto leaf = static_cast<CellIndex>(k);
    const bool is_kept = leaf >= kept.after && leaf - kept.after < kept.end - kept.begin;
    for (int face = 0; face < kFaceCount; ++face) {
      const CellIndex known = is_kept ? before[kept.begin + (leaf - kept.after)][face] : kept.end;
      if (is_kept && known == kNoCell) {
        result[leaf][face] = kNoCell;
      } else if (known >= kept.begin && known < kept.end) {
        result[leaf][face] = kept.after + (known - kept.begin);
      } else {
        result[leaf][face] = finder.neighbour(leaf, face);
      }
    }
  });
  return result;
}

}  // namespace

std::vector<std::uint64_t> equal_cuts(std::uint64_t leaves, int ranks) {
  std::vector<std::uint64_t> cuts{0};
  const std::uint64_t units = (leaves + kShareUnit - 1) / kShareUnit;
  for (int rank = 1; rank < ranks; ++rank)
    cuts.push_back(std::min(
        leaves, units * static_cast<std::uint64_t>(rank) / static_cast<std::uint64_t>(ranks) * kShareUnit));
  cuts.push_back(leaves);
  return cuts;
}

std::uint64_t LevelShares::fewest_leaves() const {
  return exchange_.ranks() > 1 ? blocked_cells() : std::numeric_limits<std::uint64_t>::max();
}

std::optional<LevelStart> LevelShares::begin(const Solid& solid, const SolveTuning& options,
                                             LevelVisitor* visitor) {
  const std::uint64_t identity = identity_of(solid, options);
  check_same(identity);
  has_begun_ = !is_first();
  if (checkpoint_ != nullptr) {
    if (auto start = checkpoint_->begin(identity)) {
      has_begun_ = is_resuming_ = true;
      if (is_first() && visitor != nullptr) checkpoint_->revisit(*visitor);
      return start;
    }
  }
  if (is_first()) return std::nullopt;
  const Bytes told = exchange_.gathered({}).front();
  if (told.size() > 1) return start_in(told);
  if (told.front() == kFailure) throw OtherProcessFailed();
  return std::nullopt;
}

/// Throws Error(kInput) unless all processes solve the same; OtherProcessFailed if the first has failed
/// before.
void LevelShares::check_same(std::uint64_t identity) {
  const std::vector<Bytes> told = exchange_.gathered(std::as_bytes(std::span(&identity, 1)));
  if (told.front().size() != sizeof identity) throw OtherProcessFailed();
  for (std::size_t rank = 1; rank < told.size(); ++rank)
    if (told[rank] != told.front())
      throw Error(ErrorKind::kInput,
                  fmt::format("process {} has another model or other options than process 0", rank));
}

void LevelShares::end_alone(bool has_failed) {
  if (!std::exchange(has_begun_, true)) exchange_.gathered(std::span(has_failed ? &kFailure : &kNothing, 1));
}

LevelSharing::Level LevelShares::started(const LevelStart& start, Level level, const Solid& solid) {
  if (!std::exchange(has_begun_, true)) exchange_.gathered(message_of(start));
  level = shared_out(std::move(level), solid);
  if (checkpoint_ != nullptr && checkpoint_->keeps())
    checkpoint_->keep_start(start, level.made.level, level.frames.front());
  return level;
}

void LevelShares::keep_seen(int depth, const Bytes& seen) {
  if (is_first() && checkpoint_ != nullptr && checkpoint_->keeps()) checkpoint_->keep_seen(depth, seen);
}

SweepKeeper* LevelShares::keeper_of(int depth, const Share& share) {
  if (checkpoint_ == nullptr || share.is_whole()) return nullptr;
  checkpoint_->enter(depth, share);
  return checkpoint_;
}

LevelSharing::Level LevelShares::shared_out(Level level, const Solid& solid) {
  const RootCube root = level.made.level.tree.root();
  const auto sizes = gathered_value<std::uint64_t>(exchange_, level.made.level.share().size());
  const auto examined = gathered_value<std::uint64_t>(exchange_, level.made.level.examined_leaves);
  const bool is_resuming = std::exchange(is_resuming_, false);
  const std::uint64_t leaves =
      is_resuming ? checkpoint_->leaves() : std::accumulate(sizes.begin(), sizes.end(), std::uint64_t{0});
  const std::uint64_t before =
      std::accumulate(sizes.begin(), sizes.begin() + exchange_.rank(), std::uint64_t{0});
  const std::vector<std::uint64_t> cuts = cuts_(leaves, exchange_.ranks());
  const auto rank = static_cast<std::size_t>(exchange_.rank());
  LeafRecords own = is_resuming ? checkpoint_->leaves_between(cuts[rank], cuts[rank + 1])
                                : moved_to_owners(level, {before, before + sizes[rank]}, cuts);
  const std::vector<FaceNeighbours> neighbours_before = std::move(level.made.neighbours);
  KeptLeaves kept;
  if (const std::uint64_t first = std::max(before, cuts[rank]),
      last = std::min(before + sizes[rank], cuts[rank + 1]);
      first < last && !neighbours_before.empty()) {
    kept.begin = static_cast<CellIndex>(level.made.level.share().begin + (first - before));
    kept.end = static_cast<CellIndex>(kept.begin + (last - first));
    kept.after = static_cast<CellIndex>(first - cuts[rank]);
  }
  level = {};
  bounds_ = ShareBounds(exchange_, own.size() > 0 ? &own.addresses.front() : nullptr);
  const LeafRecords ghosts = found_ghosts(own, root, cuts[rank]);

  Level result = joined(root, std::move(own), ghosts, cuts[rank]);
  RefinedLevel& made = result.made;
  made.level.part.of_all = leaves;
  made.level.part.exchange = &exchange_;
  made.level.examined_leaves = is_resuming
                                   ? checkpoint_->examined_leaves()
                                   : std::accumulate(examined.begin(), examined.end(), std::uint64_t{0});
  const Share share = made.level.share();
  sizes_ = {share.size(), ghosts.size()};
  for (CellIndex leaf = 0; leaf < made.level.size(); ++leaf)
    if (!share.owns(leaf)) made.level.ghosts.owners.push_back(bounds_.owner(made.level.tree[leaf]));
  ghosts_of_.assign(ranks(), {});
  for (CellIndex leaf = 0; leaf < made.level.size(); ++leaf) {
    if (share.owns(leaf)) continue;
    const int owner = made.level.ghosts.owners[Ghosts::index(share, leaf)];
    ghosts_of_[static_cast<std::size_t>(owner)].push_back(leaf);
  }
  for (auto& held : held_by_)
    for (CellIndex& leaf : held) leaf += share.begin;
  kept.after += share.begin;
  made.neighbours = neighbours_after(made.level.tree, neighbours_before, kept);
  if (solid.guides != nullptr) {
    int deepest = 0;
    for (const CellAddress leaf : made.level.tree.leaves()) deepest = std::max(deepest, leaf.depth());
    const std::vector<int> depths = gathered_value(exchange_, deepest);
    const double finest = root.cell_size(*std::max_element(depths.begin(), depths.end()));
    made.level.guides = LeafGuides(made.level.tree, *solid.guides, finest);
  }
  return result;
}

/// Returns the leaves of this process after the cuts. Only leaves that change their owner are sent. `own` are
/// the numbers of its leaves before.
LeafRecords LevelShares::moved_to_owners(const Level& level, const Range& own,
                                         std::span<const std::uint64_t> cuts) {
  const GridLevel& grid = level.made.level;
  const Share share = grid.share();
  const auto rank = static_cast<std::size_t>(exchange_.rank());
  const std::size_t fields = level.frames.size();
  const auto append_between = [&](std::uint64_t first, std::uint64_t last, LeafRecords& records) {
    const std::uint64_t begin = std::max(first, own.begin), end = std::min(last, own.end);
    if (begin >= end) return;
    const auto leaf = static_cast<CellIndex>(share.begin + (begin - own.begin));
    append(records, grid, level.frames, leaf, static_cast<CellIndex>(leaf + (end - begin)));
  };
  std::vector<Bytes> to(ranks());
  for (std::size_t r = 0; r < ranks(); ++r) {
    LeafRecords records;
    records.frames.resize(fields);
    if (r != rank) append_between(cuts[r], cuts[r + 1], records);
    if (records.size() > 0) to[r] = packed(records);
  }
  std::vector<Bytes> from = exchange_.delivered(std::move(to));
  LeafRecords result;
  result.frames.resize(fields);
  for (std::size_t r = 0; r < ranks(); ++r) {
    if (r == rank) {
      append_between(cuts[rank], cuts[rank + 1], result);
    } else {
      append(result, unpacked(from[r], fields));
    }
    from[r] = Bytes();
  }
  return result;
}

/// Returns the ghosts around own leaves, and remembers which processes have own leaves as ghosts.
LeafRecords LevelShares::found_ghosts(const LeafRecords& own, const RootCube& root, std::uint64_t before) {
  const GhostHolders holders = ghost_holders(Octree(root, own.addresses), bounds_, exchange_);
  held_by_.assign(ranks(), {});
  std::vector<LeafRecords> sent(ranks());
  for (LeafRecords& records : sent) records.frames.resize(own.frames.size());
  std::size_t piece = 0;
  for (std::size_t leaf = 0; leaf < own.size(); ++leaf) {
    for (const int holder : holders[leaf]) {
      LeafRecords& records = sent[static_cast<std::size_t>(holder)];
      held_by_[static_cast<std::size_t>(holder)].push_back(static_cast<CellIndex>(leaf));
      records.numbers.push_back(before + leaf);
      records.addresses.push_back(own.addresses[leaf]);
      records.centre_winding.push_back(own.centre_winding[leaf]);
      records.piece_counts.push_back(own.piece_counts[leaf]);
      const auto first = own.pieces.begin() + static_cast<std::ptrdiff_t>(piece);
      records.pieces.insert(records.pieces.end(), first, first + own.piece_counts[leaf]);
      for (std::size_t f = 0; f < own.frames.size(); ++f) records.frames[f].push_back(own.frames[f][leaf]);
    }
    piece += own.piece_counts[leaf];
  }
  std::vector<Bytes> to(ranks());
  for (std::size_t r = 0; r < ranks(); ++r)
    if (sent[r].size() > 0) to[r] = packed(sent[r]);
  LeafRecords ghosts;
  ghosts.frames.resize(own.frames.size());
  for (const Bytes& message : exchange_.delivered(std::move(to)))
    append(ghosts, unpacked(message, own.frames.size()));
  return ghosts;
}

void LevelShares::complete(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
                           std::span<const ReachedPlace> elsewhere, int finest_depth, Marks& marks) {
  if (level.share().is_whole()) return;
  std::vector<Bytes> to(ranks());
  for (const ReachedPlace& reached : elsewhere)
    append_to(to[static_cast<std::size_t>(bounds_.owner(reached.place))], std::span(&reached, 1));
  for (const Bytes& message : exchange_.delivered(std::move(to))) {
    for (MessageReader reader(message); !reader.empty();)
      mark_reached(level, reader.take<ReachedPlace>(), marks);
  }
  // What is known here of a ghost may be less than its owner knows.
  const Share share = level.share();
  for (CellIndex leaf = 0; leaf < level.size(); ++leaf)
    if (!share.owns(leaf) || level.tree[leaf].depth() >= finest_depth) marks[leaf] = false;
  do {
    balance_marks(level.tree, neighbours, marks);
  } while (agree_on_marks(marks));
}

/// Marks own leaves that are marked as ghosts elsewhere, then ghosts as their owners have them. Returns
/// whether any mark of any process has been added.
bool LevelShares::agree_on_marks(Marks& marks) {
  bool has_added = false;
  const auto add_from = [&](const std::vector<std::vector<CellIndex>>& tellers,
                            const std::vector<std::vector<CellIndex>>& told) {
    std::vector<Bytes> to(ranks());
    for (std::size_t r = 0; r < ranks(); ++r)
      for (const CellIndex leaf : tellers[r]) to[r].push_back(static_cast<std::byte>(marks[leaf] ? 1 : 0));
    const std::vector<Bytes> from = exchange_.delivered(std::move(to));
    for (std::size_t r = 0; r < ranks(); ++r) {
      for (std::size_t k = 0; k < told[r].size(); ++k) {
        if (from[r][k] == std::byte{0} || marks[told[r][k]]) continue;
        marks[told[r][k]] = true;
        has_added = true;
      }
    }
  };
  add_from(ghosts_of_, held_by_);
  add_from(held_by_, ghosts_of_);
  return any(exchange_, has_added);
}

void LevelShares::update_ghosts(std::span<std::byte> values, std::size_t size) {
  if (held_by_.empty()) return;  // no level has been shared out
  const auto value = [&](CellIndex leaf) { return values.subspan(leaf * size, size); };
  std::vector<Bytes> to(ranks());
  for (std::size_t r = 0; r < ranks(); ++r)
    for (const CellIndex leaf : held_by_[r]) append_to<std::byte>(to[r], value(leaf));
  const std::vector<Bytes> from = exchange_.delivered(std::move(to));
  for (std::size_t r = 0; r < ranks(); ++r) {
    const std::byte* next = from[r].data();
    for (const CellIndex ghost : ghosts_of_[r]) {
      std::copy_n(next, size, value(ghost).begin());
      next += size;
    }
  }
}

}  // namespace crossgrain
