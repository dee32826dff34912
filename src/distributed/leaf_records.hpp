// SPDX-License-Identifier: Apache-2.0
// What processes send each other of leaves of a level.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/exchange.hpp"
#include "base/quaternion.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

/// Some leaves of a level, with what a level and a field have of each.
struct LeafRecords {
  std::vector<std::uint64_t> numbers;  ///< in the level; empty if successive
  std::vector<CellAddress> addresses;
  std::vector<std::int8_t> centre_winding;
  std::vector<std::uint32_t> piece_counts;
  std::vector<SurfacePiece> pieces;
  std::vector<std::vector<StoredQuaternion>> frames;  ///< several fields

  std::size_t size() const { return addresses.size(); }
};

/// Appends leaves [begin, end) of a level and of fields on it. `to.frames` has as many fields.
void append(LeafRecords& to, const GridLevel& level, std::span<const std::vector<StoredQuaternion>> frames,
            CellIndex begin, CellIndex end);

/// Appends all of `from`, which has as many fields.
void append(LeafRecords& to, const LeafRecords& from);

Bytes packed(const LeafRecords& records);

/// Inverse of `packed`, for so many fields.
LeafRecords unpacked(std::span<const std::byte> message, std::size_t fields);

}  // namespace crossgrain
