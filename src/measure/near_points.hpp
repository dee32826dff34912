// SPDX-License-Identifier: Apache-2.0
// Points within a distance of a place.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/vector3.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// Points in cubes of one width, sorted by cube.
class NearPoints {
 public:
  NearPoints(const std::vector<Vector3>& points, double width) : points_(points), width_(width) {
    entries_.reserve(points.size());
    for (std::uint32_t k = 0; k < points.size(); ++k) entries_.push_back({cube_of(points[k]), k});
    std::ranges::sort(entries_);
  }

  /// Calls visit(index, squared distance) for every point within the width of a place.
  template <class Visit>
  void for_each_near(const Vector3& place, const Visit& visit) const {
    const Cube middle = cube_of(place);
    for (std::int64_t x = middle[0] - 1; x <= middle[0] + 1; ++x) {
      for (std::int64_t y = middle[1] - 1; y <= middle[1] + 1; ++y) {
        // The three cubes of a row follow each other.
        auto entry = std::ranges::lower_bound(entries_, Entry{{x, y, middle[2] - 1}, 0});
        for (; entry != entries_.end() && entry->cube <= Cube{x, y, middle[2] + 1}; ++entry) {
          const Vector3 off = points_[entry->point] - place;
          if (const double square = dot(off, off); square <= width_ * width_) visit(entry->point, square);
        }
      }
    }
  }

 private:
  using Cube = std::array<std::int64_t, 3>;
  struct Entry {
    Cube cube;
    std::uint32_t point;

    friend auto operator<=>(const Entry&, const Entry&) = default;
  };

  Cube cube_of(const Vector3& point) const {
    // Far beyond any model in its own hexahedra, and safe to convert.
    constexpr double kMost = 1e15;
    Cube cube;
    for (std::size_t axis = 0; axis < 3; ++axis)
      cube[axis] = static_cast<std::int64_t>(std::clamp(std::floor(point[axis] / width_), -kMost, kMost));
    return cube;
  }

  const std::vector<Vector3>& points_;
  double width_;
  std::vector<Entry> entries_;
};

}  // namespace crossgrain
