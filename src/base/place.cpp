// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace crossgrain {
namespace {

/// Decimals of the power of ten below a size: a place is known to a ten-thousandth of the model at worst.
constexpr int kDecimals = 4;

/// Coordinates below this are rounding where no size is known: models are larger than 1e-9.
constexpr double kLeastSize = 1e-9;

}  // namespace

std::string words_of_place(const Vector3& place, double size) {
  if (!(size > 0)) size = std::max({std::abs(place[0]), std::abs(place[1]), std::abs(place[2]), kLeastSize});
  const int decimals = kDecimals - static_cast<int>(std::floor(std::log10(size)));
  const double power = std::pow(10.0, std::abs(decimals));
  const auto rounded = [&](double x) {
    // Dividing by a power of ten gives the double nearest to the decimal number, multiplying does not. Adding
    // 0 turns -0 into 0.
    return (decimals > 0 ? std::round(x * power) / power : std::round(x / power) * power) + 0.0;
  };
  return fmt::format("{:.15g} {:.15g} {:.15g}", rounded(place[0]), rounded(place[1]), rounded(place[2]));
}

}  // namespace crossgrain
