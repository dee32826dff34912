// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "crossgrain/report.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup fields Fields
/// @{

struct FieldData;

/// A solved frame field: one octahedral frame per active cell of an octree, and a frame for any point by
/// interpolation. Immutable and cheap to copy; all members are safe to call from any number of threads.
class FrameField {
 public:
  /// One cell. Any of the 24 equivalent frames may represent it; neighbouring cells may differ in that
  /// choice.
  struct Cell {
    Vector3 center;    ///< model units
    double size;       ///< side, model units
    int depth;         ///< depth in the octree; the root cube has 0
    bool on_boundary;  ///< whether the cell holds surface
    Frame frame;
  };

  struct Sample {
    Frame frame;
    bool in_active_cell;  ///< false: the frame is that of the nearest active cell

    /// Disagreement of the surrounding cells: E_sym of the blended degree-4 coefficients, scaled to unit
    /// length. 0 where the frames agree, up to 200/3 on a singular line; 0 outside active cells.
    double deviation;

    /// Distance to the nearest arc, model units, inside and outside; infinity if there are none. Arcs beside
    /// creases count, which singularities() leaves out.
    double singular_distance;
  };

  explicit FrameField(std::shared_ptr<const FieldData> data);

  /// Number of active cells. Of a field that several processes have solved together
  /// (crossgrain/processes.hpp), this and all properties of cells are of the part of this process, the report
  /// and the singular graph are in process 0, and sampling throws Error(kUsage).
  std::size_t size() const;

  /// Cell `index`. Errors: kUsage unless index < size().
  Cell cell(std::size_t index) const;

  /// Properties of all cells, size() entries each, in the order of `cell` (Morton order). Vectors are
  /// computed by the call; spans refer to the field and live as long as one of its copies.

  std::vector<Vector3> centers() const;  ///< model units
  std::vector<double> sizes() const;     ///< sides of the cells, model units
  std::vector<int> levels() const;       ///< depth in the octree; the root cube has 0
  std::vector<Frame> frames() const;

  /// The frames as unit quaternions (w, x, y, z), exactly as they are stored: the rotation that takes the
  /// coordinate axes to those of the frame, v -> q v q*.
  std::vector<std::array<float, 4>> quaternions() const;

  /// Smoothness energy per volume, model units to the power of -2.
  std::span<const float> energy_density() const;

  /// Mean angle between the surface's normal and the nearest axis, by area, degrees; 0 in cells without
  /// surface.
  std::span<const float> alignment_deg() const;

  /// Class of the constraints. Empty for a field read from files that do not have it.
  std::span<const CellConstraint> constraint_classes() const;

  /// Solid that the cell belongs to (SolveReport::regions). Empty where there are not several.
  std::span<const std::int32_t> regions() const;

  /// Samples the field at a point. Inside an active cell the coefficients of the surrounding cells are
  /// blended and projected to the nearest frame; cells across a gap in the solid take no part. Elsewhere the
  /// result is the frame of the nearest cell. Errors: kUsage for a coordinate that is not a finite number.
  Sample sample(const Vector3& point) const;

  /// Samples many points in parallel; bitwise identical to calling `sample` on each. Points may come in any
  /// order.
  std::vector<Sample> sample(std::span<const Vector3> points) const;

  /// Samples into an array of the caller's. Errors: kUsage unless both spans have the same size, and as
  /// above.
  void sample(std::span<const Vector3> points, std::span<Sample> samples) const;

  /// The singular graph of the cells. Arcs end up to one cell before the surface.
  const SingularityGraph& singularities() const;

  const SolveReport& report() const;

  /// The representation behind the field, for the library itself.
  const FieldData& data() const { return *data_; }

 private:
  struct Lazy;
  const Lazy& ready_to_sample() const;
  std::shared_ptr<const FieldData> data_;
  std::shared_ptr<Lazy> lazy_;
};

/// @}

}  // namespace crossgrain
