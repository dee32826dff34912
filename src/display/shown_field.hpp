// SPDX-License-Identifier: Apache-2.0
// The field that a picture or the page shows: on tets, or on a grid.
#pragma once

#include <memory>

#include "crossgrain/frame_field.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/tet_frame_field.hpp"
#include "field/field_data.hpp"
#include "field/solved_surface.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tet_field.hpp"

namespace crossgrain {

/// A field on tets or on a grid with all that is drawn of it. Cheap to copy; refers to nothing but `lines`.
class ShownField {
 public:
  /// The field on a grid; also the one from which a field on tets started. `lines` replaces its singular
  /// lines unless null, and must outlive this. Throws Error(kInput) for a field without a surface.
  explicit ShownField(const FrameField& field, const SingularityGraph* lines = nullptr);

  /// The field on tets, likewise.
  explicit ShownField(const TetFrameField& field, const SingularityGraph* lines = nullptr);

  bool is_on_tets() const { return tets_.has_value(); }

  /// Whether this is the grid from which a field on tets started.
  bool is_starting_grid() const { return !is_on_tets() && report().onto.has_value(); }

  /// The field on the grid; that from which the field started, if it is on tets.
  const FieldData& grid() const { return grid_.data(); }

  /// The mesh and the field on it. Only if is_on_tets().
  const TetDomainData& tets() const { return tets_->domain().data(); }
  const TetField& tet_field() const { return tets_->data(); }

  /// The surface to draw: that of the solve, or the boundary of the tets, whose triangle k is
  /// tets().solid.boundary[k] with vertices of the mesh, and which has the creases of the solve.
  const SolvedSurface& surface() const { return *surface_; }

  /// The same for searching. Throws Error(kInput) if no triangle has an area.
  std::shared_ptr<const SearchableSurface> searchable() const {
    return is_on_tets() ? crossgrain::searchable(*surface_) : grid().surface.searchable();
  }

  const SingularityGraph& lines() const { return *lines_; }
  const SolveReport& report() const { return tets_ ? tets_->report() : grid_.report(); }

  /// The counts in the report that belong to lines().
  const SolveReport::Singularity& counts() const {
    return is_on_tets() && report().onto ? report().onto->singularity : report().singularity;
  }

 private:
  FrameField grid_;
  std::optional<TetFrameField> tets_;
  std::shared_ptr<const SolvedSurface> surface_;
  const SingularityGraph* lines_;
};

}  // namespace crossgrain
