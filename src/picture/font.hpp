// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string_view>

namespace crossgrain {

/// DejaVu Sans, which is built into the program. Sizes are those of an em in pixels; text is UTF-8.
class Font {
 public:
  /// The only font.
  static const Font& sans();

  /// Width of a text, in pixels.
  double width(std::string_view text, double size) const;

  /// Height of capitals, in pixels.
  double capital_height(double size) const;

  /// Calls put(x, y, coverage) for every pixel that a text covers in part, 0 to 1. The first letter begins at
  /// (left, baseline), in pixels from the upper left corner.
  void draw(std::string_view text, double left, double baseline, double size,
            const std::function<void(int x, int y, float coverage)>& put) const;

 private:
  struct Info;
  Font();
  const Info* info_;
};

}  // namespace crossgrain
