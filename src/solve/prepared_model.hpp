// SPDX-License-Identifier: Apache-2.0
// A model prepared for a solve: the repaired surface, tests for inside, and all constraints on frames.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "crossgrain/report.hpp"
#include "field/solve_tuning.hpp"
#include "field/solved_surface.hpp"
#include "grid/grid_level.hpp"
#include "measure/crease_report.hpp"
#include "surface/searchable_surface.hpp"
#include "surface/solid_split.hpp"

namespace crossgrain {

/// Refers to itself, so it can be neither copied nor moved.
class PreparedModel {
 public:
  /// Prepares a model. Throws Error for models that cannot be solved: kInput for an invalid model, kUsage for
  /// cells that are too large, kLimit if the memory does not suffice.
  PreparedModel(const TriangleMesh& mesh, const SolveTuning& options);
  PreparedModel(const PreparedModel&) = delete;
  PreparedModel& operator=(const PreparedModel&) = delete;

  const Solid& solid() const { return solid_; }
  const Surface& surface() const { return searchable_->surface(); }
  const MendedSurface& mended() const { return searchable_->mended(); }

  /// Returns the faces inside the model across which frames have an axis: those between solids, and tagged
  /// ones.
  const TriangleMesh& inner_faces() const { return inner_faces_; }
  const CreaseNetwork& creases() const { return creases_; }

  /// Returns the polylines of creases of two or more points.
  std::vector<std::vector<Vector3>> crease_lines() const;

  SolveReport::Model description() const;
  std::vector<ModelFace> faces() const;
  SolveReport::Input findings() const;

  /// Returns the surface that was solved. Leaves the model unusable.
  SurfaceSource solved_surface() &&;

 private:
  PreparedModel(const TriangleMesh& mesh, SolidSplit split, const SolveTuning& options);

  const TriangleMesh& mesh_;
  TriangleMesh inner_faces_;
  std::vector<SolidSplit::Between> interfaces_;
  std::shared_ptr<const SearchableSurface> searchable_;
  std::vector<std::int32_t> face_numbers_;  ///< of the triangles of the surface
  CreaseNetwork creases_;
  Guides guides_;
  Solid solid_;
};

}  // namespace crossgrain
