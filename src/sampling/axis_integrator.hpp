// SPDX-License-Identifier: Apache-2.0
// Lines along an axis of an interpolated field.
#pragma once

#include <vector>

#include "crossgrain/monitor.hpp"
#include "crossgrain/streamlines.hpp"
#include "sampling/arc_tubes.hpp"
#include "sampling/leaf_turn.hpp"
#include "sampling/model_boundary.hpp"
#include "sampling/sampling.hpp"

namespace crossgrain {

/// The current end of a line.
struct LineFront {
  Vector3 point;  ///< model units
  Vector3 direction;
  CellIndex leaf;  ///< leaf that holds the point
};

/// The part of a line in one direction from its seed, which is its first point.
struct HalfLine {
  std::vector<Vector3> points;
  std::vector<Vector3> tangents;
  double length = 0;
  StreamlineEnd end = StreamlineEnd::kBoundary;
};

/// The field in which lines are traced.
struct LineField {
  const LeafField& leaves;
  const Sampler& sampler;
  const ArcTubes& tubes;
  const ModelBoundary* boundary;              ///< null if lines end with the leaves
  std::span<const std::uint8_t> on_boundary;  ///< as in FieldData
  double longest_side;                        ///< model units
};

/// Follows one axis of the frames from step to step: of the six directions along the axes, the one nearest to
/// the previous direction, whatever the frames name their axes. Refers to the field given; safe from any
/// number of threads.
///
/// Steps are those of an embedded Runge-Kutta pair, as long as the difference of its two results allows. If a
/// face that is not open blocks the straight segment from the start of the step to a stage, the stage uses
/// the frame where that segment ends.
class AxisIntegrator {
 public:
  AxisIntegrator(const LineField& field, const StreamlineOptions& options)
      : field_(field), options_(options) {}

  /// The direction along an axis at the end of the straight segment to `point`, nearest to that of `from`.
  /// Sets `leaf` to the one in which the segment ends.
  Vector3 direction_at(const LineFront& from, const Vector3& point, CellIndex& leaf) const;

  /// Traces a line until it ends. Throws Error(kInterrupted).
  HalfLine follow(const LineFront& seed, const Monitor& monitor) const;

 private:
  struct Step;
  struct Stop;
  class Way;

  Step step(const LineFront& from, double length) const;
  Stop first_stop(const LineFront& from, const Step& step, double room) const;
  Vector3 in_units(const Vector3& point) const;

  LineField field_;
  StreamlineOptions options_;
};

}  // namespace crossgrain
