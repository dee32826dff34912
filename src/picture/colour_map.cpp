// SPDX-License-Identifier: Apache-2.0
#include "picture/colour_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace crossgrain {
namespace {

/// A power of ten, with its exponent as superscript digits.
std::string power_of_ten(int exponent) {
  static const char* const kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = "10";
  if (exponent < 0) text += "⁻";
  for (const char digit : fmt::format("{}", std::abs(exponent))) text += kDigits[digit - '0'];
  return text;
}

}  // namespace

ColourMap ColourMap::heat() {
  return ColourMap({colour_of(0xd3dae1), colour_of(0xf4dd9a), colour_of(0xf9b55f), colour_of(0xea6b3e),
                    colour_of(0xc02a32), colour_of(0x7a0a2a)});
}

ColourMap ColourMap::dusk() {
  return ColourMap({colour_of(0xfcfdbf), colour_of(0xfeca8d), colour_of(0xfd9668), colour_of(0xf1605d),
                    colour_of(0xcd4071), colour_of(0x9e2f7f), colour_of(0x721f81), colour_of(0x440f76),
                    colour_of(0x180f3d)});
}

ColourMap ColourMap::dawn() {
  ColourMap map = dusk();
  std::reverse(map.colours_.begin(), map.colours_.end());
  return map;
}

ColourMap ColourMap::shape() {
  return ColourMap({colour_of(0x7a0a2a), colour_of(0xc02a32), colour_of(0xea6b3e), colour_of(0xf9b55f),
                    colour_of(0xf1e3a4), colour_of(0xcddde7)});
}

Colour ColourMap::at(double share) const {
  const auto last = static_cast<double>(colours_.size() - 1);
  const double place = share > 0 ? std::min(share, 1.0) * last : 0;  // NaN counts as low
  const auto i = std::min(static_cast<std::size_t>(place), colours_.size() - 2);
  return mix(colours_[i], colours_[i + 1], static_cast<float>(place - static_cast<double>(i)));
}

double ColourScale::share_of(double value) const {
  return is_logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

std::vector<ColourScale::Mark> ColourScale::marks() const {
  std::vector<Mark> marks;
  constexpr double kSlack = 1e-9;
  if (is_logarithmic) {
    const int first = static_cast<int>(std::ceil(std::log10(low) - kSlack));
    const int last = static_cast<int>(std::floor(std::log10(high) + kSlack));
    const int step = std::max(1, (last - first + 4) / 5);
    for (int power = first; power <= last; power += step)
      marks.push_back({share_of(std::pow(10.0, power)), power_of_ten(power)});
    return marks;
  }
  const double step = round_up((high - low) / 5);
  for (double i = std::ceil(low / step - kSlack); i <= high / step + kSlack; ++i)
    marks.push_back({share_of(i * step), number_text(i == 0 ? 0 : i * step)});  // not "-0"
  return marks;
}

double round_up(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double round : {1.0, 2.0, 2.5, 5.0})
    if (round * power >= value * (1 - 1e-9)) return round * power;
  return 10 * power;
}

std::string number_text(double value) {
  std::string text = fmt::format("{:.6g}", value);
  if (text.starts_with('-')) text.replace(0, 1, "−");
  return text;
}

}  // namespace crossgrain
