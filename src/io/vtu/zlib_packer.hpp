// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <zlib.h>

#include <cstddef>
#include <span>
#include <vector>

namespace crossgrain {

/// Strategy of packing an array into zlib streams.
enum class VtuPacking {
  /// With a search for repetitions: grids, numbers, flags.
  kRepetitions,

  /// Byte by byte (Huffman only): numbers of few distinct bytes without order. Takes half the time.
  kSingleBytes,

  /// With a search if a block has many repetitions, else stored: measured numbers, directions. On a curved
  /// part, a search would save a third at 50 MB/s, and byte by byte a tenth at 115 MB/s; on a flat part
  /// nearly everything repeats.
  kMeasured
};

/// Makes zlib streams whose bytes do not depend on earlier calls.
class ZlibPacker {
 public:
  /// `level` of zlib, 1 to 9. Takes 270 kB.
  explicit ZlibPacker(int level);
  ~ZlibPacker();
  ZlibPacker(const ZlibPacker&) = delete;
  ZlibPacker& operator=(const ZlibPacker&) = delete;

  /// Writes `bytes`, less than 4 GB, as a stream to the start of `out`, which is enlarged if needed. Returns
  /// its length.
  std::size_t pack(std::span<const unsigned char> bytes, VtuPacking packing, std::vector<unsigned char>& out);

 private:
  std::size_t deflate_all(std::span<const unsigned char> bytes, int strategy,
                          std::vector<unsigned char>& out);

  int level_;
  z_stream stream_{};
};

}  // namespace crossgrain
