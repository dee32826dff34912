// SPDX-License-Identifier: Apache-2.0
// How maps with flipped elements are measured, so that less of it unfolds them.
#pragma once

namespace crossgrain {

/// chi = (d + sqrt(d^2 + eps^2)) / 2 of a determinant d, positive for any, and its derivative by d.
///
/// Garanzha, Kaporin, Kudryavtseva, Protais, Ray, Sokolov 2021 ("Foldover-free maps in 50 lines of code").
struct Regularised {
  double chi, slope;
};
Regularised regularised(double determinant, double epsilon);

/// The epsilon of the first round, of a map with this least determinant. Larger ones, with integers free, let
/// maps collapse.
double first_epsilon(double least);

/// The epsilon of the next round (there, section 2.3), after a round that took the energy from `before` to
/// `after` and left `least` as the least determinant.
double next_epsilon(double least, double epsilon, double before, double after);

}  // namespace crossgrain
