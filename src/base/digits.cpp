// SPDX-License-Identifier: Apache-2.0
#include "base/digits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace crossgrain {
namespace {

/// Returns a whole number of tenths to the power of `decimals`. Dividing by a power of ten gives the double
/// nearest to the decimal number, multiplying by its inverse does not.
double scaled(double whole, int decimals) {
  const double power = std::pow(10.0, std::abs(decimals));
  return decimals > 0 ? whole / power : whole * power;
}

int decimals_of(double value, int digits) {
  return digits - 1 - static_cast<int>(std::floor(std::log10(value)));
}

}  // namespace

double rounded_down(double limit, int digits) {
  const int decimals = decimals_of(limit, digits);
  const double nearest = std::round(scaled(limit, -decimals));
  const double value = scaled(nearest, decimals);
  return value <= limit ? value : scaled(nearest - 1, decimals);
}

std::string about(double count) {
  constexpr double kMillion = 1e6, kBillion = 1e9;
  count = std::max(1.0, count);
  const double rounded = scaled(std::round(scaled(count, -decimals_of(count, 2))), decimals_of(count, 2));
  if (rounded >= kBillion) return fmt::format("about {:.2g} billion", rounded / kBillion);
  return rounded < kMillion ? fmt::format("about {:.0f}", rounded)
                            : fmt::format("about {:.3g} million", rounded / kMillion);
}

}  // namespace crossgrain
