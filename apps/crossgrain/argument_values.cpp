// SPDX-License-Identifier: Apache-2.0
#include "argument_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <system_error>

#include "crossgrain/result_folder.hpp"

namespace crossgrain::app {
namespace {

/// Parses a whole text as a number, like CLI11 does for options without a check of their own.
bool parse_number(const std::string& text, double& number) {
  char* end = nullptr;
  number = static_cast<double>(std::strtold(text.c_str(), &end));
  return !text.empty() && end == text.c_str() + text.size();
}

/// Returns the names of formats that may be chosen, separated by commas.
std::string names_of_formats(bool has_map) {
  std::string names;
  for (const OutputFormat& format : output_formats())
    if (is_choice(format, has_map)) names += (names.empty() ? "" : ", ") + format.name;
  return names;
}

}  // namespace

std::optional<std::uint64_t> parse_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data(), end, seed);
  if (code != std::errc() || stop != end) return std::nullopt;
  return seed;
}

std::string fault_of(const std::string& what, const std::string& text) {
  double number = 0;
  const bool is_number = parse_number(text, number) && text.find_first_not_of(" \t") == 0;
  return "takes " + what + ", not " + (is_number ? text : "'" + text + "'");
}

std::string fault_of_number(const std::string& text, const NumberRange& range) {
  double value = 0;
  const bool is_number = parse_number(text, value);
  const bool is_whole = is_number && value == std::floor(value);
  const bool has_digits_only = text.find_first_not_of("+-0123456789") == std::string::npos;
  const bool is_of_kind = !range.is_whole || (is_whole && has_digits_only);
  if (is_number && value >= range.low && value <= range.high && is_of_kind) return "";
  if (is_whole && range.is_open && value > range.high)
    return fault_of(fmt::format("at most {:.12g}", range.high), text);
  const char* const kind = is_of_kind ? "" : "a whole number, ";
  return fault_of(range.is_open ? fmt::format("{}{:.12g} or more", kind, range.low)
                                : fmt::format("{}{:.12g} to {:.12g}", kind, range.low, range.high),
                  text);
}

std::string fault_of_choice(const std::string& text, const std::vector<std::string>& choices) {
  if (std::ranges::find(choices, text) != choices.end()) return "";
  std::string words;
  for (std::size_t k = 0; k < choices.size(); ++k)
    words += (k == 0 ? "" : k + 1 < choices.size() ? ", " : " or ") + choices[k];
  return fault_of(words, text);
}

std::string fault_of_length(const std::string& text) {
  double value = 0;
  const bool is_number = parse_number(text, value);
  return is_number && value > 0 && std::isfinite(value) ? "" : fault_of("a number above 0", text);
}

std::string fault_of_angle(const std::string& text) {
  double value = 0;
  const bool is_number = parse_number(text, value);
  return is_number && value > 0 && value <= 180 ? "" : fault_of("an angle above 0, up to 180", text);
}

std::string fault_of_axes(const std::string& text) {
  bool is_fine = !text.empty();
  for (std::size_t i = 0; i < text.size(); ++i)
    is_fine = is_fine && std::string_view("xyz").find(text[i]) != text.npos && text.find(text[i]) == i;
  return is_fine ? "" : fault_of("axes, such as xyz, xy or z", text);
}

std::optional<Box> parse_box(const std::string& text) {
  std::array<double, 6> bounds;
  std::istringstream parts(text);
  std::string part;
  std::size_t count = 0;
  while (std::getline(parts, part, ',')) {
    if (count == bounds.size() || !parse_number(part, bounds[count])) return std::nullopt;
    if (std::isnan(bounds[count++])) return std::nullopt;
  }
  if (count != bounds.size() || text.back() == ',') return std::nullopt;
  const auto [x_low, y_low, z_low, x_high, y_high, z_high] = bounds;
  return Box{{x_low, y_low, z_low}, {x_high, y_high, z_high}};
}

std::string fault_of_box(const std::string& text) {
  const std::optional<Box> box = parse_box(text);
  if (!box) return fault_of("six numbers separated by commas", text);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (box->low[axis] > box->high[axis])
      return fault_of(fmt::format("the lower bound of {} before the upper one", "xyz"[axis]), text);
  }
  return "";
}

std::optional<std::vector<Vector3>> parse_points(const std::vector<std::string>& texts) {
  if (texts.size() % 3 != 0) return std::nullopt;
  std::vector<Vector3> points(texts.size() / 3);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    double& coordinate = points[i / 3][i % 3];
    if (!parse_number(texts[i], coordinate) || !std::isfinite(coordinate)) return std::nullopt;
  }
  return points;
}

std::optional<LengthUnit> parse_unit(const std::string& text) {
  for (int number = 1;; ++number) {
    const auto unit = static_cast<LengthUnit>(number);
    const std::string name = name_of(unit);
    if (name.empty()) return std::nullopt;
    if (name == text) return unit;
  }
}

std::optional<std::size_t> parse_bytes(const std::string& text) {
  const std::size_t end = std::min(text.find_first_not_of("0123456789."), text.size());
  double number = 0;
  if (end == 0 || !parse_number(text.substr(0, end), number)) return std::nullopt;
  const std::string unit = text.substr(end);
  constexpr std::string_view kPrefixes = "KMGT";
  int power = 0;
  double base = 1000;
  if (!unit.empty() && unit != "B") {
    const std::size_t prefix = kPrefixes.find(unit[0]);
    const std::string rest = unit.substr(1);
    if (prefix == kPrefixes.npos || (rest != "" && rest != "B" && rest != "iB")) return std::nullopt;
    power = static_cast<int>(prefix) + 1;
    if (rest == "iB") base = 1024;
  }
  const double bytes = number * std::pow(base, power);
  if (!(bytes >= 1 && bytes < std::ldexp(1.0, 63))) return std::nullopt;
  return static_cast<std::size_t>(bytes);
}

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

bool is_choice(const OutputFormat& format, bool has_map) {
  return !format.is_always_written && (has_map || !format.is_of_map);
}

std::string fault_of_formats(const std::string& text, bool has_map) {
  const std::vector<OutputFormat> formats = output_formats();
  for (const std::string& name : parts_of(text)) {
    const auto is_named = [&](const OutputFormat& format) {
      return format.name == name && (has_map || !format.is_of_map);
    };
    if (std::none_of(formats.begin(), formats.end(), is_named))
      return fault_of(names_of_formats(has_map) + ", or several separated by commas", name);
  }
  return "";
}

}  // namespace crossgrain::app
