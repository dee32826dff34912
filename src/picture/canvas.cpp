// SPDX-License-Identifier: Apache-2.0
#include "picture/canvas.hpp"

#include <algorithm>
#include <cmath>

#include "picture/font.hpp"

namespace crossgrain {

void Canvas::put(int x, int y, const Colour& colour, float coverage) {
  if (x < 0 || y < 0 || x >= image_.width() || y >= image_.height() || !(coverage > 0)) return;
  image_.at(x, y) = over(pixel_of(colour, std::min(coverage, 1.0f)), image_.at(x, y));
}

void Canvas::fill(const PixelBox& box, const Colour& colour, float opacity) {
  const auto share = [](double low, double high, int cell) {
    return std::clamp(std::min(high, cell + 1.0) - std::max<double>(low, cell), 0.0, 1.0);
  };
  for (int y = static_cast<int>(std::floor(box.top)); y < std::ceil(box.bottom); ++y) {
    for (int x = static_cast<int>(std::floor(box.left)); x < std::ceil(box.right); ++x) {
      const double covered = share(box.left, box.right, x) * share(box.top, box.bottom, y);
      put(x, y, colour, opacity * static_cast<float>(covered));
    }
  }
}

void Canvas::line(double x0, double y0, double x1, double y1, double width, const Colour& colour) {
  const double reach = 0.5 * width + 1, dx = x1 - x0, dy = y1 - y0, length2 = dx * dx + dy * dy;
  const auto first_x = static_cast<int>(std::floor(std::min(x0, x1) - reach));
  const auto first_y = static_cast<int>(std::floor(std::min(y0, y1) - reach));
  for (int y = first_y; y < std::max(y0, y1) + reach; ++y) {
    for (int x = first_x; x < std::max(x0, x1) + reach; ++x) {
      const double px = x + 0.5 - x0, py = y + 0.5 - y0;
      const double along = length2 > 0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0;
      const double distance = std::hypot(px - along * dx, py - along * dy);
      put(x, y, colour, static_cast<float>(std::clamp(0.5 * width + 0.5 - distance, 0.0, 1.0)));
    }
  }
}

void Canvas::disc(double x, double y, double radius, const Colour& colour) {
  line(x, y, x, y, 2 * radius, colour);
}

void Canvas::text(std::string_view text, double x, double y, double size, const Colour& colour) {
  Font::sans().draw(text, x, y, size, [&](int px, int py, float coverage) { put(px, py, colour, coverage); });
}

}  // namespace crossgrain
