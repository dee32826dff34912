// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>

#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/tet_domain.hpp"
#include "crossgrain/types.hpp"
#include "crossgrain/warning.hpp"

namespace crossgrain {

/// \addtogroup hexahedra Hexahedra
/// @{

/// How the model of a fit is read, and what of it is kept.
struct HexFitOptions {
  /// Smallest angle between the faces beside an edge that makes it a crease, as
  /// ReadOptions::crease_angle_deg.
  double crease_angle_deg = 35;

  /// Holes, slots, pockets and bosses narrower than this, in the unit of the model, are left out of a surface
  /// or a CAD file, whose solids are one then. 0: none.
  double defeature = 0;

  /// How tags of a model that is a tet mesh are read.
  TetTagOptions tags;

  /// Time limit for reading a CAD file, and whether its solids are glued, as in ReadOptions.
  double read_seconds = 60;
  bool glue = false;

  /// Unit of a model whose file names none, and so of the hexahedra.
  LengthUnit unit = LengthUnit::kUnknown;

  /// Largest memory of the process; 0 for nine tenths of what the machine or the container has.
  std::size_t max_memory_bytes = 0;

  int threads = 0;  ///< 0 for all; the result does not depend on it

  /// Hears of what reading the model found, before the work; the report has all of it too.
  std::function<void(const Warning& warning)> on_warning = {};
};

/// The surface of a model, for display.
struct SolvedSurface;

/// Hexahedra that were put onto a model.
struct FittedHexahedra {
  HexMesh mesh;
  SolveReport report;  ///< of the model, its faces and the hexahedra; there is no field
  std::shared_ptr<const SolvedSurface> surface = {};  ///< of the model, for `page_of`

  const HexReport& hexahedra() const { return *report.hexahedra; }
};

/// Puts hexahedra of any mesher, which roughly fill a model, onto its corners, creases and faces. The result
/// is the best by measurement of: the mesh as given; moved onto the features; and the same with layers of
/// hexahedra where angles need them, or one everywhere (HexReport::fit_tries). Given vertices and hexahedra
/// keep their order, and hexahedra their regions; new ones follow. Quads have the numbers of the model's
/// faces. The report says what is kept, and the outcome as for `make_hexahedra`: kPartial if some stay
/// inverted, or if the surface has another topology than the model's; HexReport::size is the median edge.
///
/// The model is a CAD file, a closed surface or a tet mesh, as for `read_surface` and `read_tets`, in the
/// coordinates of the hexahedra; its solids are one, as are hexahedra of all regions: faces between regions
/// move as vertices inside do. The same to the bit for any number of threads.
///
/// If the monitor allows stops, a stop returns the best mesh so far (HexReport::is_stopped).
///
/// Errors: those of reading the model; kInput for hexahedra whose boundary is no closed surface, with counts,
/// and for those whose bounding box is not about that of the model (docs/command-line.md); kLimit;
/// kInterrupted by the monitor, and by a stop before there is a mesh.
FittedHexahedra fit_hexahedra(const HexMesh& mesh, const std::filesystem::path& model,
                              const HexFitOptions& options = {}, const Monitor& monitor = {});

/// The same to a closed surface.
FittedHexahedra fit_hexahedra(const HexMesh& mesh, const TriangleMesh& surface,
                              const HexFitOptions& options = {}, const Monitor& monitor = {});

/// Writes hexahedra.vtu, .mesh, .msh and .inp (of a partial mesh hexahedra.partial.vtu and so on), and
/// report.json, to a folder, which `read_hexahedra` reads. As `write_field` does: all files or none, in place
/// of those of an earlier result, with the options about hexahedra, companion and foreign files; others do
/// not matter. Returns the report as written. Throws Error(kOutput) and Error(kInterrupted).
SolveReport write_fitted(const FittedHexahedra& fitted, const std::filesystem::path& folder,
                         const Monitor& monitor = {}, const OutputOptions& options = {});

/// @}

}  // namespace crossgrain
