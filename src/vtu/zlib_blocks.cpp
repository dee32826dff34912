// SPDX-License-Identifier: Apache-2.0
#include "vtu/zlib_blocks.hpp"

#include <libdeflate.h>
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <new>

#include "base/parallel.hpp"
#include "files/read_memory.hpp"

namespace crossgrain {
namespace {

/// Deflate cannot compress by more than about 1032:1, so data that claim more are damaged.
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
  const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> decompressor(
      libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  if (!decompressor) throw std::bad_alloc();
  // Without a place for the number of bytes, another number than `raw_bytes` is an error.
  return libdeflate_zlib_decompress(decompressor.get(), compressed.data(), compressed.size(), out, raw_bytes,
                                    nullptr) == LIBDEFLATE_SUCCESS;
}

bool inflate_onto(const std::string& name, std::string& out, std::span<const unsigned char> compressed,
                  std::uint64_t raw_bytes) {
  constexpr std::uint64_t kPiece = 1 << 16;
  if (compressed.size() > std::numeric_limits<uInt>::max()) return false;
  struct Stream : z_stream {
    ~Stream() { inflateEnd(this); }
  } stream{};
  // The interface of zlib lacks const; it does not write to the input.
  stream.next_in = const_cast<unsigned char*>(compressed.data());
  stream.avail_in = static_cast<uInt>(compressed.size());
  if (inflateInit(&stream) != Z_OK) return false;
  const std::size_t begin = out.size();
  int code = Z_OK;
  while (code == Z_OK) {
    const std::size_t done = out.size();
    // One byte more, to detect a stream that continues.
    const std::uint64_t room = std::min(kPiece, raw_bytes - (done - begin) + 1);
    check_watched();
    if (done + room > out.capacity()) {
      const std::size_t capacity = std::max(done + room, 2 * out.capacity());
      require_read_memory(name, static_cast<double>(capacity));
      out.reserve(capacity);
    }
    out.resize(done + room);
    stream.next_out = reinterpret_cast<unsigned char*>(out.data() + done);
    stream.avail_out = static_cast<uInt>(room);
    code = inflate(&stream, Z_NO_FLUSH);
    out.resize(out.size() - stream.avail_out);
    if (out.size() - begin > raw_bytes) break;
  }
  return code == Z_STREAM_END && out.size() - begin == raw_bytes;
}

}  // namespace crossgrain
