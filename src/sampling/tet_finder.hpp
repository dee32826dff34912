// SPDX-License-Identifier: Apache-2.0
// Tets by place.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/lists.hpp"
#include "base/vector3.hpp"

namespace crossgrain {

/// A table of boxes of equal size over the bounding box of the tets, each with the tets whose boxes meet it.
/// Refers to nothing. Queries are safe from any number of threads.
class TetFinder {
 public:
  TetFinder(std::span<const Vector3> vertices, std::span<const std::array<std::uint32_t, 4>> tets);

  const Box& box() const { return box_; }

  /// The tets that may hold a point, ascending; empty for points outside the bounding box and for coordinates
  /// that are not finite.
  std::span<const std::uint32_t> near(const Vector3& point) const;

  /// Calls visit(tet) at least once for every tet whose box meets another box.
  template <class Visit>
  void for_near(const Box& box, const Visit& visit) const {
    const std::array<int, 3> low = cell_of(box.low), high = cell_of(box.high);
    for (int z = low[2]; z <= high[2]; ++z)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int x = low[0]; x <= high[0]; ++x)
          for (const std::uint32_t tet : in_cell({x, y, z})) visit(tet);
  }

 private:
  std::array<int, 3> cell_of(const Vector3& point) const;
  std::size_t index_of(const std::array<int, 3>& cell) const;
  std::span<const std::uint32_t> in_cell(const std::array<int, 3>& cell) const;

  Box box_;
  std::array<int, 3> count_{1, 1, 1};
  Vector3 per_length_;  ///< boxes per length along each axis
  Lists<std::uint32_t, std::size_t> tets_;
};

}  // namespace crossgrain
