// SPDX-License-Identifier: Apache-2.0
// Notation: r = centre - p. The solid angle of triangles with unit normals n is the integral of n . F(x - p)
// over their points x, with F(r) = r / |r|^3 = -grad(1 / |r|). Expanded about the centre, with y = x - centre
// and summed over triangles,
//
//   N_i F_i + M_ij d_j F_i + T_ijk d_j d_k F_i,   N = sum of int n,  M = sum of int n y^T,  T = 1/2 sum of
//   int n y y^T.
//
// Derivatives of 1 / |r| are symmetric and traceless, so only these parts Q of M and S of T are left:
//
//   N . r / |r|^3  -  3 Q_ij r_i r_j / |r|^5  +  15 S_ijk r_i r_j r_k / |r|^7.
//
// What beta buys, over random points in the cube around spheres and tori of 5k to 100k triangles: the largest
// error, and the clusters that a query looks at (random points / points within 0.03 of a torus of 100k; one
// takes about 20 ns).
//
//   beta          1.5        1.75       2          2.5        3
//   error         .027       .014       .0082      .0044      .0015
//   looked at     29 / 121   42 / 166   58 / 216   99 / 337   153 / 481
#include "surface/winding_number.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <unordered_map>

#include "base/parallel.hpp"
#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Centres are stored in single precision, with errors up to 6e-8. A cluster at least this far away is not
/// affected.
constexpr double kLeastReach = 2e-5;

/// Distance, in units of the surface's size, at which even an open surface has no visible solid angle; keeps
/// single precision finite.
constexpr double kFarAway = 1e6;

Vector3 area_vector(const std::array<Vector3, 3>& corners) {
  return 0.5 * cross(corners[1] - corners[0], corners[2] - corners[0]);
}

Vector3 centroid(const std::array<Vector3, 3>& corners) {
  return (1.0 / 3) * (corners[0] + corners[1] + corners[2]);
}

/// Adds angles of complex numbers by multiplying them, and counts how often the product crosses the negative
/// real axis, so that many triangles need only one arc tangent.
class AngleSum {
 public:
  void add(double re, double im) {
    if (re == 0 && im == 0) return;  // p is a corner of the triangle
    const double product_re = re_ * re - im_ * im, product_im = re_ * im + im_ * re;
    if (im_ >= 0 && im >= 0 && product_im < 0) ++turns_;
    if (im_ < 0 && im < 0 && product_im >= 0) --turns_;
    re_ = product_re;
    im_ = product_im;
  }
  double angle_rad() const { return std::atan2(im_ + 0.0, re_) + 2 * std::numbers::pi * turns_; }

 private:
  double re_ = 1, im_ = 0;
  int turns_ = 0;
};

/// Sums of M and T over triangles, given by their corners relative to the centre.
class Multipoles {
 public:
  /// Adds the sums of other triangles about another centre, `offset` from this one; `dipole` is their N.
  void add(const Multipoles& other, const Vector3& dipole, const Vector3& offset) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        m_[i][j] += other.m_[i][j] + dipole[i] * offset[j];
        for (std::size_t k = 0; k <= j; ++k)
          t_[i][j][k] += other.t_[i][j][k] + 12 * (other.m_[i][j] * offset[k] + other.m_[i][k] * offset[j] +
                                                   dipole[i] * offset[j] * offset[k]);
      }
    }
  }

  void add(const std::array<Vector3, 3>& corners) {
    const Vector3 n = area_vector(corners), c = centroid(corners);
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i) m_[i][j] += n[i] * c[j];
      for (std::size_t k = 0; k <= j; ++k) {
        // Twelve times the mean of y_j y_k over a triangle, from its corners and centroid.
        double mean = 9 * c[j] * c[k];
        for (const Vector3& y : corners) mean += y[j] * y[k];
        for (std::size_t i = 0; i < 3; ++i) t_[i][j][k] += n[i] * mean;
      }
    }
  }

  std::array<float, 5> quadrupole() const {
    const double trace = m_[0][0] + m_[1][1] + m_[2][2];
    const auto q = [&](std::size_t i, std::size_t j) {
      return static_cast<float>(0.5 * (m_[i][j] + m_[j][i]) - (i == j ? trace / 3 : 0));
    };
    return {q(0, 0), q(1, 1), q(0, 1), q(1, 2), q(2, 0)};
  }

  std::array<float, 7> octupole() const {
    const auto t = [&](std::size_t i, std::size_t j, std::size_t k) {
      return t_[i][std::max(j, k)][std::min(j, k)];
    };
    // Of the sums a mean of three, one half for T, one twelfth for the means over triangles.
    const auto symmetric = [&](std::size_t i, std::size_t j, std::size_t k) {
      return (t(i, j, k) + t(j, k, i) + t(k, i, j)) / 72;
    };
    const auto trace = [&](std::size_t k) {
      return symmetric(0, 0, k) + symmetric(1, 1, k) + symmetric(2, 2, k);
    };
    const auto s = [&](std::size_t i, std::size_t j, std::size_t k) {
      const double traces = (i == j ? trace(k) : 0) + (j == k ? trace(i) : 0) + (k == i ? trace(j) : 0);
      return static_cast<float>(symmetric(i, j, k) - traces / 5);
    };
    return {s(0, 0, 0), s(1, 1, 1), s(0, 0, 1), s(0, 1, 1), s(0, 0, 2), s(1, 1, 2), s(0, 1, 2)};
  }

 private:
  std::array<std::array<double, 3>, 3> m_{};
  std::array<std::array<std::array<double, 3>, 3>, 3> t_{};  ///< times 24; only where the second index is
                                                             ///< not below the third, as T is symmetric
};

