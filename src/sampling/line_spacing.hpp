// SPDX-License-Identifier: Apache-2.0
// Keeps streamlines apart.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "crossgrain/streamlines.hpp"

namespace crossgrain {

/// The streamlines taken so far, by place. Lines along nearly the same direction are kept apart, whatever
/// their axes are named, in the manner of B. Jobard and W. Lefer (1997), "Creating evenly-spaced streamlines
/// of arbitrary density"; others may cross.
class LineSpacing {
 public:
  /// `spacing` is positive, model units.
  explicit LineSpacing(double spacing) : spacing_(spacing) {}

  /// Whether no line passes the point nearer than the spacing in nearly this direction, of either sign.
  bool has_room(const Vector3& point, const Vector3& direction) const;

  /// Ends a line where it comes nearer to another, or a line that is not closed to itself, than half the
  /// spacing, seen from its seed, and takes it. Returns whether there is room for it: at its seed, and for
  /// more than a stub between others.
  bool take(Streamline& line);

 private:
  struct Sample {
    Vector3 point, direction;
    std::size_t line;
    double along;  ///< distance from the seed, negative backwards
  };

  /// The end of a line in one direction: the last of its points, and where it is cut off beyond that.
  struct End {
    std::size_t point;
    std::optional<Sample> cut = {};
  };

  /// Whether a sample in nearly the direction of `of` is nearer than `distance`, other than those of its own
  /// line within a spacing along it.
  bool is_near(const Sample& of, double distance, bool is_closed = false) const;
  void remember(const Sample& sample);
  void forget_from(std::size_t first);
  End follow(const Streamline& line, int step);

  double spacing_;
  std::vector<Sample> samples_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> at_;  ///< samples in cubes of the spacing
  std::size_t lines_ = 0;
};

}  // namespace crossgrain
