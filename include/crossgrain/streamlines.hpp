// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "crossgrain/frame_field.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// How streamlines are traced. "Cells" is a length: the side of the cell that holds the point. The sweeps
/// that chose the defaults are in docs/notes/streamlines.md.
struct StreamlineOptions {
  /// Which axes of the frame at a seed are followed, each both ways. Of the 24 equivalent frames the one
  /// nearest to the coordinate axes counts: axis 0 is the one that goes with x, as far as one does.
  std::array<bool, 3> axes{true, true, true};

  /// The error that integrating the interpolated field may add, per length: a line of a hundred cells is off
  /// by at most a tenth of a cell, where its neighbours run parallel to it.
  double tolerance = 1e-3;

  /// Steps, and with them the distances of points. With one cell, cubics through points and tangents and the
  /// straight pieces drawn for them are a fortieth of a cell apart where frames turn by 0.2 rad a cell.
  double largest_step_cells = 1;

  /// Steps that would have to be smaller are taken with this length, whatever the error: the interpolated
  /// field bends sharply next to singular arcs only, over a part of a cell.
  double smallest_step_cells = 1.0 / 64;

  /// Lines end at this distance from singular edges of the grid. Nearer to them the interpolated frames are
  /// far from those of any smooth field, and the edges themselves stand for the arc to half a cell.
  double arc_distance_cells = 0.5;

  /// A line that comes back to its seed in the direction in which it set out is closed, where it passes by
  /// at this distance at most.
  double closing_cells = 0.05;

  /// How far from the curve the last straight piece may be where it meets the boundary or an arc. Ends are on
  /// that piece.
  double end_tolerance_cells = 1e-3;

  /// The most length of a line each way from its seed, in longest sides of the field's bounding box.
  double longest_sides = 4;

  /// The most points each way.
  std::size_t most_points = 100000;
};

/// Why a streamline goes no further.
enum class StreamlineEnd : std::uint8_t {
  kBoundary = 0,     ///< the surface, where that is known; otherwise the end of the active cells
  kSingularArc = 1,  ///< StreamlineOptions::arc_distance_cells from a singular edge
  kClosed = 2,       ///< back at its seed; so both ends are
  kLongest = 3,      ///< `longest_sides` or `most_points`
  kAmbiguous = 4     ///< no axis is within 45 degrees of its direction, even at the smallest step
};

/// A curve that is everywhere along an axis of the field, by points on it. Of which axis, it follows the
/// field from point to point: the one nearest to the direction in which it arrives.
struct Streamline {
  std::vector<Vector3> points;    ///< two at least; of closed lines the last is the first
  std::vector<Vector3> tangents;  ///< unit vectors, one a point, all from the first point towards the last
  double length = 0;              ///< of the straight pieces between the points
  std::size_t seed = 0;           ///< index of the seed
  int axis = 0;                   ///< of the seed's frame, 0 to 2 (StreamlineOptions::axes)
  std::size_t seed_point = 0;     ///< which of `points` the seed is
  StreamlineEnd first_end = StreamlineEnd::kBoundary;
  StreamlineEnd last_end = StreamlineEnd::kBoundary;
};

struct Streamlines {
  /// In the order of seeds and, for each, of axes. Where a seed gives none, or a line has no length, it is
  /// left out.
  std::vector<Streamline> lines;
  std::size_t outside_seeds = 0;  ///< outside the solid, or with coordinates that are not finite
  std::size_t arc_seeds = 0;      ///< at a singular arc, where no line begins
};

/// Traces streamlines of a field. Immutable and cheap to copy; all members are safe to call from any number
/// of threads.
class StreamlineTracer {
 public:
  /// Lines end exactly on `surface`, the model that the field was solved for; where it is null, with the
  /// active cells, which reach out of the solid by up to their size. It is not needed afterwards. Takes some
  /// 45 bytes a cell while it lives. Errors: kUsage for options out of range; kInput for a surface that
  /// bounds nothing or is not where the field is.
  explicit StreamlineTracer(const FrameField& field, const StreamlineOptions& options = {},
                            const TriangleMesh* surface = nullptr);

  /// `count` points evenly spread over the inside of the solid: in its bounding box, as shares of the sides,
  /// 1/2 + n (1/g, 1/g^2, 1/g^3) modulo 1 with g^4 = g + 1, n = 1, 2, ... (M. Roberts 2018, sequence R3),
  /// those outside and at singular arcs left out. So the first of many are the same as of few, and no two lie
  /// on one line along an axis. Fewer where the solid is much smaller than its cells. Errors: kInterrupted.
  std::vector<Vector3> spread_seeds(std::size_t count, const Monitor& monitor = {}) const;

  /// The lines through all seeds. Results do not depend on the number of threads. Errors: kInterrupted.
  Streamlines trace(std::span<const Vector3> seeds, const Monitor& monitor = {}) const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

}  // namespace crossgrain
