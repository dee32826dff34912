// SPDX-License-Identifier: Apache-2.0
// Models as tets are made of them, and hexahedra measured against them.
#pragma once

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

/// Returns the solids of `read_solids` as what hexahedra are measured against.
GivenModel given_cad(const TriangleMesh& mesh, double crease_angle_deg);

/// A surface of triangles that bounds solids.
class ClosedModel {
 public:
  /// Closes the cracks that rounding leaves, and mends it as for a solve. Throws Error(kInput) if it bounds
  /// no solid, naming places.
  ClosedModel(TriangleMesh given, double crease_angle_deg);

  const SearchableSurface& surface() const { return surface_; }

  /// What reading found, what was mended, and creases that fade out.
  const std::vector<Warning>& warnings() const { return warnings_; }

  /// Its triangles, outward, by the faces that it names or else between creases.
  PatchedSurface patches() const;

  /// Returns these as what hexahedra are measured against.
  GivenModel given(const PatchedSurface& patches) const;

 private:
  std::vector<Warning> warnings_;
  SearchableSurface surface_;
  double crease_angle_deg_;
};

}  // namespace crossgrain
