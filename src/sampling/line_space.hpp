// SPDX-License-Identifier: Apache-2.0
// What the tracing of lines needs of a field, whether it is given on the cells of a grid or on tets.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/quaternion.hpp"
#include "crossgrain/streamlines.hpp"
#include "singularity/axis_names.hpp"

namespace crossgrain {

/// A leaf or a tet.
using LineCell = std::uint32_t;
inline constexpr LineCell kNoLineCell = ~LineCell{0};

/// A point in the solid and the cell that holds it.
struct LinePlace {
  Vector3 point;  ///< model units
  LineCell cell;
};

/// The first obstacle on a straight segment.
struct LineStop {
  double share = 1;  ///< share of the segment; 1 without an obstacle
  StreamlineEnd reason = StreamlineEnd::kBoundary;
  LineCell cell = kNoLineCell;  ///< cell in which the segment ends

  void at(double other_share, StreamlineEnd other_reason) {
    if (!(other_share < share)) return;
    share = other_share;
    reason = other_reason;
  }
};

/// The triangles that bound the solid, outward by the right-hand rule.
struct LineSurface {
  std::span<const Vector3> vertices;
  std::span<const std::array<std::uint32_t, 3>> triangles;
};

/// A solid with a continuous frame field in which lines are traced. Queries are safe from any number of
/// threads.
class LineSpace {
 public:
  virtual ~LineSpace() = default;

  /// The bounding box, and the volume, of the solid or of the cells that cover it.
  virtual Box bounds() const = 0;
  virtual double volume() const = 0;

  /// The box in which seeds are sought, and in whose longest sides lengths are given.
  virtual Box box_of_seeds() const { return bounds(); }

  /// Empty if no surface is known.
  virtual LineSurface surface() const = 0;

  /// The cell that holds a point of the solid; kNoLineCell for points outside, also those with coordinates
  /// that are not finite.
  virtual LineCell cell_at(const Vector3& point) const = 0;

  /// The unit of lengths given in cells.
  virtual double cell_size(LineCell cell) const = 0;

  /// Whether a place is so near to a singular edge that no line starts there.
  virtual bool is_at_arc(const LinePlace& place) const = 0;

  /// The frame at the end of the straight segment to `to`, or where the segment leaves the solid. Sets `end`
  /// to the cell there.
  virtual Quaternion frame_at(const LinePlace& from, const Vector3& to, LineCell& end) const = 0;

  /// The first place where the segment leaves the solid or comes near a singular edge.
  virtual LineStop first_stop(const LinePlace& from, const Vector3& to) const = 0;

  /// The names of the axes of a frame at a place, consistent over the field.
  virtual AxisNames names_at(const LinePlace& place, const Quaternion& frame) const = 0;
};

}  // namespace crossgrain