/// Relative to the mean of the surface, so that the volume of an open surface does not depend on its
/// position.
double enclosed_volume(const std::vector<std::array<Vector3, 3>>& triangles) {
  double area = 0;
  Vector3 moment{0, 0, 0};
  for (const auto& corners : triangles) {
    const double weight = norm(area_vector(corners));
    area += weight;
    moment += weight * centroid(corners);
  }
  const Vector3 mean = (1 / area) * moment;
  double volume = 0;
  for (const auto& corners : triangles) volume += dot(area_vector(corners), centroid(corners) - mean) / 3;
  return volume;
}

}  // namespace

/// Makes clusters from the leaves up: the sums of a node are those of its children about another centre.
class WindingNumber::ClusterMaker {
 public:
  using Nodes = std::vector<TriangleBvh::Node>;
  using Corners = std::vector<std::array<Vector3, 3>>;

  ClusterMaker(const Nodes& nodes, const Corners& corners, double beta)
      : nodes_(nodes), corners_(corners), beta_(beta), clusters_(sized_vector<Cluster>(nodes.size())) {}

  std::vector<Cluster> clusters() {
    // Subtrees of few triangles are made side by side, then the nodes above them.
    std::vector<std::uint32_t> above, subtrees;
    for (std::uint32_t i = 0; i < nodes_.size();) {
      const bool is_small = nodes_[i].count <= kSubtreeTriangles || is_leaf(i);
      (is_small ? subtrees : above).push_back(i);
      i = is_small ? nodes_[i].skip : i + 1;
    }
    std::vector<Sums> of_subtrees(subtrees.size());
    parallel_for(
        subtrees.size(), [&](std::size_t k) { of_subtrees[k] = made(subtrees[k]); }, 1);
    std::unordered_map<std::uint32_t, Sums> known;
    for (std::size_t k = 0; k < subtrees.size(); ++k) known.emplace(subtrees[k], of_subtrees[k]);
    std::vector<Vector3> centres(above.size());
    for (std::size_t k = above.size(); k-- > 0;) {
      const std::uint32_t lower = above[k] + 1;
      const Sums sums = Sums(known.at(lower), known.at(nodes_[lower].skip));
      centres[k] = sums.centre;
      set(above[k], sums);
      known.emplace(above[k], sums);
    }
    parallel_for(
        above.size(), [&](std::size_t k) { set_reach(above[k], centres[k]); }, 1);
    return std::move(clusters_);
  }

 private:
  static constexpr std::uint32_t kSubtreeTriangles = 8192;

  /// Sums over the triangles of a node.
  struct Sums {
    double area = 0;
    Vector3 dipole{0, 0, 0}, moment{0, 0, 0}, centre{0, 0, 0};
    Multipoles multipoles;  ///< about the centre

    Sums() = default;

    explicit Sums(std::span<const std::array<Vector3, 3>> triangles) {
      for (const auto& corners : triangles) {
        const Vector3 n = area_vector(corners);
        add(norm(n), n, norm(n) * centroid(corners));
      }
      centre = area > 0 ? (1 / area) * moment : centroid(triangles.front());
      for (const auto& [a, b, c] : triangles) multipoles.add({a - centre, b - centre, c - centre});
    }

    Sums(const Sums& lower, const Sums& upper) {
      for (const Sums* child : {&lower, &upper}) add(child->area, child->dipole, child->moment);
      centre = area > 0 ? (1 / area) * moment : lower.centre;
      for (const Sums* child : {&lower, &upper})
        multipoles.add(child->multipoles, child->dipole, child->centre - centre);
    }

   private:
    void add(double more_area, const Vector3& more_dipole, const Vector3& more_moment) {
      area += more_area;
      dipole += more_dipole;
      moment += more_moment;
    }
  };

  bool is_leaf(std::uint32_t i) const { return nodes_[i].skip == i + 1; }

  std::span<const std::array<Vector3, 3>> triangles(std::uint32_t i) const {
    return std::span(corners_).subspan(nodes_[i].first, nodes_[i].count);
  }

  /// Makes the clusters of a subtree and returns the sums of its root.
  Sums made(std::uint32_t i) {
    const Sums sums = is_leaf(i) ? Sums(triangles(i)) : Sums(made(i + 1), made(nodes_[i + 1].skip));
    set(i, sums);
    set_reach(i, sums.centre);
    return sums;
  }

