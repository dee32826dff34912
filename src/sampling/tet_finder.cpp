// SPDX-License-Identifier: Apache-2.0
#include "sampling/tet_finder.hpp"

#include <algorithm>
#include <cmath>

namespace crossgrain {
namespace {

/// Number of tets per box if they were spread evenly over the bounding box; each is in several boxes.
constexpr double kTetsPerBox = 4;
constexpr int kMostAlong = 1000;

Box box_of(const std::array<std::uint32_t, 4>& tet, std::span<const Vector3> vertices) {
  Box box = empty_box();
  for (const std::uint32_t v : tet) include(box, vertices[v]);
  return box;
}

}  // namespace

TetFinder::TetFinder(std::span<const Vector3> vertices, std::span<const std::array<std::uint32_t, 4>> tets)
    : box_(empty_box()) {
  for (const auto& tet : tets)
    for (const std::uint32_t v : tet) include(box_, vertices[v]);
  const Vector3 sides = box_.high - box_.low;
  const double side =
      std::cbrt(sides[0] * sides[1] * sides[2] * kTetsPerBox / std::max<double>(1, double(tets.size())));
  for (std::size_t k = 0; k < 3; ++k) {
    count_[k] = std::clamp(static_cast<int>(std::clamp(sides[k] / side, 0.0, 1e6)), 1, kMostAlong);
    per_length_[k] = count_[k] / sides[k];
  }
  const auto for_boxes = [&](const auto& add) {
    for (std::uint32_t t = 0; t < tets.size(); ++t) {
      const Box box = box_of(tets[t], vertices);
      const std::array<int, 3> low = cell_of(box.low), high = cell_of(box.high);
      for (int z = low[2]; z <= high[2]; ++z)
        for (int y = low[1]; y <= high[1]; ++y)
          for (int x = low[0]; x <= high[0]; ++x) add(index_of({x, y, z}), t);
    }
  };
  tets_ = {static_cast<std::size_t>(count_[0]) * count_[1] * count_[2], for_boxes};
}

std::span<const std::uint32_t> TetFinder::near(const Vector3& point) const {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(point[k] >= box_.low[k] && point[k] <= box_.high[k])) return {};
  return in_cell(cell_of(point));
}

std::array<int, 3> TetFinder::cell_of(const Vector3& point) const {
  std::array<int, 3> cell;
  for (std::size_t k = 0; k < 3; ++k) {
    const double along = (point[k] - box_.low[k]) * per_length_[k];
    cell[k] = static_cast<int>(std::clamp<double>(std::floor(along), 0, count_[k] - 1));
  }
  return cell;
}

std::size_t TetFinder::index_of(const std::array<int, 3>& cell) const {
  return (static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(count_[1]) +
          static_cast<std::size_t>(cell[1])) *
             static_cast<std::size_t>(count_[0]) +
         static_cast<std::size_t>(cell[0]);
}

std::span<const std::uint32_t> TetFinder::in_cell(const std::array<int, 3>& cell) const {
  return tets_[index_of(cell)];
}

}  // namespace crossgrain
