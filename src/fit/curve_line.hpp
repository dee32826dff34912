// SPDX-License-Identifier: Apache-2.0
// A curve by its length, with the nearest of its points.
#pragma once

#include <cstddef>
#include <vector>

#include "crossgrain/types.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

/// A polyline whose points are found by their arc length and by what they are near to. Arc lengths of a
/// closed one are periodic. Queries are thread-safe.
class CurveLine {
 public:
  struct Nearest {
    double distance, arc_length;
    Vector3 tangent;  ///< unit, along the curve
  };

  CurveLine(const FeatureComplex& features, std::uint32_t curve);

  double length() const { return lengths_.back(); }
  Vector3 at(double arc_length) const;

  /// Returns the nearest point among those from one arc length to another, not lower one, at most a length
  /// apart. Those of an open curve end at 0 and at its length.
  Nearest nearest(const Vector3& p, double low, double high) const;

 private:
  void search(const Vector3& p, double low, double high, Nearest& best) const;

  bool is_closed_;
  std::vector<Vector3> points_;
  std::vector<double> lengths_;  ///< up to each point

  /// Boxes of kRun segments each, then of two boxes each: those of node k are 2 k and 2 k + 1, the root is 1.
  std::vector<Box> boxes_;
  std::size_t runs_ = 1;  ///< leaves, a power of two
};

}  // namespace crossgrain
