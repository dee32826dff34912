// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/ignoring_case.hpp"

namespace crossgrain {

/// Returns the common spelling of a unit that a file names in words; unknown names in lower case.
inline std::string short_unit(std::string name) {
  constexpr std::array<std::pair<const char*, const char*>, 7> kShort = {{{"millimetre", "mm"},
                                                                          {"centimetre", "cm"},
                                                                          {"metre", "m"},
                                                                          {"micrometre", "um"},
                                                                          {"kilometre", "km"},
                                                                          {"in", "inch"},
                                                                          {"ft", "foot"}}};
  std::ranges::transform(name, name.begin(), lower);
  for (const auto& [from, to] : kShort) {
    if (name == from) return to;
  }
  return name;
}

}  // namespace crossgrain
