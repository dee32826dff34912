// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vector3.hpp"

namespace crossgrain {

/// Where a plane square to a coordinate axis cuts a surface: its segments, in no order.
class CutOutline {
 public:
  struct Segment {
    Vector3 from, to;
    Vector3 normal;  ///< of the triangle; not of unit length
  };

  CutOutline(const std::vector<Vector3>& vertices, const std::vector<std::array<std::uint32_t, 3>>& triangles,
             std::size_t axis, double position);

  const std::vector<Segment>& segments() const { return segments_; }

  /// Whether the surface, which looks out, encloses a point of the plane.
  bool encloses(const Vector3& point) const;

  /// From a point of the plane to the nearest segment; infinity where there is none.
  double distance_to(const Vector3& point) const;

 private:
  std::size_t axis_;
  std::vector<Segment> segments_;
};

}  // namespace crossgrain
