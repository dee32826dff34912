// SPDX-License-Identifier: Apache-2.0
// Manifold sweeps of degree 4 as one would write them first: doubles, a cell at a time, in the order of the
// cells, over a box of cells with eighteen neighbours each. What the library's speed is measured against, in
// the same run: figures in seconds say more of the machine than of the code. So it has data structures of its
// own, and only the mathematics of src/harmonics.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/quaternion.hpp"
#include "harmonics/coefficients.hpp"

namespace crossgrain {

class PlainBox {
 public:
  /// `across` cells along each side, at least 2, each with a frame a tenth of a radian off the axes.
  explicit PlainBox(std::uint32_t across);

  std::size_t size() const { return frames_.size(); }

  /// Every cell in turn takes a Newton step towards its neighbours.
  void sweep();

  /// The sum over neighbours of |h_i - h_j|^2: what sweeps lower.
  double energy() const;

 private:
  std::vector<std::uint32_t> row_begin_;
  std::vector<std::uint32_t> neighbours_;
  std::vector<Quaternion> frames_;
  std::vector<Coefficients<4>> coefficients_;
};

}  // namespace crossgrain
