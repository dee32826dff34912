// SPDX-License-Identifier: Apache-2.0
// Lines along an axis of an interpolated field.
#pragma once

#include <vector>

#include "crossgrain/monitor.hpp"
#include "crossgrain/streamlines.hpp"
#include "sampling/line_space.hpp"
#include "sampling/streamline_tuning.hpp"

namespace crossgrain {

/// The current end of a line.
struct LineFront {
  LinePlace place;
  Vector3 direction;
};

/// The part of a line in one direction from its seed, which is its first point.
struct HalfLine {
  std::vector<Vector3> points;
  std::vector<Vector3> tangents;
  double length = 0;
  StreamlineEnd end = StreamlineEnd::kBoundary;
};

/// Follows one axis of the frames from step to step: of the six directions along the axes, the one nearest to
/// the previous direction, whatever the frames name their axes. Refers to the space given; safe from any
/// number of threads.
///
/// Steps are those of an embedded Runge-Kutta pair, as long as the difference of its two results allows. If a
/// face that is not open blocks the straight segment from the start of the step to a stage, the stage uses
/// the frame where that segment ends.
class AxisIntegrator {
 public:
  AxisIntegrator(const LineSpace& space, const StreamlineTuning& tuning);

  /// The direction along an axis at the end of the straight segment to `point`, nearest to that of `from`.
  /// Sets `cell` to the one in which the segment ends.
  Vector3 direction_at(const LineFront& from, const Vector3& point, LineCell& cell) const;

  /// Traces a line until it ends. Throws Error(kInterrupted).
  HalfLine follow(const LineFront& seed, const Monitor& monitor) const;

 private:
  struct Step;
  class Way;

  Step step(const LineFront& from, double length) const;

  const LineSpace& space_;
  StreamlineTuning tuning_;
  double longest_;  ///< model units
};

}  // namespace crossgrain
