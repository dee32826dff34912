// SPDX-License-Identifier: Apache-2.0
#include "picture/legend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "picture/font.hpp"

namespace crossgrain {
namespace {

// Lengths in heights of letters.
constexpr double kLine = 1.6, kBetweenBlocks = 1.3, kTitle = 1.75;
constexpr double kBarHeight = 11, kBarWidth = 1.1, kMark = 0.35, kBarText = 0.7;
constexpr double kSign = 1.9, kSignText = 0.6;
constexpr double kNoteWidth = 17, kNoteLine = 1.45;

// Shares of light on the faces of solid signs.
constexpr float kLit = 1.0f, kHalfLit = 0.8f, kUnlit = 0.62f;

void draw_double_pyramid(Canvas& canvas, double x, double y, double half_length, double half_width,
                         const Colour& colour) {
  const double inner = 0.35 * half_width;  // the edge between the two faces that are seen
  canvas.polygon({{x - half_length, y}, {x, y - half_width}, {x + half_length, y}, {x, y + half_width}},
                 kUnlit * colour);
  canvas.polygon({{x - half_length, y}, {x, y - half_width}, {x, y + inner}}, kLit * colour);
  canvas.polygon({{x + half_length, y}, {x, y - half_width}, {x, y + inner}}, kHalfLit * colour);
}

void draw_cube(Canvas& canvas, double x, double y, double half, const Colour& colour) {
  const double across = 0.87 * half;
  canvas.polygon({{x - across, y - 0.5 * half},
                  {x, y - half},
                  {x + across, y - 0.5 * half},
                  {x + across, y + 0.5 * half},
                  {x, y + half},
                  {x - across, y + 0.5 * half}},
                 kHalfLit * colour);
  canvas.polygon({{x - across, y - 0.5 * half}, {x, y - half}, {x + across, y - 0.5 * half}, {x, y}},
                 kLit * colour);
  canvas.polygon({{x + across, y - 0.5 * half}, {x + across, y + 0.5 * half}, {x, y + half}, {x, y}},
                 kUnlit * colour);
}

std::string heading(const LegendBlock& block) {
  return block.unit.empty() ? block.title : block.title + " [" + block.unit + "]";
}

std::string mark_text(const ColourBar& bar, const ColourScale::Mark& mark) {
  constexpr double kAtTheEnd = 1 - 1e-6;
  if (!bar.largest || mark.share <= kAtTheEnd) return mark.text;
  return fmt::format("≥ {}, up to {:.3g}", mark.text, *bar.largest);
}

/// A text in lines no wider than kNoteWidth, broken at spaces.
std::vector<std::string> lines_of(const std::string& text, double size) {
  std::vector<std::string> lines(1);
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || Font::sans().width(longer, size) <= kNoteWidth * size)
      lines.back() = longer;
    else
      lines.push_back(word);
  }
  return lines;
}

}  // namespace

std::string text_of(const std::vector<LegendBlock>& blocks) {
  std::string text;
  for (const LegendBlock& block : blocks) {
    text += heading(block) + "\n";
    for (const std::string& note : block.notes) text += "  " + note + "\n";
    if (block.bar) {
      const auto& scale = block.bar->scale;
      text += "  " + number_text(scale.low) + " to " + number_text(scale.high);
      text += block.bar->largest ? fmt::format(" and above, up to {:.3g}\n", *block.bar->largest) : "\n";
    }
    for (const Sign& sign : block.signs) text += "  " + sign.text + "\n";
  }
  return text;
}

Legend::Legend(std::vector<LegendBlock> blocks, double size) : blocks_(std::move(blocks)), size_(size) {
  for (LegendBlock& block : blocks_) {
    std::vector<std::string> lines;
    for (const std::string& note : block.notes)
      for (std::string& line : lines_of(note, size)) lines.push_back(std::move(line));
    block.notes = std::move(lines);
  }
}

double Legend::width() const {
  const Font& font = Font::sans();
  double width = 0;
  for (const LegendBlock& block : blocks_) {
    width = std::max(width, font.width(heading(block), size_));
    for (const std::string& note : block.notes) width = std::max(width, font.width(note, size_));
    if (block.bar) {
      for (const ColourScale::Mark& mark : block.bar->scale.marks())
        width =
            std::max(width, (kBarWidth + kBarText) * size_ + font.width(mark_text(*block.bar, mark), size_));
    }
    for (const Sign& sign : block.signs)
      width = std::max(width, (kSign + kSignText) * size_ + font.width(sign.text, size_));
  }
  return width;
}

