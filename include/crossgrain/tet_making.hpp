// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>

#include "crossgrain/monitor.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup files Files, pages and pictures
/// @{

/// The program that cuts solids into tets.
enum class TetMaker : int {
  kAutomatic,  ///< the first of the others that is installed and succeeds
  kGmsh,       ///< gmsh, a program of others that the user has installed
  kNetgen      ///< crossgrain_netgen, a program of Crossgrain with Netgen inside
};

/// Returns a name for options and scripts: "gmsh".
const char* name_of(TetMaker maker);

/// How tets are made.
struct TetMakingOptions {
  /// Largest edge of the tets, in the unit of the mesh; 0: `edges` of them along the longest side.
  double size = 0;
  double edges = 20;

  TetMaker maker = TetMaker::kAutomatic;

  /// Edges around a full circle of any curvature. With 18 a triangle's normal is within 10 degrees of the
  /// surface.
  double edges_per_circle = 18;

  /// Smallest angle between the normals beside an edge of a surface that makes it a crease, and so a border
  /// of patches; of CAD files, as ReadOptions::crease_angle_deg.
  double crease_angle_deg = 35;

  /// Holes, slots, pockets and bosses narrower than this, in the unit of the model, are left out, each told
  /// in a warning; a CAD file is cut into tets by its triangles then, as one solid. 0: none.
  double defeature = 0;

  /// Time limit for each program that makes tets.
  double seconds = 600;

  /// Largest memory of the process together with the program that it runs; 0 for nine tenths of what the
  /// machine or the container has.
  std::size_t max_memory_bytes = 0;

  /// Time limit for reading a CAD file, whether its solids are glued, and the unit of a file that names none
  /// (ReadOptions).
  double read_seconds = 60;
  bool glue = false;
  LengthUnit unit = LengthUnit::kUnknown;
};

/// Cuts the solids of a model into tets. The model is a CAD file or a surface of triangles
/// (`read_surface`). All tets have a positive volume, and their vertices are used. Regions are numbers of
/// solids, from 1. The faces of the solids and the edges between them are tagged:
///
/// - CAD files: triangles have the numbers of their faces (TriangleMesh::faces), edges those of their CAD
/// edges
///   in the order of TopExp::MapShapes. Vertices lie on the true faces. Edges with an angle between their
///   faces are stated (TetMesh::Edge).
/// - Surfaces: triangles have the numbers of their patches, which creases separate, from 1 in the order of
///   their first triangles; edges those of their creases. The surface is mended first, as for a solve, and
///   cut into new triangles of even size, whose vertices lie on the given ones.
///
/// Another program makes the tets (TetMaker), with files in a private folder that is removed afterwards. It
/// is killed if the monitor is stopped or cancelled, and after `seconds`. The monitor hears of the model of a
/// file as soon as it is read (Monitor::tell). TetMesh::warnings says what was
/// mended and what failed before another way succeeded. With the same programs the result is always the same.
///
/// Throws Error(kInput) for models that cannot be read, that are not closed, naming the places of the holes,
/// or that cut through themselves, and if no program makes valid tets of them; Error(kLimit) for too many
/// tets, too little time or memory; Error(kOutput) if files cannot be written; Error(kUsage) for options out
/// of range, and for a size that is larger than the model, or so small that no memory holds the tets;
/// Error(kInterrupted).
TetMesh make_tets(const std::filesystem::path& model, const TetMakingOptions& options = {},
                  const Monitor& monitor = {});

/// Cuts the solids inside a surface into tets, as for a file of triangles. If it has faces, they are the
/// patches.
TetMesh make_tets(const TriangleMesh& surface, const TetMakingOptions& options = {},
                  const Monitor& monitor = {});

/// Shape of tets: 12 (3 V)^(2/3) over the sum of the six squared edges (mean ratio; Liu, Joe 1994), 1 if a
/// tet of the volume V is regular and 0 or less if it has none or is inverted.
struct TetQuality {
  double worst = 1;
  double mean = 1;
};
TetQuality quality_of(const TetMesh& mesh);

/// @}

}  // namespace crossgrain
