// SPDX-License-Identifier: Apache-2.0
// Keeps the state of long sweeps, to go on from it after a break.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/interface.hpp"

namespace crossgrain {

/// A list with one value for each leaf of this process, ghosts included.
struct LeafValues {
  std::span<std::byte> bytes;
  std::size_t size;  ///< bytes of a value
};

/// What sweeps have come to, the same in all processes.
struct SweepsSoFar {
  int sweeps = 0;
  double energy = 0;
  std::vector<double> decreases;  ///< of the last sweep, for each block of all processes, phase by phase
};

/// All processes call each function together.
class SweepKeeper : public Interface {
 public:
  /// Returns whether the state is to be kept now.
  virtual bool is_due() = 0;
  virtual void keep(const SweepsSoFar& sweeps, std::span<const LeafValues> lists) = 0;

  /// Sets the values of own leaves to those of an earlier solve, and returns what its sweeps had come to;
  /// nothing if there is none to go on from.
  virtual std::optional<SweepsSoFar> resumed(std::span<const LeafValues> lists) = 0;
};

}  // namespace crossgrain
