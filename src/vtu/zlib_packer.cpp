// SPDX-License-Identifier: Apache-2.0
#include "vtu/zlib_packer.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <new>

namespace crossgrain {
namespace {

/// Of 12. On the points, indices and axes of a field, 6 takes eight times as long as 1 for files that are 2 %
/// smaller.
constexpr int kLevel = 1;

/// A block is searched for repetitions if its first 1 / kSampleShare shrinks to this share. Packing takes
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
  const auto check = static_cast<std::size_t>(libdeflate_adler32(1, bytes.data(), bytes.size()));
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

void ZlibPacker::Free::operator()(libdeflate_compressor* compressor) const {
  libdeflate_free_compressor(compressor);
}

ZlibPacker::ZlibPacker() : compressor_(libdeflate_alloc_compressor(kLevel)) {
  // With a valid level, only lack of memory can fail.
  if (!compressor_) throw std::bad_alloc();
}

std::size_t ZlibPacker::pack(std::span<const unsigned char> bytes, VtuPacking packing,
                             std::vector<unsigned char>& out) {
  if (packing == VtuPacking::kMeasured) {
    const auto sample = bytes.first(bytes.size() / kSampleShare);
    const auto packed = static_cast<double>(deflate_all(sample, out));
    if (packed > kManyRepetitions * static_cast<double>(sample.size())) return store(bytes, out);
  }
  return deflate_all(bytes, out);
}

std::size_t ZlibPacker::deflate_all(std::span<const unsigned char> bytes, std::vector<unsigned char>& out) {
  const std::size_t bound = libdeflate_zlib_compress_bound(compressor_.get(), bytes.size());
  if (out.size() < bound) out.resize(bound);
  return libdeflate_zlib_compress(compressor_.get(), bytes.data(), bytes.size(), out.data(), out.size());
}

}  // namespace crossgrain
