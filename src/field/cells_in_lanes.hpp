// SPDX-License-Identifier: Apache-2.0
// Processes cells of one run side by side in lanes (base/lanes.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/instruction_set.hpp"
#include "base/lane_rows.hpp"
#include "base/lanes.hpp"
#include "base/parallel.hpp"
#include "field/field_state.hpp"
#include "field/sweep_messages.hpp"
#include "field/sweep_order.hpp"

namespace crossgrain {

/// The cell in each lane. Only the first `count` lanes may be stored; if cells run out, the last cell fills
/// the other lanes.
template <int W>
struct CellsInLanes {
  std::array<std::uint32_t, W> cells;
  int count;

  CellsInLanes(std::span<const std::uint32_t> from, std::size_t begin)
      : count(static_cast<int>(std::min<std::size_t>(W, from.size() - begin))) {
    for (int lane = 0; lane < W; ++lane)
      cells[lane] = from[begin + static_cast<std::size_t>(std::min(lane, count - 1))];
  }
  std::uint32_t operator[](int lane) const { return cells[lane]; }
};

/// Which cells a sweep visits, by a byte for each block and one for each cell; all of them where there are
/// none. The byte of a visited cell becomes zero before the visit, which may set it and those of neighbours.
struct VisitedCells {
  std::span<const std::uint8_t> blocks = {};
  std::span<std::uint8_t> cells = {};

  /// Moves the cells of a run that are to be visited to `chosen`.
  std::span<const std::uint32_t> choose(std::span<const std::uint32_t> run,
                                        std::vector<std::uint32_t>& chosen) const {
    if (cells.empty()) return run;
    chosen.clear();
    for (const std::uint32_t cell : run) {
      // Cells of other blocks that are visited now may be neighbours of those, not of this one.
      if (cells[cell] == 0) continue;
      cells[cell] = 0;
      chosen.push_back(cell);
    }
    return chosen;
  }
};

/// Calls visit(CellsInLanes<W>, block) for the visited cells in the order, compiled for this processor, W
/// being the number of its lanes of floats. Blocks are visited from several threads: one with blocks beside
/// it as soon as those of lower phases are done, also those of other processes, given the messages between
/// them; others phase by phase.
template <class Visit>
void visit_in_lanes(const SweepOrder& order, const Visit& visit, const VisitedCells& visited = {},
                    SweepMessages* messages = nullptr) {
  const std::function<void(std::size_t)> visit_block = [&](std::size_t block) {  // compiled once
    if (!visited.blocks.empty() && !visited.blocks[block]) return;
    std::vector<std::uint32_t> chosen;
    run_in_lanes([&]<int Doubles>() {
      constexpr int W = 2 * Doubles;
      for (std::size_t r = order.block_begin[block]; r < order.block_begin[block + 1]; ++r) {
        const std::span<const std::uint32_t> run = visited.choose(order.run(r), chosen);
        for (std::size_t i = 0; i < run.size(); i += W) visit(CellsInLanes<W>(run, i), block);
      }
    });
  };
  if (messages != nullptr) {
    parallel_for_in_order(order.blocks_beside, visit_block, *messages);
    return messages->finish();
  }
  if (!order.blocks_beside.empty()) return parallel_for_in_order(order.blocks_beside, visit_block);
  for (std::size_t phase = 0; phase < order.phase_count(); ++phase) {
    const std::size_t first = order.phase_begin[phase];
    parallel_for(
        order.phase_begin[phase + 1] - first, [&](std::size_t k) { visit_block(first + k); }, 1);
  }
}

/// Held axes of the cells (CellForms::hold_axis), with a mask of the cells that have one.
template <class Real>
struct HeldAxes {
  static constexpr int W = Real::kCount;

  BasicVector3<Real> axes{0.0, 0.0, 1.0};
  typename Real::Mask mask;
  bool any = false;

  template <class Forms>
  HeldAxes(const Forms& forms, const CellsInLanes<W>& cells) {
    for (int lane = 0; lane < W; ++lane) {
      const Vector3* axis = forms.held_axis(cells[lane]);
      if (axis == nullptr) continue;
      for (int k = 0; k < 3; ++k) axes[k].set(lane, (*axis)[k]);
      mask.set(lane, true);
      any = true;
    }
  }
};

template <class Real>
BasicQuaternion<Real> from_stored(const std::vector<StoredQuaternion>& frames,
                                  const CellsInLanes<Real::kCount>& cells) {
  const auto [w, x, y, z] = four_from_rows<Real>([&](int lane) { return &frames[cells[lane]].w; });
  return normalised(BasicQuaternion<Real>{w, x, y, z});
}

template <int D, class Real>
Coefficients<D, Real> from_stored(const std::vector<StoredCoefficients<D>>& coefficients,
                                  const CellsInLanes<Real::kCount>& cells) {
  const auto row_from = [&](int first) {
    return [&, first](int lane) { return coefficients[cells[lane]].data() + first; };
  };
  const auto low = four_from_rows<Real>(row_from(0)), high = four_from_rows<Real>(row_from(4));
  Coefficients<D, Real> h;
  for (int m = 0; m < std::min(8, kCoefficientCount<D>); ++m) h[m] = m < 4 ? low[m] : high[m - 4];
  if constexpr (D == 4) {
    for (int lane = 0; lane < Real::kCount; ++lane) h[8].set(lane, coefficients[cells[lane]][8]);
  }
  return h;
}

template <int D, class Real>
void store_in(std::vector<StoredCoefficients<D>>& coefficients, const CellsInLanes<Real::kCount>& cells,
              const std::array<bool, Real::kCount>& is_stored, const Coefficients<D, Real>& h) {
  const auto row_from = [&](int first) {
    return
        [&, first](int lane) { return is_stored[lane] ? coefficients[cells[lane]].data() + first : nullptr; };
  };
  four_to_rows<Real>({h[0], h[1], h[2], h[3]}, row_from(0));
  four_to_rows<Real>({h[4], h[5], h[6], D == 3 ? Real(0) : h[D == 3 ? 0 : 7]}, row_from(4));
  if constexpr (D == 4) {
    for (int lane = 0; lane < Real::kCount; ++lane)
      if (is_stored[lane]) coefficients[cells[lane]][8] = static_cast<float>(h[8][lane]);
  }
}

template <int D, class Real>
void store_in(FieldState<D>& state, const CellsInLanes<Real::kCount>& cells,
              const std::array<bool, Real::kCount>& is_stored, const BasicQuaternion<Real>& frame,
              const Coefficients<D, Real>& h) {
  four_to_rows<Real>({frame.w, frame.x, frame.y, frame.z},
                     [&](int lane) { return is_stored[lane] ? &state.frames[cells[lane]].w : nullptr; });
  store_in<D>(state.coefficients, cells, is_stored, h);
}

}  // namespace crossgrain
