// SPDX-License-Identifier: Apache-2.0
// The frame at any point of a field that is known cell by cell.
#pragma once

#include <span>
#include <vector>

#include "sampling/leaf_turn.hpp"

namespace crossgrain {

/// Interpolates a field. Inside an active leaf, every leaf i around that is joined to it through open faces
/// extends its frame by its turn W_i (sampling/leaf_turn.hpp) over (d_i + r) / 2, with d_i = x - c_i and r
/// the mean of the d_i; the degree-4 coefficients of these frames are blended with the weights product over
/// axes of max(0, 1 - |d_i| / s_i), which the means are taken with too, and projected to the nearest frame.
///
/// Where the leaves lie evenly around x, r is 0 and half the turn is just what reproduces a field that is
/// quadratic in x: third order. At the surface, where they lie on one side, r makes up for it: exact for
/// linear fields, second order. The blend is continuous across faces, between leaves of different size too.
/// Leaves across an outside gap take no part. Elsewhere: the frame of the nearest active leaf.
///
/// Holds at most 38 bytes a leaf of its own and refers to the arrays given, which must outlive it. Queries
/// allocate nothing and are safe from any number of threads. Which axes the cells' frames name x, y, z
/// changes answers by rounding only.
class Sampler {
 public:
  /// Finds the turns of all leaves, in parallel. `open_faces` as in LeafConnections.
  Sampler(const Octree& tree, std::span<const StoredQuaternion> frames,
          std::span<const std::uint8_t> open_faces);

  struct Result {
    Quaternion frame;
    CellIndex leaf;       ///< that holds the point, or the nearest one
    bool in_active_cell;  ///< whether it holds the point
    double deviation;     ///< as FrameField::Sample has it
  };

  /// The frame at a point of finite coordinates. The field must have a leaf.
  Result at(const Vector3& point) const;

  /// The frame at a point of the closed box of leaf `leaf`, as that leaf sees it.
  Quaternion in_leaf(CellIndex leaf, const Vector3& point) const;

  /// The same as `at` of many points, to the bit; fast where points that follow each other are near each
  /// other.
  void at(std::span<const Vector3> points, std::span<Result> results) const;

 private:
  template <std::size_t kPoints>
  class Run;

  LeafField field_;
  std::vector<LeafTurn> turns_;
};

}  // namespace crossgrain
