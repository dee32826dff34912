// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/lists.hpp"
#include "field/solved_surface.hpp"

namespace crossgrain {

/// The regions of a surface on a plane normal to a coordinate axis, to the exact outline of each. Safe to use
/// from any number of threads.
class RegionSections {
 public:
  /// `regions` in the order in which they are asked: the first that encloses a point has it.
  RegionSections(const SolvedSurface& surface, const std::vector<std::int32_t>& regions, std::size_t axis,
                 double position);

  /// The region that encloses a point of the plane; none outside of all, and where an outline is not closed.
  std::optional<std::int32_t> at(const Vector3& point) const;

 private:
  /// An edge of a region's outline in the plane; coordinates along and across, up if it ends further across.
  struct Edge {
    double from_along, from_across, to_along, to_across;
    int turn;  ///< change of the winding number to its right
  };

  /// The edges of one region, listed in each strip of the plane that they pass.
  struct Outline {
    std::int32_t region;
    Lists<Edge> edges;
  };

  std::size_t strip_of(double across) const;

  std::size_t along_, across_;
  double low_ = 0, strips_per_length_ = 0;
  std::vector<Outline> outlines_;
};

}  // namespace crossgrain
