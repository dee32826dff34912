// SPDX-License-Identifier: Apache-2.0
// A model made ready to be solved: mended, its insides known, and all gathered that frames are to follow.
#pragma once

#include <string>
#include <vector>

#include "crossgrain/options.hpp"
#include "crossgrain/report.hpp"
#include "field/solved_surface.hpp"
#include "grid/grid_level.hpp"
#include "measure/crease_report.hpp"
#include "surface/mending.hpp"
#include "surface/solid_split.hpp"

namespace crossgrain {

/// Refers to itself, so that it is neither copied nor moved.
class PreparedModel {
 public:
  /// Throws Error for models that are refused before any solve: kInput for those that make no sense, kUsage
  /// for cells too large, kLimit for want of memory.
  PreparedModel(const TriangleMesh& mesh, const SolveOptions& options);
  PreparedModel(const PreparedModel&) = delete;
  PreparedModel& operator=(const PreparedModel&) = delete;

  const Solid& solid() const { return solid_; }
  const Surface& surface() const { return mended_.surface; }
  const MendedSurface& mended() const { return mended_; }

  /// Faces between solids, and others inside that frames are to have an axis across.
  const TriangleMesh& inner_faces() const { return inner_faces_; }
  const CreaseNetwork& creases() const { return creases_; }

  SolveReport::Model description() const;
  SolveReport::Input findings() const;

  /// The surface that was solved, moved out of a model that is not used afterwards.
  SolvedSurface solved_surface() &&;

 private:
  PreparedModel(const TriangleMesh& mesh, SolidSplit split, const SolveOptions& options);

  const TriangleMesh& mesh_;
  TriangleMesh inner_faces_;
  MendedSurface mended_;
  TriangleBvh bvh_;
  WindingNumber winding_;
  CreaseNetwork creases_;
  Guides guides_;
  Solid solid_;
};

}  // namespace crossgrain
