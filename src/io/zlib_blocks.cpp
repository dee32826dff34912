// SPDX-License-Identifier: Apache-2.0
#include "io/zlib_blocks.hpp"

#include <zlib.h>

namespace crossgrain {
namespace {

/// Deflate cannot shrink data further than about 1032:1, so what claims to is damaged.
constexpr std::uint64_t kLargestRatio = 1040;

}  // namespace

std::optional<ZlibBlocks> zlib_blocks(const std::array<std::uint64_t, 3>& head,
                                      std::span<const std::uint64_t> sizes, std::uint64_t begin,
                                      std::uint64_t end) {
  const auto [count, block_bytes, last_bytes] = head;
  if (count != sizes.size() || last_bytes > block_bytes || (count > 0 && block_bytes == 0)) return {};
  ZlibBlocks blocks;
  blocks.block_bytes = block_bytes;
  blocks.begins.reserve(count + 1);
  blocks.begins.push_back(begin);
  const std::uint64_t last_block_bytes = last_bytes > 0 ? last_bytes : block_bytes;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t raw_bytes = i + 1 < count ? block_bytes : last_block_bytes;
    if (sizes[i] > end - blocks.begins[i] || raw_bytes / kLargestRatio > sizes[i]) return {};
    blocks.begins.push_back(blocks.begins[i] + sizes[i]);
  }
  if (count > 0) blocks.raw_bytes = (count - 1) * block_bytes + last_block_bytes;
  return blocks;
}

bool inflate_block(std::span<const unsigned char> compressed, char* out, std::uint64_t raw_bytes) {
  uLongf got = raw_bytes;
  const int code =
      uncompress(reinterpret_cast<unsigned char*>(out), &got, compressed.data(), compressed.size());
  return code == Z_OK && got == raw_bytes;
}

}  // namespace crossgrain
