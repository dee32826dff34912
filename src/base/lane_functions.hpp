// SPDX-License-Identifier: Apache-2.0
// Elementary functions of lanes, with the same bits on all processors and for any number of lanes.
#pragma once

#include <cstdint>
#include <cstring>

#include "base/lanes.hpp"

namespace crossgrain {

/// Returns x^(-1/3) within 2 units in the last place, for x from 2^-1000 to 2^1000.
template <int W>
Lanes<W> inverse_cube_root(const Lanes<W>& x) {
  using Mask = typename Lanes<W>::Mask;
  using Native = typename Lanes<W>::Native;
  using Words = typename Mask::Native;
  // The upper half of the bits is about 2^20 times the logarithm. It becomes a number, -1/3 of which and four
  // thirds of the exponent's bias are the upper half of the result, less what makes the largest error
  // smallest, which is then 3.4 %. In a double of 2^52 and more the lowest bits are an integer.
  constexpr double kIntegers = 0x1p52, kOfBias = 1430188295;
  constexpr std::int64_t kBitsOfIntegers = 0x4330000000000000;
  Words words;
  std::memcpy(&words, &x.native, sizeof words);
  words = (words >> 32) | kBitsOfIntegers;
  Native upper;
  std::memcpy(&upper, &words, sizeof words);
  upper = (kOfBias - (upper - kIntegers) * (1.0 / 3)) + kIntegers;
  std::memcpy(&words, &upper, sizeof words);
  words <<= 32;
  Native root;
  std::memcpy(&root, &words, sizeof words);
  // x root^3 = 1 - h: the series of (1 - h)^(-1/3) to its square, which takes h to about 14/27 h^3.
  constexpr int kSteps = 3;
  for (int step = 0; step < kSteps; ++step) {
    const Native h = 1 - x.native * root * root * root;
    root += root * (h * (1.0 / 3 + h * (2.0 / 9)));
  }
  return Lanes<W>(root);
}

}  // namespace crossgrain
