// SPDX-License-Identifier: Apache-2.0
#include "picture/layout.hpp"

#include <algorithm>
#include <atomic>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

/// Whether a triangle and a box are disjoint, tested by separating lines along their sides.
bool are_apart(const std::array<std::array<double, 2>, 3>& triangle, const PixelBox& box) {
  const auto [low_x, high_x] = std::minmax({triangle[0][0], triangle[1][0], triangle[2][0]});
  const auto [low_y, high_y] = std::minmax({triangle[0][1], triangle[1][1], triangle[2][1]});
  if (high_x < box.left || low_x > box.right || high_y < box.top || low_y > box.bottom) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &a = triangle[i], &b = triangle[(i + 1) % 3], &c = triangle[(i + 2) % 3];
    const auto side = [&](double x, double y) {
      return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    };
    const double inner = side(c[0], c[1]);
    bool all_beyond = true;
    for (const double x : {box.left, box.right})
      for (const double y : {box.top, box.bottom}) all_beyond = all_beyond && side(x, y) * inner < 0;
    if (all_beyond) return true;
  }
  return false;
}

bool overlap(const PixelBox& a, const PixelBox& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

}  // namespace

FreeCorners::FreeCorners(const std::vector<Vector3>& vertices,
                         const std::vector<std::array<std::uint32_t, 3>>& triangles, const Camera& camera,
                         const PixelBox& picture)
    : places_(vertices.size()), triangles_(&triangles), picture_(picture) {
  parallel_for(vertices.size(), [&](std::size_t i) {
    const Vector3 seen = camera.project(vertices[i]);
    places_[i] = {seen[0], seen[1]};
  });
}

std::optional<PixelBox> FreeCorners::take(double width, double height) {
  const double left = picture_.left, right = picture_.right, top = picture_.top, bottom = picture_.bottom;
  for (const PixelBox& box :
       {PixelBox{right - width, top, right, top + height}, PixelBox{left, top, left + width, top + height},
        PixelBox{right - width, bottom - height, right, bottom},
        PixelBox{left, bottom - height, left + width, bottom}}) {
    if (box.left < left || box.bottom > bottom || box.top < top || !is_free(box)) continue;
    taken_.push_back(box);
    return box;
  }
  return std::nullopt;
}

bool FreeCorners::is_free(const PixelBox& box) const {
  if (std::ranges::any_of(taken_, [&](const PixelBox& other) { return overlap(box, other); })) return false;
  std::atomic<bool> free = true;
  parallel_for(triangles_->size(), [&](std::size_t t) {
    if (!free) return;
    const auto& [a, b, c] = (*triangles_)[t];
    if (!are_apart({places_[a], places_[b], places_[c]}, box)) free = false;
  });
  return free;
}

}  // namespace crossgrain
