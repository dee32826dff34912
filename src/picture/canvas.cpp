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

template <class IsInside>
void Canvas::fill_inside(const PixelBox& box, const Colour& colour, const IsInside& is_inside) {
  constexpr int kSamples = 8;  // along each side of a pixel
  for (int y = static_cast<int>(std::floor(box.top)); y < box.bottom; ++y) {
    for (int x = static_cast<int>(std::floor(box.left)); x < box.right; ++x) {
      int inside = 0;
      for (int i = 0; i < kSamples * kSamples; ++i)
        inside += is_inside(x + (i % kSamples + 0.5) / kSamples, y + (i / kSamples + 0.5) / kSamples);
      put(x, y, colour, static_cast<float>(inside) / (kSamples * kSamples));
    }
  }
}

void Canvas::polygon(const std::vector<std::array<double, 2>>& corners, const Colour& colour) {
  PixelBox box{corners[0][0], corners[0][1], corners[0][0], corners[0][1]};
  for (const auto& [x, y] : corners) {
    box.left = std::min(box.left, x), box.right = std::max(box.right, x);
    box.top = std::min(box.top, y), box.bottom = std::max(box.bottom, y);
  }
  fill_inside(box, colour, [&](double x, double y) {
    bool all_left = true, all_right = true;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto &a = corners[k], &b = corners[(k + 1) % corners.size()];
      const double side = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
      all_left = all_left && side >= 0;
      all_right = all_right && side <= 0;
    }
    return all_left || all_right;
  });
}

void Canvas::ellipse(double x, double y, double radius_x, double radius_y, const Colour& colour) {
  fill_inside({x - radius_x, y - radius_y, x + radius_x, y + radius_y}, colour, [&](double px, double py) {
    const double across = (px - x) / radius_x, down = (py - y) / radius_y;
    return across * across + down * down <= 1;
  });
}

void Canvas::text(std::string_view text, double x, double y, double size, const Colour& colour) {
  Font::sans().draw(text, x, y, size, [&](int px, int py, float coverage) { put(px, py, colour, coverage); });
}

}  // namespace crossgrain
