// SPDX-License-Identifier: Apache-2.0
#include "map/foldover.hpp"

#include <algorithm>
#include <cmath>

namespace crossgrain {

Regularised regularised(double determinant, double epsilon) {
  const double root = std::sqrt(determinant * determinant + epsilon * epsilon);
  // Without cancellation for negative determinants.
  const double chi =
      determinant > 0 ? 0.5 * (determinant + root) : 0.5 * epsilon * epsilon / (root - determinant);
  constexpr double kLeast = 1e-100;
  return {std::max(chi, kLeast), std::max(chi, kLeast) / root};
}

double first_epsilon(double least) {
  constexpr double kLargest = 0.1, kShare = 0.2, kLeast = 1e-6, kWithoutFlips = 0.01;
  return std::min(kLargest, least < 0 ? std::max(kLeast, kShare * -least) : kWithoutFlips);
}

double next_epsilon(double least, double epsilon, double before, double after) {
  constexpr double kLeastDecrease = 0.1, kLeastEpsilon = 1e-10;
  const double share = std::max(1 - after / before, kLeastDecrease);
  const double bound = (1 - share) * regularised(least, epsilon).chi;
  return least < bound ? std::max(kLeastEpsilon, 2 * std::sqrt(bound * (bound - least))) : kLeastEpsilon;
}

}  // namespace crossgrain
