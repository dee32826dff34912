// SPDX-License-Identifier: Apache-2.0
// The legend of a picture: a column of blocks, each with a title and a colour bar or a list of signs.
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
  std::optional<double> largest =
      {};  ///< of the numbers, if above the scale; they have the colour of its end
};

struct Sign {
  enum class Shape { kLine, kThinLine, kDashes, kBall, kBox, kDisc, kDiamond, kCube, kNothing };
  Shape shape;
  Colour colour;
  std::string text;
};

struct LegendBlock {
  std::string title;
  std::string unit = {};  ///< shown in brackets after the title; may be empty
  std::optional<ColourBar> bar = {};
  std::vector<Sign> signs = {};
  std::vector<std::string> notes = {};  ///< sentences below the title, broken into lines
};

/// The legend in words: a line for each title and, indented, for each sign and the ends of each bar. UTF-8.
std::string text_of(const std::vector<LegendBlock>& blocks);

class Legend {
 public:
  /// A legend with letters of `size` pixels.
  Legend(std::vector<LegendBlock> blocks, double size);

  /// Size in pixels; 0 without blocks.
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