double Legend::block_height(const LegendBlock& block) const {
  return size_ * (kTitle + kNoteLine * static_cast<double>(block.notes.size()) +
                  (block.bar ? kBarHeight : 0) + kLine * static_cast<double>(block.signs.size()));
}

double Legend::height() const {
  double height = 0;
  for (const LegendBlock& block : blocks_)
    height += block_height(block) + (&block == &blocks_.front() ? 0 : kBetweenBlocks * size_);
  return height;
}

void Legend::draw(Canvas& canvas, double left, double top, const Colour& ink) const {
  const double capital = Font::sans().capital_height(size_);
  for (const LegendBlock& block : blocks_) {
    canvas.text(heading(block), left, top + capital, size_, ink);
    double y = top + kTitle * size_;
    for (const std::string& note : block.notes) {
      canvas.text(note, left, y + capital, size_, ink);
      y += kNoteLine * size_;
    }
    if (block.bar) {
      draw_bar(canvas, *block.bar, left, y, ink);
      y += kBarHeight * size_;
    }
    for (const Sign& sign : block.signs) {
      draw_sign(canvas, sign, left, y + 0.5 * capital, ink);
      y += kLine * size_;
    }
    top += block_height(block) + kBetweenBlocks * size_;
  }
}

void Legend::draw_bar(Canvas& canvas, const ColourBar& bar, double left, double top,
                      const Colour& ink) const {
  const double height = (kBarHeight - 1) * size_, right = left + kBarWidth * size_;
  const double capital = Font::sans().capital_height(size_);
  // Each row reaches below the next, which covers it: else pixels between two rows would be half empty.
  for (double y = 0; y < height; ++y)
    canvas.fill({left, top + y, right, top + std::min(y + 2, height)}, bar.map.at(1 - (y + 0.5) / height));
  const double thin = size_ / 16;
  for (const double x : {left, right}) canvas.line(x, top, x, top + height, thin, ink);
  for (const double y : {top, top + height}) canvas.line(left, y, right, y, thin, ink);
  for (const ColourScale::Mark& mark : bar.scale.marks()) {
    const double y = top + (1 - mark.share) * height;
    canvas.line(right, y, right + kMark * size_, y, thin, ink);
    canvas.text(mark_text(bar, mark), right + kBarText * size_, y + 0.5 * capital, size_, ink);
  }
}

void Legend::draw_sign(Canvas& canvas, const Sign& sign, double left, double middle,
                       const Colour& ink) const {
  const double right = left + kSign * size_, centre = 0.5 * (left + right);
  switch (sign.shape) {
    case Sign::Shape::kLine:
      canvas.line(left + 0.2 * size_, middle, right - 0.2 * size_, middle, 0.36 * size_, sign.colour);
      break;
    case Sign::Shape::kThinLine:
      canvas.line(left + 0.2 * size_, middle, right - 0.2 * size_, middle, 0.15 * size_, sign.colour);
      break;
    case Sign::Shape::kDashes:
      for (double at = left + 0.2 * size_; at < right - 0.3 * size_; at += 0.55 * size_)
        canvas.line(at, middle, at + 0.3 * size_, middle, 0.12 * size_, sign.colour);
      break;
    case Sign::Shape::kBall:
      canvas.disc(centre, middle, 0.42 * size_, sign.colour);
      break;
    case Sign::Shape::kBox:
      canvas.fill({left + 0.35 * size_, middle - 0.45 * size_, right - 0.35 * size_, middle + 0.45 * size_},
                  sign.colour);
      break;
    case Sign::Shape::kDisc:
      canvas.ellipse(centre, middle, 0.55 * size_, 0.24 * size_, sign.colour);
      break;
    case Sign::Shape::kDiamond:
      draw_double_pyramid(canvas, centre, middle, 0.78 * size_, 0.42 * size_, sign.colour);
      break;
    case Sign::Shape::kCube:
      draw_cube(canvas, centre, middle, 0.5 * size_, sign.colour);
      break;
    case Sign::Shape::kNothing:
      break;
  }
  canvas.text(sign.text, right + kSignText * size_, middle + 0.5 * Font::sans().capital_height(size_), size_,
              ink);
}

}  // namespace crossgrain
