// SPDX-License-Identifier: Apache-2.0
// Points of a model's features near given points.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "surface/bvh.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

/// Groups of faces, curves and corners of a model. All queries are thread-safe.
class FeatureCarriers {
 public:
  struct Place {
    Vector3 point;
    Vector3 direction;  ///< unit: the normal of a face, or along a curve
  };

  /// `group_of_face`: the lowest face of those that are one (HexCarriers). The complex must outlive it.
  FeatureCarriers(const FeatureComplex& complex, const std::vector<std::uint32_t>& group_of_face);

  /// Returns the point of a group of faces nearest to p. Triangles that do not face along `normal`, of length
  /// 1 or 0, count as if they were up to `reach` farther: across a thin wall, or a crease inside the group.
  Place on_group(std::uint32_t group, const Vector3& p, const Vector3& normal, double reach) const;

  double length(std::uint32_t curve) const { return curves_[curve].lengths.back(); }
  bool is_closed(std::uint32_t curve) const { return complex_->curves[curve].is_closed(); }

  /// Returns the point of a curve at an arc length; that of a closed curve is periodic, others end.
  Place on_curve(std::uint32_t curve, double arc_length) const;

  /// Returns the arc length of the point nearest to p among those between two arc lengths; of a closed curve
  /// these may lie outside of its period.
  double nearest_on_curve(std::uint32_t curve, const Vector3& p, double low, double high) const;

  /// Returns arc lengths that divide a curve into as many edges, where it turns into shorter ones: each has
  /// the same sum of its length in sizes and kTurnShare times its turn. The first is `first`, the last one
  /// length later; `first` is 0 unless the curve is closed.
  std::vector<double> shares(std::uint32_t curve, std::size_t edges, double size, double first) const;

  const Vector3& corner(std::uint32_t corner) const { return complex_->corners[corner].point; }

 private:
  struct Group {
    Surface surface;
    std::optional<TriangleBvh> tree;
  };
  struct Polyline {
    std::vector<Vector3> points;
    std::vector<double> lengths;    ///< of the curve up to each point
    std::vector<Vector3> tangents;  ///< at each point
  };
  Polyline polyline_of(const FeatureComplex::Curve& curve) const;
  std::size_t segment_at(const Polyline& polyline, double arc_length) const;

  const FeatureComplex* complex_;
  std::vector<std::unique_ptr<Group>> groups_;  ///< by their lowest face; null for others
  std::vector<Polyline> curves_;
};

}  // namespace crossgrain
