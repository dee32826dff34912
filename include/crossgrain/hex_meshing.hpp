// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>

#include "crossgrain/hexahedra.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/options.hpp"
#include "crossgrain/tet_domain.hpp"
#include "crossgrain/tet_making.hpp"
#include "crossgrain/types.hpp"
#include "crossgrain/verdict.hpp"
#include "crossgrain/warning.hpp"

namespace crossgrain {

/// \addtogroup hexahedra Hexahedra
/// @{

/// What the tets of a model say before the work.
struct HexExpectation {
  std::size_t tets = 0;  ///< 0 of a lattice
  double size = 0;       ///< of the hexahedra, model units
  double hexahedra = 0;  ///< about their number: most often within a factor of two

  /// Largest edge of tets that were made; 0 if they were given.
  struct TetSize {
    double used = 0;

    /// The size that comes first by the rule of HexMeshingOptions::tets or by its option, and its number of
    /// tets, if these were so many that a larger size was taken; else 0.
    double dropped = 0;
    std::size_t dropped_tets = 0;
  } tet_size;
};

/// How a model is meshed with hexahedra.
struct HexMeshingOptions {
  HexOptions hexahedra;

  /// How tets are made of a model that has none; `unit` is for a file of tets too. A size that is given comes
  /// first. Without one their edges are 1.4 times those of the hexahedra, or 1.4 times the longest side over
  /// `tets.edges`, whichever is less; where these are more than 50,000 tets, four times the size is taken.
  /// Their crease angle and limit of memory are their own: give those of `solve` too.
  TetMakingOptions tets;

  /// How tags of given tets are read.
  TetTagOptions tags;

  /// The field that the hexahedra follow, without constraints. Its number of threads is that of all steps.
  SolveOptions solve;

  /// Hears of what reading the model or making its first tets found, before the solve; the report has all of
  /// it too.
  std::function<void(const Warning& warning)> on_warning;

  /// Hears what is to be expected, once, before the first solve.
  std::function<void(const HexExpectation& expected)> on_expected;

  /// Hears the answer about the first field, before its repair: what stands in the way of hexahedra. A repair
  /// may change any of it.
  std::function<void(const Answer& answer)> on_answer;

  /// Hears of the end of each attempt at a mesh.
  std::function<void(const HexAttemptEnd& end)> on_attempt_end;
};

/// Returns hexahedra that fill a model: cuts it into tets (`make_tets`) unless its file has tets, solves on
/// them, and makes the mesh that follows the field (`hexahedra`). As long as that does not fill the model,
/// tets of other sizes are tried, then smaller hexahedra; of several results that all leave something out,
/// the one with the least error of its volume is returned. The report tells of each attempt
/// (HexReport::attempts); of the field's report, `seconds.read` is the time for all tets, and
/// `seconds.total` for everything.
///
/// The model is a CAD file, a closed surface or a tet mesh, as for `read_surface` and `read_tets`. The same
/// to the bit for any number of threads, with the same program that makes tets.
///
/// The monitor hears of the model of a file as soon as it is read. Sizes that leave less than two hexahedra
/// across most of the model are a warning (WarningKind::kThinPart), before the work.
///
/// Errors: those of `make_tets` or `read_tets`, `solve_onto` and `hexahedra`, naming the file; kUsage for
/// hexahedra that are larger than the model, or so small that no memory holds them; but if later tets fail,
/// the result of earlier ones is returned. If the monitor allows stops, a stop returns the best mesh so far
/// (HexReport::is_stopped); it is kInterrupted otherwise, and if there is none.
Hexahedra make_hexahedra(const std::filesystem::path& model,
                         const HexMeshingOptions& options = HexMeshingOptions(), const Monitor& monitor = {});

/// The same inside a closed surface.
Hexahedra make_hexahedra(const TriangleMesh& surface, const HexMeshingOptions& options = HexMeshingOptions(),
                         const Monitor& monitor = {});

/// The same of given tets, which are prepared for a map unless they are so already; no others are made.
Hexahedra make_hexahedra(const TetDomain& tets, const HexMeshingOptions& options = HexMeshingOptions(),
                         const Monitor& monitor = {});

/// @}

}  // namespace crossgrain
