// SPDX-License-Identifier: Apache-2.0
// Colour maps, and scales with their marks.
#pragma once

#include <string>
#include <vector>

#include "picture/colour.hpp"

namespace crossgrain {

/// A colour map: colours at equal distances, mixed in between.
class ColourMap {
 public:
  explicit ColourMap(std::vector<Colour> colours) : colours_(std::move(colours)) {}

  /// Light grey over yellow to dark red: small numbers are inconspicuous.
  static ColourMap heat();

  /// Light yellow over red to black: matplotlib's magma (CC0), reversed.
  static ColourMap dusk();

  /// Black over red to light yellow.
  static ColourMap dawn();

  /// Dark red over yellow to light blue-grey: of shapes, of which 0 is bad and 1 the best.
  static ColourMap shape();

  /// Colour at `share` of the map, clamped to 0 to 1.
  Colour at(double share) const;

 private:
  std::vector<Colour> colours_;
};

/// A linear or logarithmic scale.
struct ColourScale {
  double low = 0, high = 1;
  bool is_logarithmic = false;  ///< if set, both ends are positive

  /// Position of a number between the ends, 0 to 1; outside that for numbers beyond the ends, and not finite
  /// for a number without logarithm.
  double share_of(double value) const;

  struct Mark {
    double share;
    std::string text;
  };

  /// About five round numbers within the scale; powers of ten if it is logarithmic.
  std::vector<Mark> marks() const;
};

/// The smallest round number (1, 2, 2.5 or 5 times a power of ten) not below a positive number.
double round_up(double value);

/// A number as text, without superfluous digits.
std::string number_text(double value);

}  // namespace crossgrain
