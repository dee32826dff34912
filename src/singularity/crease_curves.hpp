// SPDX-License-Identifier: Apache-2.0
// Which short lines keep close to one crease.
#pragma once

#include <span>
#include <vector>

#include "base/vector3.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// Curves, to be asked which points lie along one of them. The polylines must outlive it.
class CreaseCurves {
 public:
  explicit CreaseCurves(std::span<const std::vector<Vector3>> curves);

  /// Returns whether one curve is within `reach` of every point.
  bool one_follows(std::span<const Vector3> points, double reach) const;

 private:
  std::span<const std::vector<Vector3>> curves_;
  std::vector<Box> boxes_;  ///< around each curve
};

}  // namespace crossgrain
