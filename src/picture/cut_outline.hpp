// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vector3.hpp"

namespace crossgrain {

/// The intersection of a surface with a plane normal to a coordinate axis, as unordered segments.
class CutOutline {
 public:
  struct Segment {
    Vector3 from, to;
    Vector3 normal;  ///< normal of the triangle; not of unit length
  };

  CutOutline(const std::vector<Vector3>& vertices, const std::vector<std::array<std::uint32_t, 3>>& triangles,
             std::size_t axis, double position);

  const std::vector<Segment>& segments() const { return segments_; }

  /// Whether the surface, which is oriented outward, encloses a point of the plane.
  bool encloses(const Vector3& point) const;

  /// Distance from a point of the plane to the nearest segment; infinity without segments.
  double distance_to(const Vector3& point) const;

 private:
  std::size_t axis_;
  std::vector<Segment> segments_;
};

}  // namespace crossgrain
