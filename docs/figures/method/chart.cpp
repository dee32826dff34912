// SPDX-License-Identifier: Apache-2.0
#include "chart.hpp"

#include <fmt/format.h>

#include <cmath>

namespace crossgrain::figures {
namespace {

constexpr double kText = 22;

std::vector<double> marks_of(const ChartAxis& axis) {
  std::vector<double> marks;
  for (int i = 0; axis.low + i * axis.step <= axis.high + 1e-9; ++i)
    marks.push_back(axis.low + i * axis.step);
  return marks;
}

}  // namespace

void Chart::draw_grid() {
  for (const double y : marks_of(up_)) {
    figure_.canvas().line(box_.left, pixel_y(y), box_.right, pixel_y(y), 1.2, kRule);
    figure_.text(fmt::format("{:.3g}{}", y, up_.unit), box_.left - 12, pixel_y(y) + 8, kText, Align::kRight,
                 kFaint);
  }
  for (const double x : marks_of(across_)) {
    figure_.canvas().line(pixel_x(x), box_.top, pixel_x(x), box_.bottom, 1.2, kRule);
    figure_.text(fmt::format("{:.3g}{}", x, across_.unit), pixel_x(x), box_.bottom + 28, kText,
                 Align::kCentre, kFaint);
  }
}

void Chart::curve(const std::vector<Point>& points, double width, const Colour& colour) {
  // Joints are drawn twice: pieces much longer than they are wide hide that.
  const double least = 2.5 * width;
  double from_x = pixel_x(points.front().x), from_y = pixel_y(points.front().y);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double x = pixel_x(points[i].x), y = pixel_y(points[i].y);
    if (i + 1 < points.size() && std::hypot(x - from_x, y - from_y) < least) continue;
    figure_.canvas().line(from_x, from_y, x, y, width, colour);
    from_x = x;
    from_y = y;
  }
}

void Chart::note(const std::string& text, const Point& at, double dx, double dy, Align align,
                 const Colour& colour) {
  figure_.text(text, pixel_x(at.x) + dx, pixel_y(at.y) + dy, kText, align, colour);
}

}  // namespace crossgrain::figures
