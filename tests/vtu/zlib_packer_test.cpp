// SPDX-License-Identifier: Apache-2.0
#include "vtu/zlib_packer.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <random>

namespace crossgrain {
namespace {

using Bytes = std::vector<unsigned char>;

Bytes random_bytes(std::size_t count) {
  std::mt19937 random(4);
  Bytes bytes(count);
  for (unsigned char& byte : bytes) byte = static_cast<unsigned char>(random());
  return bytes;
}

Bytes packed(ZlibPacker& packer, const Bytes& bytes, VtuPacking packing) {
  Bytes out;
  out.resize(packer.pack(bytes, packing, out));
  return out;
}

Bytes unpacked(const Bytes& stream, std::size_t expected) {
  Bytes bytes(expected + 1);
  uLongf got = bytes.size();
  EXPECT_EQ(uncompress(bytes.data(), &got, stream.data(), stream.size()), Z_OK);
  bytes.resize(got);
  return bytes;
}

class ZlibPackerOf : public testing::TestWithParam<VtuPacking> {};
INSTANTIATE_TEST_SUITE_P(Packings, ZlibPackerOf, testing::Values(VtuPacking::kAlways, VtuPacking::kMeasured));

TEST_P(ZlibPackerOf, MakesStreamsThatZlibUnpacks) {
  ZlibPacker packer;
  // About the lengths of a stored block, and what no sample can be taken of.
  for (const std::size_t size : {0u, 1u, 15u, 16u, 65534u, 65535u, 65536u, 131070u, 262144u}) {
    for (const Bytes& bytes : {random_bytes(size), Bytes(size, 7)})
      EXPECT_EQ(unpacked(packed(packer, bytes, GetParam()), size), bytes) << size;
  }
}

TEST_P(ZlibPackerOf, MakesTheSameBytesWhateverItMadeBefore) {
  ZlibPacker used;
  for (const VtuPacking packing : {VtuPacking::kAlways, VtuPacking::kMeasured}) {
    packed(used, random_bytes(100000), packing);
    packed(used, Bytes(1000, 1), packing);
  }
  Bytes bytes = random_bytes(3000);
  for (int i = 0; i < 5; ++i) bytes.insert(bytes.end(), bytes.begin(), bytes.begin() + 2000);
  ZlibPacker fresh;
  EXPECT_EQ(packed(used, bytes, GetParam()), packed(fresh, bytes, GetParam()));
}

TEST(ZlibPacker, StoresMeasuredNumbersOnlyWhereTheyDoNotRepeat) {
  ZlibPacker packer;
  constexpr std::size_t kSize = 1 << 18;
  const std::size_t noise = packed(packer, random_bytes(kSize), VtuPacking::kMeasured).size();
  EXPECT_GE(noise, kSize);
  EXPECT_LE(noise, kSize + 100);
  EXPECT_LT(packed(packer, Bytes(kSize, 7), VtuPacking::kMeasured).size(), kSize / 100);
}

}  // namespace
}  // namespace crossgrain
