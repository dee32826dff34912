// SPDX-License-Identifier: Apache-2.0
// What a solve by several processes keeps on disk to go on from after a break, on any number of processes.
//
//   seen-DEPTH     what a LevelVisitor has seen of a solved level; written by the first process
//   start-DEPTH    the leaves of the level to solve next, and its first frames; written by all
//   sweeps-DEPTH   frames, coefficients and cells awake after some of its sweeps; written by all
//
// Files come under their names when they are complete. A start replaces starts and sweeps before it.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "base/exchange.hpp"
#include "distributed/checkpoint_files.hpp"
#include "distributed/leaf_records.hpp"
#include "field/nested_solve.hpp"

namespace crossgrain {

class KeptSolve : public SweepKeeper {
 public:
  /// `keep`: the folder to write to, `resume`: that to go on from; either may be empty. Sweeps are kept every
  /// so many seconds.
  KeptSolve(Exchange& exchange, SharedFiles& files, std::string keep, std::string resume, double seconds)
      : exchange_(exchange),
        files_(files),
        keep_(std::move(keep)),
        resume_(std::move(resume)),
        seconds_(seconds) {}

  bool keeps() const { return !keep_.empty(); }

  /// Writes what was seen of a solved level. Called by the first process. Throws Error(kOutput).
  void keep_seen(int depth, const Bytes& seen) const;

  /// Writes the start of a level. All processes call it together. Throws Error(kOutput) in all of them.
  void keep_start(const LevelStart& start, const GridLevel& level, std::span<const StoredQuaternion> frames);

  /// Begins a solve. Returns the last start in the folder to go on from; none if that has none yet. All
  /// processes call it together, before all else. Throws Error(kInput) if it belongs to another solve, or
  /// cannot be read.
  std::optional<LevelStart> begin(std::uint64_t identity);

  /// Of the start that was found last: the number of leaves of the level and of the complete octree.
  std::uint64_t leaves() const { return found_.leaves; }
  std::size_t examined_leaves() const { return found_.examined_leaves; }

  /// Reads leaves [begin, end) of that start.
  LeafRecords leaves_between(std::uint64_t begin, std::uint64_t end) const;

  /// Begins the sweeps of a level.
  void enter(int depth, const Share& share);

  bool is_due() override;
  void keep(const SweepsSoFar& sweeps, std::span<const LeafValues> lists) override;
  std::optional<SweepsSoFar> resumed(std::span<const LeafValues> lists) override;

  /// Revisits the solved levels above that start, coarsest first, and keeps what was seen of them if levels
  /// are kept in another folder. Called by the first process.
  void revisit(LevelVisitor& visitor) const;

 private:
  struct Header {
    std::array<char, 24> magic;
    std::uint64_t identity, leaves, pieces, levels, examined_leaves;
    LevelStartNumbers start;
    RootCube root;
  };
  struct Offsets;

  Header header_of(const LevelStart& start, const GridLevel& level, std::uint64_t pieces) const;
  void write_together(const std::string& path, std::span<const SharedFiles::Part> parts);

  struct SweepHeader;
  std::optional<LevelStart> read_start(const std::string& path);
  static std::uint64_t end_of_lists(const SweepHeader& header, std::span<const LeafValues> lists);

  Exchange& exchange_;
  SharedFiles& files_;
  const std::string keep_, resume_;
  const double seconds_;

  std::uint64_t identity_ = 0;

  // Of the level that is swept.
  int depth_ = 0;
  Share share_;
  std::chrono::steady_clock::time_point last_kept_;

  std::string found_path_;
  bool is_one_folder_ = false;  ///< that to keep in is that to go on from
  Header found_{};
};

}  // namespace crossgrain
