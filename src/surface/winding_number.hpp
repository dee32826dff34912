// SPDX-License-Identifier: Apache-2.0
// Inside or outside, for surfaces that may have holes, overlaps and wrong orientation.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "surface/bvh.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// Generalised winding number of a triangle soup (Jacobson et al. 2013): the solid angle of the surface seen
/// from p, over 4 pi. It is 1 inside a closed outward-oriented surface, 0 outside, and in between near holes.
/// Groups of triangles far from p are replaced by multipoles (Barill et al. 2018); near triangles count
/// exactly. Refers to the tree and its surface, which must outlive it. Queries are thread-safe.
class WindingNumber {
 public:
  /// A multipole replaces a group of triangles for points farther from its centre than beta times its radius.
  /// winding_number.cpp has a table of the accuracy and cost of beta.
  explicit WindingNumber(const TriangleBvh& bvh, double beta = kDefaultBeta);

  /// Returns the winding number at p for the outward orientation (see `flipped`), within 0.02 of the exact
  /// sum.
  double at(const Vector3& p) const;

  bool inside(const Vector3& p) const { return at(p) > 0.5; }

  /// True if the surface as a whole is inside out: its enclosed volume, sum of a_t n_t . (c_t - c) / 3 with
  /// the centroids c_t and their weighted mean c, is negative. `at` then reverses every triangle. The
  /// decision is for the whole surface: a single component with opposite orientation stays so.
  bool flipped() const { return orientation_ < 0; }

  static constexpr double kDefaultBeta = 1.75;

 private:
  class ClusterMaker;

  /// Triangles [first, first + count) and their multipoles, in unit coordinates: the longest side of the box
  /// is 1, its middle the origin. In depth-first order as in TriangleBvh. Single precision saves cache.
  struct Cluster {
    std::array<float, 3> centre;
    float squared_reach;              ///< (beta * radius)^2: for nearer points the cluster is opened
    std::array<float, 3> dipole;      ///< N_x, N_y, N_z
    std::array<float, 5> quadrupole;  ///< Q_xx, Q_yy, Q_xy, Q_yz, Q_zx
    std::array<float, 7> octupole;    ///< S_xxx, S_yyy, S_xxy, S_xyy, S_xxz, S_yyz, S_xyz
    std::uint32_t skip, first, count;
  };

  std::array<Vector3, 3> unit_corners(std::size_t place) const;
  static double far_solid_angle(const Cluster& cluster, float x, float y, float z);
  Vector3 to_unit(const Vector3& p) const;
  double exact_solid_angle(const Cluster& leaf, const Vector3& p) const;

  const TriangleBvh* bvh_;
  Vector3 middle_;
  double scale_;
  double orientation_ = 1;
  std::vector<Cluster> clusters_;
};

}  // namespace crossgrain
