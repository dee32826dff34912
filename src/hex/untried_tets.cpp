// SPDX-License-Identifier: Apache-2.0
#include "hex/untried_tets.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"

namespace crossgrain {
namespace {

/// Sizes make clearly other tets if these are so many times as many. A size between two such sizes then does
/// too, but for sizes that are as near each other.
constexpr double kClearlyMore = 1.3;
constexpr double kClearlyLarger = 1.3;

/// Details of a model may make all tets smaller than the size. A smaller size changes them where it is less
/// than the median of their edges; of tets that only the size limits, this is 1.08 of it.
constexpr double kBelowEdges = 0.75;

/// Finer tets are not suggested if they are expected to be more: the work grows with them.
constexpr double kMostTets = 50000;

double in_three_digits(double size) {
  const int decimals = 2 - static_cast<int>(std::floor(std::log10(size)));
  const double power = raised(10, std::abs(decimals));
  return decimals > 0 ? std::round(size * power) / power : std::round(size / power) * power;
}

/// Tets of one size each, the finest first.
std::vector<HexAttempt> made_tets(const std::vector<HexAttempt>& attempts) {
  std::vector<HexAttempt> made;
  for (const HexAttempt& attempt : attempts)
    if (attempt.tet_size > 0 && attempt.tets > 0) made.push_back(attempt);
  std::ranges::stable_sort(made, {}, &HexAttempt::tet_size);
  return made;
}

bool differ(const HexAttempt& fine, const HexAttempt& coarse) {
  return static_cast<double>(fine.tets) >= kClearlyMore * static_cast<double>(coarse.tets) &&
         coarse.tet_size >= kClearlyLarger * kClearlyLarger * fine.tet_size;
}

}  // namespace

std::optional<double> untried_tet_size(const std::vector<HexAttempt>& attempts) {
  const std::vector<HexAttempt> made = made_tets(attempts);
  for (std::size_t k = 1; k < made.size(); ++k)
    if (differ(made[k - 1], made[k]))
      return in_three_digits(std::sqrt(made[k - 1].tet_size * made[k].tet_size));
  if (made.empty() || made.front().tet_edge == 0) return std::nullopt;
  const HexAttempt& finest = made.front();
  const double size = kBelowEdges * std::min(finest.tet_edge, finest.tet_size);
  const double expected = static_cast<double>(finest.tets) * raised(finest.tet_edge / size, 3);
  if (expected > kMostTets) return std::nullopt;
  return in_three_digits(size);
}

}  // namespace crossgrain
