// SPDX-License-Identifier: Apache-2.0
// Enumerations whose values have names for files and scripts: `name_of` gives the name of a value and "" for
// a number that is no value; `value_named` finds the value of a name.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace crossgrain {

/// The body of a `name_of`: `names` lists one name for each value from 0 up to `last`.
template <auto last, std::size_t N>
const char* name_among(const std::array<const char*, N>& names, decltype(last) value) {
  static_assert(N == static_cast<std::size_t>(last) + 1, "one name for each value");
  const auto index = static_cast<std::size_t>(value);
  return index < N ? names[index] : "";
}

/// Returns the value with this name; none if `name_of` gives it to no value.
template <class Enum>
std::optional<Enum> value_named(std::string_view name) {
  for (int number = 0;; ++number) {
    const auto value = static_cast<Enum>(number);
    const std::string_view its_name = name_of(value);
    if (its_name.empty()) return std::nullopt;
    if (its_name == name) return value;
  }
}

}  // namespace crossgrain
