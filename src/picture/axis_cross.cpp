// SPDX-License-Identifier: Apache-2.0
#include "picture/axis_cross.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "display/axis_colours.hpp"
#include "picture/font.hpp"

namespace crossgrain {
namespace {

constexpr std::array<const char*, 3> kNames{"x", "y", "z"};

}  // namespace

void draw_axis_cross(Canvas& canvas, const ViewAxes& axes, double x, double y, double reach,
                     const Colour& ink) {
  // Axes that point away from the viewer are behind the others.
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return axes.towards[a] < axes.towards[b]; });
  const double size = 0.42 * reach;
  const Font& font = Font::sans();
  for (const std::size_t k : order) {
    const double right = axes.right[k] * reach, up = axes.up[k] * reach, length = std::hypot(right, up);
    canvas.line(x, y, x + right, y - up, 0.075 * reach, colour_of(kAxisColours[k]));
    constexpr double kSeenFromItsEnd = 0.1;
    if (length < kSeenFromItsEnd * reach) continue;
    const double text_x = x + right + 0.28 * reach * right / length,
                 text_y = y - up - 0.28 * reach * up / length;
    canvas.text(kNames[k], text_x - 0.5 * font.width(kNames[k], size),
                text_y + 0.36 * font.capital_height(size), size, ink);
  }
}

}  // namespace crossgrain