  void set(std::uint32_t i, const Sums& sums) {
    Cluster& cluster = clusters_[i];
    for (std::size_t k = 0; k < 3; ++k) cluster.centre[k] = static_cast<float>(sums.centre[k]);
    for (std::size_t k = 0; k < 3; ++k) cluster.dipole[k] = static_cast<float>(sums.dipole[k]);
    cluster.quadrupole = sums.multipoles.quadrupole();
    cluster.octupole = sums.multipoles.octupole();
    cluster.skip = nodes_[i].skip;
    cluster.first = nodes_[i].first;
    cluster.count = nodes_[i].count;
  }

  void set_reach(std::uint32_t i, const Vector3& centre) {
    double squared_radius = 0;
    for (const auto& corners : triangles(i))
      for (const Vector3& corner : corners)
        squared_radius = std::max(squared_radius, dot(corner - centre, corner - centre));
    const double reach = std::max(beta_ * std::sqrt(squared_radius), kLeastReach);
    clusters_[i].squared_reach = static_cast<float>(reach * reach);
  }

  const Nodes& nodes_;
  const Corners& corners_;
  double beta_;
  std::vector<Cluster> clusters_;
};

WindingNumber::WindingNumber(const TriangleBvh& bvh, double beta) : bvh_(&bvh) {
  const Box& box = bvh.surface().box;
  const Vector3 size = box.high - box.low;
  middle_ = 0.5 * (box.low + box.high);
  scale_ = 1 / std::max({size[0], size[1], size[2]});

  // Side by side only for the many sums here.
  auto corners = sized_vector<std::array<Vector3, 3>>(bvh.triangle_order().size());
  parallel_for(corners.size(), [&](std::size_t i) { corners[i] = unit_corners(i); });

  clusters_ = ClusterMaker(bvh.nodes(), corners, beta).clusters();

  if (enclosed_volume(corners) < 0) orientation_ = -1;
}

/// The corners of the triangle at a place in the order of the tree, in unit coordinates.
std::array<Vector3, 3> WindingNumber::unit_corners(std::size_t place) const {
  const auto [a, b, c] = bvh_->surface().corners(bvh_->triangle_order()[place]);
  return {to_unit(a), to_unit(b), to_unit(c)};
}

Vector3 WindingNumber::to_unit(const Vector3& p) const {
  return scale_ * (p - middle_);
}

/// With r = (x, y, z); the components of Q and S that are not stored follow from the traces.
double WindingNumber::far_solid_angle(const Cluster& cluster, float x, float y, float z) {
  const auto& n = cluster.dipole;
  const auto& q = cluster.quadrupole;
  const auto& s = cluster.octupole;
  const float xx = x * x, yy = y * y, zz = z * z;
  const float inverse_squared = 1 / (xx + yy + zz);
  const float first = n[0] * x + n[1] * y + n[2] * z;
  const float second = q[0] * (xx - zz) + q[1] * (yy - zz) + 2 * (q[2] * x * y + q[3] * y * z + q[4] * z * x);
  const float third = s[0] * x * (xx - 3 * zz) + s[1] * y * (yy - 3 * zz) + 3 * s[2] * y * (xx - zz) +
                      3 * s[3] * x * (yy - zz) + s[4] * z * (3 * xx - zz) + s[5] * z * (3 * yy - zz) +
                      6 * s[6] * x * y * z;
  return static_cast<double>((first + (15 * third * inverse_squared - 3 * second) * inverse_squared) *
                             inverse_squared * std::sqrt(inverse_squared));
}

/// Van Oosterom and Strackee (1983): tan(angle / 2) = a . (b x c) / (|a||b||c| + (a.b)|c| + (b.c)|a| +
/// (c.a)|b|).
double WindingNumber::exact_solid_angle(const Cluster& leaf, const Vector3& p) const {
  AngleSum half_angles;
  for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
    const std::array<Vector3, 3> corners = unit_corners(i);
    const Vector3 a = corners[0] - p, b = corners[1] - p, c = corners[2] - p;
    const double la = norm(a), lb = norm(b), lc = norm(c);
    half_angles.add(la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb, dot(a, cross(b, c)));
  }
  return 2 * half_angles.angle_rad();
}

double WindingNumber::at(const Vector3& p) const {
  const Vector3 unit = to_unit(p);
  if (!(dot(unit, unit) < kFarAway * kFarAway)) return 0;
  const auto px = static_cast<float>(unit[0]), py = static_cast<float>(unit[1]),
             pz = static_cast<float>(unit[2]);
  double solid_angle = 0;
  for (std::uint32_t i = 0; i < clusters_.size();) {
    const Cluster& cluster = clusters_[i];
    const float x = cluster.centre[0] - px, y = cluster.centre[1] - py, z = cluster.centre[2] - pz;
    const float squared = x * x + y * y + z * z;
    if (squared > cluster.squared_reach) {
      solid_angle += far_solid_angle(cluster, x, y, z);
      i = cluster.skip;
    } else if (cluster.skip == i + 1) {
      solid_angle += exact_solid_angle(cluster, unit);
      ++i;
    } else {
      ++i;
    }
  }
  return orientation_ * solid_angle / (4 * std::numbers::pi);
}

}  // namespace crossgrain
