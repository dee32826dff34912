// SPDX-License-Identifier: Apache-2.0
// Moves numbers between rows (one per cell) and lanes (one per cell). Lane by lane, a number takes several
// instructions; four at a time, less than one.
#pragma once

#include <array>
#include <cstring>
#include <type_traits>
#include <utility>

#include "base/lanes.hpp"

namespace crossgrain {

/// Four numbers from each of W rows.
template <class Real>
using FourOfRows = std::array<Real, 4>;

namespace lane_rows {

/// Transposes each block of four lanes: number i of lane j becomes number j of lane i.
template <int W>
FourOfRows<SingleLanes<W>> transposed(const FourOfRows<SingleLanes<W>>& x) {
  using Real = SingleLanes<W>;
  return [&]<int... L>(std::integer_sequence<int, L...>) {
    // Shuffles of two vectors, block by block: `first` and `last` interleave their first or last two lanes;
    // `low` and `high` join them.
    constexpr std::integer_sequence<int, (L / 4 * 4 + L % 4 / 2 + (L % 2 ? W : 0))...> first;
    constexpr std::integer_sequence<int, (L / 4 * 4 + L % 4 / 2 + 2 + (L % 2 ? W : 0))...> last;
    constexpr std::integer_sequence<int, (L % 4 < 2 ? L : W + L - 2)...> low;
    constexpr std::integer_sequence<int, (L % 4 < 2 ? L + 2 : W + L)...> high;
    const auto mixed = []<int... I>(const Real& a, const Real& b, std::integer_sequence<int, I...>) {
      return Real(__builtin_shufflevector(a.native, b.native, I...));
    };
    const Real a = mixed(x[0], x[1], first), b = mixed(x[0], x[1], last);
    const Real c = mixed(x[2], x[3], first), d = mixed(x[2], x[3], last);
    return FourOfRows<Real>{mixed(a, c, low), mixed(a, c, high), mixed(b, d, low), mixed(b, d, high)};
  }
  (std::make_integer_sequence<int, W>());
}

/// Returns the blocks of four numbers at row(First), row(First + 4), ... in one vector.
template <int W, int First, class RowOf>
SingleLanes<W> blocks_from(const RowOf& row) {
  if constexpr (W == 4) {
    return lanes_of<SingleLanes<4>>(row(First));
  } else {
    const auto low = blocks_from<W / 2, First>(row);
    const auto high = blocks_from<W / 2, First + W / 2>(row);
    return [&]<int... L>(std::integer_sequence<int, L...>) {
      return SingleLanes<W>(__builtin_shufflevector(low.native, high.native, L...));
    }
    (std::make_integer_sequence<int, W>());
  }
}

template <int Block, int W>
SingleLanes<4> block_of(const SingleLanes<W>& x) {
  return __builtin_shufflevector(x.native, x.native, 4 * Block, 4 * Block + 1, 4 * Block + 2, 4 * Block + 3);
}

}  // namespace lane_rows

/// Returns the four numbers at row(lane) for every lane. Rows are in single precision or in that of Real.
template <class Real, class RowOf>
FourOfRows<Real> four_from_rows(const RowOf& row) {
  constexpr int W = Real::kCount;
  FourOfRows<Real> x;
  if constexpr (std::is_same_v<Real, SingleLanes<W>>) {
    [&]<int... J>(std::integer_sequence<int, J...>) {
      ((x[J] = lane_rows::blocks_from<W, J>(row)), ...);
    }
    (std::make_integer_sequence<int, 4>());
    return lane_rows::transposed<W>(x);
  } else {
    for (int lane = 0; lane < W; ++lane) {
      const auto* const from = row(lane);
      for (int k = 0; k < 4; ++k) x[k].set(lane, from[k]);
    }
    return x;
  }
}

/// Writes the four numbers of each lane to the floats at row(lane); lanes whose row is null are skipped.
template <class Real, class RowOf>
void four_to_rows(const FourOfRows<Real>& x, const RowOf& row) {
  constexpr int W = Real::kCount;
  if constexpr (std::is_same_v<Real, SingleLanes<W>>) {
    const auto blocks = lane_rows::transposed<W>(x);
    const auto store = [&]<int Lane>() {
      const SingleLanes<4> four = lane_rows::block_of<Lane / 4>(blocks[Lane % 4]);
      if (float* const to = row(Lane)) std::memcpy(to, &four.native, sizeof four.native);
    };
    [&]<int... Lane>(std::integer_sequence<int, Lane...>) {
      (store.template operator()<Lane>(), ...);
    }
    (std::make_integer_sequence<int, W>());
  } else {
    for (int lane = 0; lane < W; ++lane) {
      float* const to = row(lane);
      if (to == nullptr) continue;
      for (int k = 0; k < 4; ++k) to[k] = static_cast<float>(x[k][lane]);
    }
  }
}

}  // namespace crossgrain
