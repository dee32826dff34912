// SPDX-License-Identifier: Apache-2.0
#include "picture_arguments.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "argument_values.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain::app {
namespace {

template <class T>
std::optional<T> parse_number(std::string_view text) {
  T value{};
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Parses two numbers separated by `between`.
template <class T>
std::optional<std::array<T, 2>> parse_pair(const std::string& text, char between) {
  const std::size_t at = text.find(between);
  if (at == text.npos) return std::nullopt;
  const auto first = parse_number<T>(std::string_view(text).substr(0, at));
  const auto second = parse_number<T>(std::string_view(text).substr(at + 1));
  if (!first || !second) return std::nullopt;
  return std::array{*first, *second};
}

}  // namespace

std::optional<std::array<int, 2>> parse_size(const std::string& text) {
  return parse_pair<int>(text, 'x');
}

std::optional<PictureOptions::View> parse_view(const std::string& text) {
  if (const auto angles = parse_pair<double>(text, ',')) {
    const bool is_view = std::isfinite((*angles)[0]) && std::abs((*angles)[1]) <= 90;
    if (!is_view) return std::nullopt;
    return PictureOptions::View{(*angles)[0], (*angles)[1]};
  }
  try {
    return view_named(text);
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::optional<PictureOptions::Cut> parse_cut(const std::string& text) {
  const std::size_t axis = std::string_view("xyz").find(text.substr(0, 1));
  if (text.empty() || axis == std::string_view::npos) return std::nullopt;
  PictureOptions::Cut cut{static_cast<int>(axis), std::nullopt};
  if (text.size() > 1) {
    cut.position = parse_number<double>(std::string_view(text).substr(std::min<std::size_t>(2, text.size())));
    if (text[1] != '=' || !cut.position || !std::isfinite(*cut.position)) return std::nullopt;
  }
  return cut;
}

std::optional<std::vector<PicturePart>> parse_parts(const std::string& text) {
  constexpr std::array<std::string_view, 3> kNames{"lines", "creases", "legend"};
  std::vector<PicturePart> parts;
  for (const std::string& name : parts_of(text)) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    parts.push_back(static_cast<PicturePart>(found - kNames.begin()));
  }
  return parts;
}

std::optional<std::array<double, 2>> parse_range(const std::string& text) {
  const auto range = parse_pair<double>(text, ',');
  const bool is_range =
      range && std::isfinite((*range)[0]) && std::isfinite((*range)[1]) && (*range)[0] < (*range)[1];
  return is_range ? range : std::nullopt;
}

}  // namespace crossgrain::app
