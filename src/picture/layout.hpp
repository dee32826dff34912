// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "picture/camera.hpp"

namespace crossgrain {

/// The corners of a picture that a drawing leaves free.
class FreeCorners {
 public:
  /// Takes the drawn `triangles` of `vertices`, as seen by `camera`.
  FreeCorners(const std::vector<Vector3>& vertices,
              const std::vector<std::array<std::uint32_t, 3>>& triangles, const Camera& camera,
              const PixelBox& picture);

  /// Takes the first corner (upper right, upper left, lower right, lower left) in which a box of that size
  /// meets no triangle and no earlier box, and returns the box.
  std::optional<PixelBox> take(double width, double height);

  /// Excludes a box that is used otherwise.
  void keep_free_of(const PixelBox& box) { taken_.push_back(box); }

 private:
  bool is_free(const PixelBox& box) const;

  using Place = std::array<double, 2>;
  std::vector<Place> places_;  ///< pixel positions of the vertices
  const std::vector<std::array<std::uint32_t, 3>>* triangles_;
  PixelBox picture_;
  std::vector<PixelBox> taken_;
};

}  // namespace crossgrain
