// SPDX-License-Identifier: Apache-2.0
// Arrays of VTK files in blocks that are separate zlib streams (vtu_types.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace crossgrain {

/// Positions and sizes of the blocks.
struct ZlibBlocks {
  std::uint64_t raw_bytes = 0;        ///< of all blocks together
  std::uint64_t block_bytes = 0;      ///< raw bytes of each block but the last
  std::vector<std::uint64_t> begins;  ///< one more than there are blocks

  std::size_t count() const { return begins.size() - 1; }
  std::uint64_t raw_begin(std::size_t block) const { return block * block_bytes; }
  std::uint64_t raw_size(std::size_t block) const {
    return block + 1 < count() ? block_bytes : raw_bytes - raw_begin(block);
  }
};

/// Returns the blocks that a header describes: `head` its first three numbers, `sizes` the others, `begin`
/// the position behind it. Nothing if they are inconsistent, exceed `end`, or claim more than zlib can
/// compress into that many bytes. That is a factor of a thousand: inflate a block before allocating memory
/// for all.
std::optional<ZlibBlocks> zlib_blocks(const std::array<std::uint64_t, 3>& head,
                                      std::span<const std::uint64_t> sizes, std::uint64_t begin,
                                      std::uint64_t end);

/// Decompresses into `out`. Returns whether `compressed` is a zlib stream of exactly `raw_bytes` bytes.
bool inflate_block(std::span<const unsigned char> compressed, char* out, std::uint64_t raw_bytes);

/// Decompresses and appends to `out`, which grows with the data, whatever `raw_bytes` claims, and only within
/// the limits of reading the file `name` (files/read_memory.hpp). Returns whether it was a zlib stream of
/// exactly `raw_bytes` bytes.
bool inflate_onto(const std::string& name, std::string& out, std::span<const unsigned char> compressed,
                  std::uint64_t raw_bytes);

}  // namespace crossgrain
