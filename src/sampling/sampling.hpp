// SPDX-License-Identifier: Apache-2.0
// The frame at any point of a field that is given cell by cell.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sampling/leaf_turn.hpp"

namespace crossgrain {

/// Interpolates a field. Inside an active leaf, each leaf i around that is joined to it through open faces
/// extends its frame by its turn W_i (sampling/leaf_turn.hpp) over (d_i + r) / 2, with d_i = x - c_i and r
/// the weighted mean of the d_i; the degree-4 coefficients of these frames are blended with the weights
/// product over axes of max(0, 1 - |d_i| / s_i), also used for the mean, and projected to the nearest frame.
///
/// If the leaves are evenly around x, r is 0 and half the turn exactly reproduces a field that is quadratic
/// in x: third order. At the surface, where they are on one side, r compensates: exact for linear fields,
/// second order. The blend is continuous across faces, also between leaves of different size. Leaves across
/// an outside gap are not used. Outside the active leaves, the result is the frame of the nearest one.
///
/// Takes at most 38 bytes per leaf, 2 with turns on demand, and refers to the arrays given, which must
/// outlive it. Queries allocate nothing and are safe from any number of threads. Renaming the axes of the
/// cells' frames changes results by rounding only.
class Sampler {
 public:
  /// When turns are computed. Results are the same to the bit.
  enum class Turns : std::uint8_t {
    kOfAll,     ///< those of all leaves at once, in parallel
    kOnDemand,  ///< those around a point with each query: about ten, so for fewer points than a tenth of
                ///< leaves
  };

  /// `open_faces` as in LeafConnections.
  Sampler(const Octree& tree, std::span<const StoredQuaternion> frames,
          std::span<const std::uint8_t> open_faces, Turns turns = Turns::kOfAll);

  struct Result {
    Quaternion frame;
    CellIndex leaf;       ///< leaf that holds the point, or the nearest one
    bool in_active_cell;  ///< whether `leaf` holds the point
    double deviation;     ///< as in FrameField::Sample
  };

  /// The frame at a point with finite coordinates. The field must have a leaf.
  Result at(const Vector3& point) const;

  /// The frame of a leaf, as at a point outside to which it is the nearest.
  Quaternion frame_of(CellIndex leaf) const { return from_stored(field_.frames[leaf]); }

  /// The frame at a point of the closed box of leaf `leaf`, from the leaves joined to that one.
  Quaternion in_leaf(CellIndex leaf, const Vector3& point) const;

  /// Samples many points, bitwise identical to calling `at` on each; fast if consecutive points are near each
  /// other.
  void at(std::span<const Vector3> points, std::span<Result> results) const;

 private:
  template <std::size_t kPoints>
  class Run;

  LeafField field_;
  std::vector<LeafTurn> turns_;  ///< none on demand
};

}  // namespace crossgrain
