// SPDX-License-Identifier: Apache-2.0
#include "lattice/lattice_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/boxes.hpp"
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
  Repair(const std::vector<float>& shares, const LatticePlanes& planes,
         const std::function<std::vector<Box>()>& small_bodies, KeptCells& kept)
      : shares_(shares),
        planes_(planes),
        counts_{planes.cells(0), planes.cells(1), planes.cells(2)},
        small_bodies_(small_bodies),
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

  struct LatticeBody {
    std::size_t size = 0;
    Vector3 sum{0, 0, 0};  ///< of the middles of its cells
  };

  Vector3 middle_of(std::size_t cell) const {
    const std::array<std::size_t, 3> at{cell / (counts_[1] * counts_[2]), cell / counts_[2] % counts_[1],
                                        cell % counts_[2]};
    Vector3 middle{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      middle[axis] = 0.5 * (planes_.at[axis][at[axis]] + planes_.at[axis][at[axis] + 1]);
    return middle;
  }

  void leave_out_crumbs() {
    std::vector<std::uint32_t> body_of(shares_.size(), 0);
    std::vector<LatticeBody> bodies(1);
    std::size_t largest = 0;
    for (std::size_t cell = 0; cell < shares_.size(); ++cell) {
      if (!kept_.is_kept[cell]) continue;
      if (body_of[cell] == 0) {
        flood(cell, static_cast<std::uint32_t>(bodies.size()), body_of);
        bodies.emplace_back();
      }
      LatticeBody& body = bodies[body_of[cell]];
      body.sum += middle_of(cell);
      largest = std::max(largest, ++body.size);
    }
    std::vector<std::uint8_t> is_crumb(bodies.size(), 0);
    for (std::size_t k = 1; k < bodies.size(); ++k)
      is_crumb[k] = static_cast<double>(bodies[k].size) < kLeastBody * static_cast<double>(largest);
    if (std::ranges::count(is_crumb, 1) == 0) return;
    const std::vector<Box> spared = small_bodies_();
    for (std::size_t k = 1; k < bodies.size(); ++k) {
      const Vector3 middle = (1.0 / static_cast<double>(bodies[k].size)) * bodies[k].sum;
      if (std::ranges::any_of(spared, [&](const Box& box) { return contains(box, middle); })) is_crumb[k] = 0;
    }
    for (std::size_t cell = 0; cell < shares_.size(); ++cell)
      if (kept_.is_kept[cell] && is_crumb[body_of[cell]]) kept_.is_kept[cell] = 0;
  }

  /// Marks what is connected to a cell. The outermost cells are not kept, so that
  /// all cells beside one of those are there.
  void flood(std::size_t first, std::uint32_t body, std::vector<std::uint32_t>& body_of) const {
    const std::array<std::size_t, 3> steps = {counts_[1] * counts_[2], counts_[2], 1};
    std::vector<std::size_t> open = {first};
    body_of[first] = body;
    Checkpoint checkpoint;
    while (!open.empty()) {
      checkpoint.pass();
      const std::size_t cell = open.back();
      open.pop_back();
      for (const std::size_t step : steps)
        for (const std::size_t other : {cell - step, cell + step})
          if (kept_.is_kept[other] && body_of[other] == 0) {
            body_of[other] = body;
            open.push_back(other);
          }
    }
  }

  const std::vector<float>& shares_;
  const LatticePlanes& planes_;
  const std::array<std::size_t, 3> counts_;
  const std::function<std::vector<Box>()>& small_bodies_;
  KeptCells& kept_;
};

}  // namespace

KeptCells kept_cells(const std::vector<float>& shares, const LatticePlanes& planes,
                     const std::function<std::vector<Box>()>& small_bodies) {
  KeptCells kept;
  kept.is_kept.resize(shares.size());
  for (std::size_t cell = 0; cell < shares.size(); ++cell) kept.is_kept[cell] = shares[cell] >= kKeptShare;
  Repair(shares, planes, small_bodies, kept).run();
  return kept;
}

}  // namespace crossgrain
