// SPDX-License-Identifier: Apache-2.0
#include "io/vtu/zlib_packer.hpp"

#include <algorithm>
#include <new>

namespace crossgrain {
namespace {

/// A block is searched for repetitions if its first 1 / kSampleShare shrinks to this share. The search takes
/// a fifth of the time at a half that it takes for data without repetitions.
constexpr std::size_t kSampleShare = 16;
constexpr double kManyRepetitions = 0.5;

/// Returns `bytes` as a zlib stream of stored blocks (RFC 1950, RFC 1951 section 3.2.4).
std::size_t store(std::span<const unsigned char> bytes, std::vector<unsigned char>& out) {
  constexpr std::size_t kLongestBlock = 0xffff, kHeaderBytes = 2, kBlockHeaderBytes = 5, kCheckBytes = 4;
  const std::size_t blocks = std::max<std::size_t>(1, (bytes.size() + kLongestBlock - 1) / kLongestBlock);
  const std::size_t size = kHeaderBytes + blocks * kBlockHeaderBytes + bytes.size() + kCheckBytes;
  if (out.size() < size) out.resize(size);
  auto to = out.begin();
  const auto put = [&to](std::size_t value) { *to++ = static_cast<unsigned char>(value); };
  put(0x78);  // deflate with a window of 32 kB,
  put(0x01);  // at the least effort; together a multiple of 31
  const auto check = static_cast<std::size_t>(adler32_z(1, bytes.data(), bytes.size()));
  for (std::size_t block = 0; block < blocks; ++block) {
    const auto part = bytes.subspan(block * kLongestBlock)
                          .first(std::min(kLongestBlock, bytes.size() - block * kLongestBlock));
    put(block + 1 == blocks ? 1 : 0);
    for (const std::size_t length : {part.size(), ~part.size()}) {
      put(length);
      put(length >> 8);
    }
    to = std::copy(part.begin(), part.end(), to);
  }
  for (const int shift : {24, 16, 8, 0}) put(check >> shift);
  return size;
}

}  // namespace

ZlibPacker::ZlibPacker(int level) : level_(level) {
  // With a valid level, zlib fails only for lack of memory.
  if (deflateInit(&stream_, level) != Z_OK) throw std::bad_alloc();
}

ZlibPacker::~ZlibPacker() {
  deflateEnd(&stream_);
}

std::size_t ZlibPacker::pack(std::span<const unsigned char> bytes, VtuPacking packing,
                             std::vector<unsigned char>& out) {
  if (packing == VtuPacking::kSingleBytes) return deflate_all(bytes, Z_HUFFMAN_ONLY, out);
  if (packing == VtuPacking::kMeasured) {
    const auto sample = bytes.first(bytes.size() / kSampleShare);
    const auto packed = static_cast<double>(deflate_all(sample, Z_DEFAULT_STRATEGY, out));
    if (packed > kManyRepetitions * static_cast<double>(sample.size())) return store(bytes, out);
  }
  return deflate_all(bytes, Z_DEFAULT_STRATEGY, out);
}

std::size_t ZlibPacker::deflate_all(std::span<const unsigned char> bytes, int strategy,
                                    std::vector<unsigned char>& out) {
  deflateReset(&stream_);
  deflateParams(&stream_, level_, strategy);
  const std::size_t bound = deflateBound(&stream_, bytes.size());
  if (out.size() < bound) out.resize(bound);
  stream_.next_in = const_cast<Bytef*>(bytes.data());  // zlib does not write to it
  stream_.avail_in = static_cast<uInt>(bytes.size());
  stream_.next_out = out.data();
  stream_.avail_out = static_cast<uInt>(out.size());
  // The buffer is large enough, so only lack of memory can fail.
  if (deflate(&stream_, Z_FINISH) != Z_STREAM_END) throw std::bad_alloc();
  return stream_.total_out;
}

}  // namespace crossgrain
