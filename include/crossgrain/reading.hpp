// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "crossgrain/constraints.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/options.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup files Files, pages and pictures
/// @{

/// How a surface is read. Only max_memory_bytes applies to files of triangles; all other options say how CAD
/// files are read and triangulated.
struct ReadOptions {
  /// The finest cells of the solve that the surface is for, as in SolveOptions: their number along the
  /// longest side of the bounding box, 0 for kDefaultResolution; or, if positive, their size in the unit of
  /// the mesh.
  int resolution = 0;
  double cell_size = 0;

  /// Largest change of the normal along an edge of a triangle, so that fillets much smaller than a cell keep
  /// their directions.
  double facet_angle_deg = 15;

  /// Smallest angle between the faces of an edge, anywhere along it, that makes it a crease.
  double crease_angle_deg = 35;

  /// Whether the solids of a CAD file are cut along each other's faces (general fuse), so that they share
  /// triangles where they touch. Faces keep their numbers, solids too; what several overlapping solids hold
  /// belongs to the smallest. An Error(kInput) if OpenCASCADE cannot do it.
  bool glue = false;

  /// Unit of the coordinates of a file that names none: a label, no number changes. STEP and IGES files that
  /// name a unit are converted to millimetres; another one here is an Error(kUsage).
  LengthUnit unit = LengthUnit::kUnknown;

  /// Time limit for reading a CAD file, plus 10 s per megabyte of it. OpenCASCADE does not terminate on some
  /// damaged files; sound ones take less than a second, or a few seconds with many thousands of faces.
  double read_seconds = 60;

  /// Memory limit of the process while reading, together with the one that reads CAD files; 0 for nine tenths
  /// of what the machine or the container has.
  std::size_t max_memory_bytes = 0;
};

/// Returns how to read the surface for a solve with these options: triangles of a CAD file that suit its
/// cells, its angle of creases, its limit of memory.
ReadOptions read_options_for(const SolveOptions& options);

/// Reads a surface. The extension, in either case, names the format: STL (ASCII or binary), OBJ, PLY (ASCII
/// or binary), OFF or 3MF; STEP (.step, .stp), IGES (.iges, .igs), OpenCASCADE's BREP (.brep, .brp) or a
/// document of FreeCAD (.FCStd). Files of each format may be packed by gzip (.stl.gz). Vertices
/// with equal coordinates are merged and unused vertices dropped, so that neighbouring triangles share
/// indices in every format. Throws Error(kInput) naming the file, the place in it and the remedy;
/// Error(kUsage) for options out of range.
///
/// Mesh files: polygons are triangulated in their own plane; colours, normals, materials and groups are
/// ignored; triangles without area are kept. Of 3MF the items to build are read, in millimetres.
///
/// CAD files: the mesh has faces, solids, corner normals and creases, in millimetres if the format has units.
/// Of a document of FreeCAD the objects that are visible are read. Open faces alone are an Error(kInput).
/// Faces point out of their solid. Faces and shells without a solid are sewn where they meet, and each shell
/// becomes a solid. OpenCASCADE reads the file, if Crossgrain was built with it, in a separate process that
/// ends with this call: a crash, a hang or too much memory there is an Error(kInput), as for any damaged
/// file. Cancelling the monitor kills that process and throws Error(kInterrupted). The result depends only on
/// the file and the options.
///
/// The monitor hears of the model as soon as it is read (Monitor::tell).
TriangleMesh read_surface(const std::filesystem::path& path, const ReadOptions& options = {},
                          const Monitor& monitor = {});

/// Reads a tet mesh. The extension, in either case, names the format: Medit (.mesh in text, .meshb in
/// binary), Gmsh (.msh, version 2 or 4.1) or VTK (.vtk, .vtu), in text or binary; each of them may be packed
/// by gzip (.msh.gz). Vertices and tets keep the
/// order of the file, including those that are unused, inverted or without volume. Tets of higher order are
/// read as straight ones, with a warning. Regions and the tags of edges and triangles are reference numbers
/// (Medit), physical groups or else entities (Gmsh), or an array of cell data (VTK: CellEntityIds or similar,
/// docs/command-line.md). All edges and triangles of a file are features, unless its Ridges (Medit) choose
/// among the edges. Throws Error(kInput) naming the file, the place in it and the remedy; also for files
/// without tets or with other solid elements.
TetMesh read_tets(const std::filesystem::path& path);

/// Returns the name of a model without folder and extensions: "part" for models/part.step.gz.
std::string stem_of_model(const std::filesystem::path& path);

/// Returns whether the extension of a file, without .gz, is one of a CAD file.
bool is_cad_file(const std::filesystem::path& path);

/// Returns whether the extension of a file, without .gz, is one that `read_tets` reads, not `read_surface`.
bool is_tet_file(const std::filesystem::path& path);

/// Reads and checks the constraints in a JSON file (docs/constraints.md), with the file and lines for
/// messages. Throws Error(kInput) naming the line, and for a file without constraints.
Constraints read_constraints(const std::filesystem::path& path);

/// @}

}  // namespace crossgrain
