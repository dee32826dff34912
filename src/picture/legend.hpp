// SPDX-License-Identifier: Apache-2.0
// What the colours of a picture mean: a column of blocks, each with a title, a colour bar or a list of signs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "picture/canvas.hpp"
#include "picture/colour_map.hpp"

namespace crossgrain {

struct ColourBar {
  ColourMap map;
  ColourScale scale;
  bool goes_on = false;  ///< numbers above the scale have the colour of its end
};

struct Sign {
  enum class Shape { kLine, kBall, kBox };
  Shape shape;
  Colour colour;
  std::string text;
};

struct LegendBlock {
  std::string title;
  std::string unit = {};  ///< in brackets behind the title; may be empty
  std::optional<ColourBar> bar = {};
  std::vector<Sign> signs = {};
};

class Legend {
 public:
  /// `size` of the letters, in pixels.
  Legend(std::vector<LegendBlock> blocks, double size) : blocks_(std::move(blocks)), size_(size) {}

  /// In pixels; 0 without blocks.
  double width() const;
  double height() const;

  void draw(Canvas& canvas, double left, double top, const Colour& ink) const;

 private:
  double block_height(const LegendBlock& block) const;
  void draw_bar(Canvas& canvas, const ColourBar& bar, double left, double top, const Colour& ink) const;
  void draw_sign(Canvas& canvas, const Sign& sign, double left, double middle, const Colour& ink) const;

  std::vector<LegendBlock> blocks_;
  double size_;
};

}  // namespace crossgrain
