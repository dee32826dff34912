// SPDX-License-Identifier: Apache-2.0
// Models as tets are made of them, and hexahedra measured against them.
#pragma once

#include <optional>
#include <vector>

#include "cad_reading/cad_reader.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/types.hpp"
#include "surface/patched_surface.hpp"
#include "surface/searchable_surface.hpp"
#include "tet_making/tet_making_tuning.hpp"

namespace crossgrain {

/// Reads the solids of a CAD file, with triangles fine enough to measure hexahedra against. The monitor hears
/// of the model. Throws as `read_surface` does, and Error(kInput) for solids that are not closed, naming the
/// places.
CadModel read_solids(const InputFile& file, CadFormat format, const TetMakingTuning& options,
                     const Monitor& monitor);

/// The same, but for solids that are not closed.
CadModel read_open_solids(const InputFile& file, CadFormat format, const TetMakingTuning& options,
                          const Monitor& monitor);

bool has_open_solids(const CadModel& model);

/// Returns the solids of `read_solids` as what hexahedra are measured against.
GivenModel given_cad(const TriangleMesh& mesh, double crease_angle_deg);

/// A surface of triangles that bounds solids.
class ClosedModel {
 public:
  /// Mends and closes it (closed_surface), makes parts that overlap one (united_surface), and leaves out what
  /// is narrower than `defeature` (without_small_features). Throws Error(kInput) if it encloses nothing, or
  /// stays open, naming places.
  ClosedModel(TriangleMesh given, double crease_angle_deg, double defeature = 0);

  /// Throws Error(kInput) if triangles still cross, naming places: it cannot be cut into tets.
  void check_crossings() const;

  const SearchableSurface& surface() const { return *surface_; }

  /// What reading found, what was mended, and creases that fade out.
  const std::vector<Warning>& warnings() const { return warnings_; }

  /// Its triangles, outward, by the faces that it names or else between creases.
  PatchedSurface patches() const;

  /// Returns these as what hexahedra are measured against.
  GivenModel given(const PatchedSurface& patches) const;

 private:
  std::vector<Warning> warnings_;
  std::optional<SearchableSurface> surface_;
  void leave_out_below(double size);

  bool may_cross_ = false;  ///< triangles that were made
  double crease_angle_deg_;
};

}  // namespace crossgrain
