// SPDX-License-Identifier: Apache-2.0
// Numbers as colours, and the marks of a scale.
#pragma once

#include <string>
#include <vector>

#include "picture/colour.hpp"

namespace crossgrain {

/// Colours at equal distances, mixed between.
class ColourMap {
 public:
  explicit ColourMap(std::vector<Colour> colours) : colours_(std::move(colours)) {}

  /// From light grey over yellow to dark red: what is small is not conspicuous.
  static ColourMap heat();

  /// From light yellow over red to black: matplotlib's magma (CC0) the other way round.
  static ColourMap dusk();

  /// The same from black to light yellow.
  static ColourMap dawn();

  /// `share` 0 to 1, clamped.
  Colour at(double share) const;

 private:
  std::vector<Colour> colours_;
};

/// Where a number is between the ends of a scale.
struct ColourScale {
  double low = 0, high = 1;
  bool is_logarithmic = false;  ///< both ends are positive then

  /// Below 0 and above 1 for numbers beyond the ends; not finite where there is no logarithm.
  double share_of(double value) const;

  struct Mark {
    double share;
    std::string text;
  };

  /// Round numbers within the scale, five or so; powers of ten where it is logarithmic.
  std::vector<Mark> marks() const;
};

/// The least round number (1, 2, 2.5 or 5 times a power of ten) that is not below a positive one.
double round_up(double value);

/// A number as a person writes it: no more digits than it has.
std::string number_text(double value);

}  // namespace crossgrain
