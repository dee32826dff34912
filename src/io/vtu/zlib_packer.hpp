// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <zlib.h>

#include <cstddef>
#include <span>
#include <vector>

namespace crossgrain {

/// How an array is packed into zlib streams.
enum class VtuPacking {
  /// With a search for repetitions: grids, numbers, flags.
  kRepetitions,

  /// Byte by byte: numbers of few different bytes in no order. Takes half the time.
  kSingleBytes,

  /// Repetitions where a block has many, and as it is where not: measured numbers, directions. Of a curved
  /// part's a third would go, at 50 MB a second, and a tenth byte by byte, at 115; a flat part's are all the
  /// same.
  kMeasured
};

/// Makes zlib streams, of the same bytes whatever it made before.
class ZlibPacker {
 public:
  /// `level` of zlib, 1 to 9. Takes 270 kB.
  explicit ZlibPacker(int level);
  ~ZlibPacker();
  ZlibPacker(const ZlibPacker&) = delete;
  ZlibPacker& operator=(const ZlibPacker&) = delete;

  /// A stream of `bytes`, less than 4 GB, at the front of `out`, which is made large enough; returns its
  /// length.
  std::size_t pack(std::span<const unsigned char> bytes, VtuPacking packing, std::vector<unsigned char>& out);

 private:
  std::size_t deflate_all(std::span<const unsigned char> bytes, int strategy,
                          std::vector<unsigned char>& out);

  int level_;
  z_stream stream_{};
};

}  // namespace crossgrain
