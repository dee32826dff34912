// SPDX-License-Identifier: Apache-2.0
// The field on the cells of a grid, for tracing lines.
#pragma once

#include <mutex>
#include <optional>

#include "field/field_data.hpp"
#include "sampling/arc_tubes.hpp"
#include "sampling/cell_names.hpp"
#include "sampling/leaf_turn.hpp"
#include "sampling/line_space.hpp"
#include "sampling/model_boundary.hpp"
#include "sampling/sampling.hpp"

namespace crossgrain {

/// Cells are leaves. Segments end at faces that are not open, or, with a known surface, at that. Refers to
/// itself and to the field.
class GridLines : public LineSpace {
 public:
  /// `surface` may be null. Throws Error(kInput) if it bounds nothing or lies elsewhere than the field.
  GridLines(const FieldData& field, const TriangleMesh* surface, double arc_distance_cells);
  GridLines(const GridLines&) = delete;
  GridLines& operator=(const GridLines&) = delete;

  Box bounds() const override { return bounds_; }
  double volume() const override;
  Box box_of_seeds() const override;
  LineSurface surface() const override;
  LineCell cell_at(const Vector3& point) const override;
  double cell_size(LineCell cell) const override { return leaves_.tree.cell_size(cell); }
  bool is_at_arc(const LinePlace& place) const override;
  Quaternion frame_at(const LinePlace& from, const Vector3& to, LineCell& end) const override;
  LineStop first_stop(const LinePlace& from, const Vector3& to) const override;
  AxisNames names_at(const LinePlace& place, const Quaternion& frame) const override;

 private:
  Vector3 in_units(const Vector3& point) const;

  const FieldData& field_;
  LeafField leaves_;
  Sampler sampler_;
  ArcTubes tubes_;
  Box bounds_;
  std::optional<ModelBoundary> boundary_;
  mutable std::once_flag names_once_;
  mutable std::optional<CellNames> names_;
};

}  // namespace crossgrain
