// SPDX-License-Identifier: Apache-2.0
#include "lattice/lattice_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

constexpr unsigned kAround = 8;  ///< cells at a vertex: bit 0 of their number is x, bit 1 y, bit 2 z

/// Number of sets, connected by faces, of the cells around a vertex in a mask.
unsigned parts_of(unsigned mask) {
  unsigned parts = 0;
  while (mask != 0) {
    ++parts;
    unsigned reached = mask & (~mask + 1);
    for (unsigned before = 0; before != reached;) {
      before = reached;
      reached |= mask & (((reached & 0x55) << 1) | ((reached & 0xaa) >> 1));
      reached |= mask & (((reached & 0x33) << 2) | ((reached & 0xcc) >> 2));
      reached |= mask & (((reached & 0x0f) << 4) | ((reached & 0xf0) >> 4));
    }
    mask &= ~reached;
  }
  return parts;
}

bool is_manifold_at(unsigned mask) {
  return parts_of(mask) <= 1 && parts_of(~mask & 0xff) <= 1;
}

class Repair {
 public:
  Repair(const std::vector<float>& shares, const LatticePlanes& planes, std::size_t bodies, KeptCells& kept)
      : shares_(shares),
        counts_{planes.cells(0), planes.cells(1), planes.cells(2)},
        bodies_(bodies),
        kept_(kept) {}

  void run() {
    // Few are left after ten; what is not mended then goes round in circles.
    constexpr int kMostRounds = 60;
    std::vector<std::uint8_t> changes(shares_.size(), 0);
    for (int round = 0; round < kMostRounds; ++round) {
      kept_.faults = 0;
      for_each_vertex([&](std::size_t i, std::size_t j, std::size_t k) { mend(i, j, k, changes); });
      if (kept_.faults == 0) break;
    }
    leave_out_crumbs();
    kept_.toggled = 0;
    for (std::size_t cell = 0; cell < shares_.size(); ++cell)
      kept_.toggled += (shares_[cell] >= kKeptShare) != (kept_.is_kept[cell] != 0);
  }

 private:
  std::size_t index(std::size_t i, std::size_t j, std::size_t k) const {
    return (i * counts_[1] + j) * counts_[2] + k;
  }

  /// A cell around the inner vertex with the lowest corner of cell (i, j, k).
  std::size_t around(std::size_t i, std::size_t j, std::size_t k, unsigned q) const {
    return index(i - 1 + (q & 1), j - 1 + (q >> 1 & 1), k - 1 + (q >> 2));
  }

  template <class Visit>
  void for_each_vertex(const Visit& visit) const {
    Checkpoint checkpoint;
    for (std::size_t i = 1; i < counts_[0]; ++i)
      for (std::size_t j = 1; j < counts_[1]; ++j)
        for (std::size_t k = 1; k < counts_[2]; ++k) {
          checkpoint.pass();
          visit(i, j, k);
        }
  }

  bool is_border(std::size_t i, std::size_t j, std::size_t k, unsigned q) const {
    const std::array<std::size_t, 3> cell = {i - 1 + (q & 1), j - 1 + (q >> 1 & 1), k - 1 + (q >> 2)};
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (cell[axis] == 0 || cell[axis] + 1 == counts_[axis]) return true;
    return false;
  }

  /// Changes a cell at a vertex that needs it.
  void mend(std::size_t i, std::size_t j, std::size_t k, std::vector<std::uint8_t>& changes) {
    unsigned mask = 0;
    for (unsigned q = 0; q < kAround; ++q)
      mask |= static_cast<unsigned>(kept_.is_kept[around(i, j, k, q)]) << q;
    if (is_manifold_at(mask)) return;
    ++kept_.faults;
    constexpr double kNotEnough = 2;   // of a change that leaves the fault
    constexpr double kOfChange = 0.3;  // of each change of the same cell before
    double least = 1e9;
    std::size_t best = 0;
    for (unsigned q = 0; q < kAround; ++q) {
      if (is_border(i, j, k, q)) continue;
      const std::size_t cell = around(i, j, k, q);
      const double cost = std::abs(shares_[cell] - kKeptShare) + kOfChange * changes[cell] +
                          (is_manifold_at(mask ^ (1u << q)) ? 0 : kNotEnough);
      if (cost >= least) continue;
      least = cost;
      best = cell;
    }
    if (least == 1e9) return;
    kept_.is_kept[best] ^= 1;
    changes[best] = static_cast<std::uint8_t>(std::min(changes[best] + 1, 255));
  }

  void leave_out_crumbs() {
    std::vector<std::uint32_t> body_of(shares_.size(), 0);
    std::vector<std::size_t> sizes = {0};
    for (std::size_t cell = 0; cell < shares_.size(); ++cell)
      if (kept_.is_kept[cell] && body_of[cell] == 0) {
        const auto body = static_cast<std::uint32_t>(sizes.size());
        sizes.push_back(flood(cell, body, body_of));
      }
    std::vector<std::size_t> largest = sizes;
    std::ranges::sort(largest, std::greater());
    const double least = std::min(kLeastBody * static_cast<double>(largest.front()),
                                  static_cast<double>(largest[std::min(bodies_, sizes.size()) - 1]));
    for (std::size_t cell = 0; cell < shares_.size(); ++cell)
      if (kept_.is_kept[cell] && static_cast<double>(sizes[body_of[cell]]) < least) kept_.is_kept[cell] = 0;
  }

  /// Marks what is connected to a cell; returns how many those are. The outermost cells are not kept, so that
  /// all cells beside one of those are there.
  std::size_t flood(std::size_t first, std::uint32_t body, std::vector<std::uint32_t>& body_of) const {
    const std::array<std::size_t, 3> steps = {counts_[1] * counts_[2], counts_[2], 1};
    std::vector<std::size_t> open = {first};
    body_of[first] = body;
    std::size_t size = 0;
    Checkpoint checkpoint;
    while (!open.empty()) {
      checkpoint.pass();
      const std::size_t cell = open.back();
      open.pop_back();
      ++size;
      for (const std::size_t step : steps)
        for (const std::size_t other : {cell - step, cell + step})
          if (kept_.is_kept[other] && body_of[other] == 0) {
            body_of[other] = body;
            open.push_back(other);
          }
    }
    return size;
  }

  const std::vector<float>& shares_;
  const std::array<std::size_t, 3> counts_;
  const std::size_t bodies_;
  KeptCells& kept_;
};

}  // namespace

KeptCells kept_cells(const std::vector<float>& shares, const LatticePlanes& planes, std::size_t bodies) {
  KeptCells kept;
  kept.is_kept.resize(shares.size());
  for (std::size_t cell = 0; cell < shares.size(); ++cell) kept.is_kept[cell] = shares[cell] >= kKeptShare;
  Repair(shares, planes, bodies, kept).run();
  return kept;
}

}  // namespace crossgrain
