// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "display/surface_numbers.hpp"

namespace crossgrain {

class TetNumbers {
 public:
  TetNumbers(const ShownField& field, SurfaceNumber number);

  double at(const SurfacePoint& point) const;
  double energy_of_tet(std::uint32_t tet) const { return static_cast<double>(densities_[tet]); }
  std::vector<SurfaceNumbers::Sample> samples() const;
  std::vector<float> at_vertices() const;

 private:
  void average_alignment();
  void average_energy();

  const ShownField& field_;
  std::vector<float> densities_;               ///< energy per volume of each tet; empty for kAlignment
  float least_ = 0;                            ///< smallest energy between vertices
  std::vector<std::array<float, 3>> numbers_;  ///< at the corners of each triangle; NaN if it has no tet
};

}  // namespace crossgrain
