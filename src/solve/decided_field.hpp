// SPDX-License-Identifier: Apache-2.0
// The field with which a solve begins, the same at any resolution and in any position of the model.
#pragma once

#include <cstddef>
#include <memory>

#include "base/quaternion.hpp"
#include "crossgrain/report.hpp"
#include "field/nested_solve.hpp"
#include "field/solve_tuning.hpp"
#include "sampling/sampling.hpp"

namespace crossgrain {

/// Returns the rotation that brings a surface into axes of its own: those to which most of it is normal or
/// tangent, the axes of space if they are such, ordered by the extent along them, longest first, each towards
/// its heavier end. Turned copies of a surface are the same afterwards, but for its symmetries.
Quaternion turn_to_own_axes(const Surface& surface);

/// Returns the size of the cells of a uniform grid of about `cells` cells, model units.
double cell_size_for(const Surface& surface, bool closed, std::size_t cells);

/// A field on one uniform, relaxed grid.
class DecidedField {
 public:
  /// Solves on SolverTuning::decision_cells cells. `monitor` hears of levels without numbers; a stop
  /// ends the solve. Null if the options want no such field, or if these cells or the memory do not
  /// suffice for one. Throws Error(kInterrupted).
  static std::unique_ptr<const DecidedField> solved(const Solid& solid, const SolveTuning& options,
                                                    const Monitor& monitor);

  DecidedField(const DecidedField&) = delete;
  DecidedField& operator=(const DecidedField&) = delete;

  Quaternion frame_at(const Vector3& point) const;

  /// What a solve of the same model begins with. Refers to this object.
  InitialField initial_field() const;

  const SolvedField& field() const { return field_; }
  double seconds() const { return seconds_; }  ///< that it took
  SolveReport::Decision description() const;

 private:
  DecidedField(const Quaternion& turn, SolvedField field, double seconds);

  Quaternion turn_;  ///< of the model to the grid
  SolvedField field_;
  double seconds_;
  Sampler sampler_;  ///< of field_
};

}  // namespace crossgrain
