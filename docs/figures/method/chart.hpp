// SPDX-License-Identifier: Apache-2.0
// Curves over an axis, drawn flat.
#pragma once

#include <string>
#include <vector>

#include "figure.hpp"

namespace crossgrain::figures {

/// From low to high; its marks are at whole multiples of `step` from low.
struct ChartAxis {
  double low, high, step;
  std::string unit = {};  ///< behind the number at each mark
};

class Chart {
 public:
  /// `box` is the area of the curves; numbers stand left of it and below.
  Chart(Figure& figure, const PixelBox& box, const ChartAxis& across, const ChartAxis& up)
      : figure_(figure), box_(box), across_(across), up_(up) {}

  /// Lines at the marks and their numbers.
  void draw_grid();

  struct Point {
    double x, y;
  };
  void curve(const std::vector<Point>& points, double width, const Colour& colour);

  /// Beside a point of the chart, `dx` and `dy` pixels off.
  void note(const std::string& text, const Point& at, double dx, double dy, Align align,
            const Colour& colour);

  double pixel_x(double x) const {
    return box_.left + box_.width() * (x - across_.low) / (across_.high - across_.low);
  }
  double pixel_y(double y) const {
    return box_.bottom - box_.height() * (y - up_.low) / (up_.high - up_.low);
  }

 private:
  Figure& figure_;
  PixelBox box_;
  ChartAxis across_, up_;
};

}  // namespace crossgrain::figures
