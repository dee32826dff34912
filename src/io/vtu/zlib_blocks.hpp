// SPDX-License-Identifier: Apache-2.0
// Arrays of VTK files that are cut into blocks, each a zlib stream of its own (vtu_types.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace crossgrain {

/// Where the blocks stand, and how much they hold.
struct ZlibBlocks {
  std::uint64_t raw_bytes = 0;        ///< of all blocks together
  std::uint64_t block_bytes = 0;      ///< raw ones of each but the last
  std::vector<std::uint64_t> begins;  ///< one more than there are blocks

  std::size_t count() const { return begins.size() - 1; }
  std::uint64_t raw_begin(std::size_t block) const { return block * block_bytes; }
  std::uint64_t raw_size(std::size_t block) const {
    return block + 1 < count() ? block_bytes : raw_bytes - raw_begin(block);
  }
};

/// The blocks that a header speaks of: `head` its first three numbers, `sizes` the others, `begin` the place
/// behind it. Nothing where they contradict each other, reach beyond `end`, or claim to hold more than zlib
/// can pack into as many bytes. That is a thousand times as many: before memory is taken for what is
/// returned, inflate a block.
std::optional<ZlibBlocks> zlib_blocks(const std::array<std::uint64_t, 3>& head,
                                      std::span<const std::uint64_t> sizes, std::uint64_t begin,
                                      std::uint64_t end);

/// Whether `compressed` is a zlib stream of exactly `raw_bytes` bytes, which are then in `out`.
bool inflate_block(std::span<const unsigned char> compressed, char* out, std::uint64_t raw_bytes);

/// Appends what `compressed` holds to `out`, which grows with what comes, whatever `raw_bytes` claims.
/// Whether that was a zlib stream of exactly `raw_bytes` bytes.
bool inflate_onto(std::string& out, std::span<const unsigned char> compressed, std::uint64_t raw_bytes);

}  // namespace crossgrain
