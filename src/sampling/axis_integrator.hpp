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

/// Where a line has come to.
struct LineFront {
  Vector3 point;  ///< model units
  Vector3 direction;
  CellIndex leaf;  ///< that holds the point
};

/// A line one way from its seed, which is its first point.
struct HalfLine {
  std::vector<Vector3> points;
  std::vector<Vector3> tangents;
  double length = 0;
  StreamlineEnd end = StreamlineEnd::kBoundary;
};

/// What lines are traced through.
struct LineField {
  const LeafField& leaves;
  const Sampler& sampler;
  const ArcTubes& tubes;
  const ModelBoundary* boundary;              ///< null where lines end with the leaves
  std::span<const std::uint8_t> on_boundary;  ///< as in FieldData
  double longest_side;                        ///< model units
};

/// Follows one axis of the frames from step to step: of the six directions along the axes, that nearest to
/// the one before. Frames' names for their axes play no part. Refers to what it is given; safe from any
/// number of threads.
///
/// Steps are those of an embedded Runge-Kutta pair, as long as the difference of its two results allows. No
/// stage sees what its straight way from the step's beginning does not reach through open faces: there, the
/// frame where that way ends stands for those beyond.
class AxisIntegrator {
 public:
  AxisIntegrator(const LineField& field, const StreamlineOptions& options)
      : field_(field), options_(options) {}

  /// The direction along an axis at the end of the straight way to `point`, nearest to that of `from`.
  /// `leaf` becomes the one where the way ends.
  Vector3 direction_at(const LineFront& from, const Vector3& point, CellIndex& leaf) const;

  /// Traces until there is a reason to end. Throws Error(kInterrupted).
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
