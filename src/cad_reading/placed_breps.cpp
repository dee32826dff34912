// SPDX-License-Identifier: Apache-2.0
// A shape is a line of eight numbers, its place and its bytes, and these bytes.
#include "cad_reading/placed_breps.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstddef>

namespace crossgrain {
namespace {

/// Reads a number and the character behind it.
template <class Number>
bool take_number(std::string_view& text, Number& number, char behind) {
  const auto [stop, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  if (code != std::errc() || !text.starts_with(behind)) return false;
  text.remove_prefix(1);
  return true;
}

}  // namespace

void append_brep(std::string& text, const PlacedBrep& shape) {
  // fmt writes the shortest text that restores the same double.
  for (const double number : shape.turn) text += fmt::format("{} ", number);
  for (const double number : shape.move) text += fmt::format("{} ", number);
  text += fmt::format("{}\n", shape.brep.size());
  text += shape.brep;
}

std::optional<std::vector<PlacedBrep>> placed_breps_in(std::string_view text) {
  std::vector<PlacedBrep> shapes;
  while (!text.empty()) {
    PlacedBrep& shape = shapes.emplace_back();
    for (double& number : shape.turn)
      if (!take_number(text, number, ' ')) return std::nullopt;
    for (double& number : shape.move)
      if (!take_number(text, number, ' ')) return std::nullopt;
    std::size_t bytes = 0;
    if (!take_number(text, bytes, '\n') || bytes > text.size()) return std::nullopt;
    shape.brep = text.substr(0, bytes);
    text.remove_prefix(bytes);
  }
  return shapes;
}

}  // namespace crossgrain
