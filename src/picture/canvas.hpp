// SPDX-License-Identifier: Apache-2.0
// Flat shapes and text with smooth edges on an image: legends and scales. Positions are in pixels from the
// upper left corner; anything outside the image is clipped.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "picture/camera.hpp"
#include "picture/image.hpp"

namespace crossgrain {

class Canvas {
 public:
  explicit Canvas(Image& image) : image_(image) {}

  void fill(const PixelBox& box, const Colour& colour, float opacity = 1);
  void line(double x0, double y0, double x1, double y1, double width, const Colour& colour);
  void disc(double x, double y, double radius, const Colour& colour);

  /// Fills a convex polygon with corners in either direction.
  void polygon(const std::vector<std::array<double, 2>>& corners, const Colour& colour);

  /// Fills an ellipse along the axes.
  void ellipse(double x, double y, double radius_x, double radius_y, const Colour& colour);

  /// Draws a text; `y` is the baseline.
  void text(std::string_view text, double x, double y, double size, const Colour& colour);

 private:
  /// Fills the pixels of a box by the share of their area for which is_inside(x, y).
  template <class IsInside>
  void fill_inside(const PixelBox& box, const Colour& colour, const IsInside& is_inside);

  void put(int x, int y, const Colour& colour, float coverage);

  Image& image_;
};

}  // namespace crossgrain
