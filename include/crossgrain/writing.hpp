// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "crossgrain/hex_map.hpp"
#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/spectrum.hpp"
#include "crossgrain/streamlines.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup files Files, pages and pictures
/// @{

/// Writes a tet mesh with its regions and tags, in the format of the extension: Medit (.mesh), whose Ridges
/// are the stated edges, or Gmsh (.msh, version 2.2), whose physical groups have the tags of all but other
/// edges. `read_tets` reads the same mesh, in Medit without edges that are not stated if some are. The file
/// appears complete or not at all. Throws Error(kUsage) for other extensions, Error(kOutput) and
/// Error(kInterrupted).
void write_tets(const TetMesh& mesh, const std::filesystem::path& path, const Monitor& monitor = {});

/// Throws what `write_tets` would if it could not write; leaves no trace. Call before making tets to fail
/// early.
void check_tets_output(const std::filesystem::path& path);

/// Whether files for solvers may hold inverted hexahedra.
enum class InvertedHexahedra { kRefused, kAllowed };

/// Writes hexahedra in the format of the extension (docs/formats.md): VTK (.vtu) with their scaled Jacobian
/// and region; Medit (.mesh), Gmsh 4.1 (.msh) or Abaqus and CalculiX (.inp) with regions and with the
/// boundary by its tags. Vertices and hexahedra keep their order; the head of a partial mesh says that it is
/// one. The file appears complete or not at all. Throws Error(kUsage) for other extensions; for a mesh with
/// corners that are no vertices, with a region for some hexahedra only or with boundary faces that are no
/// faces of hexahedra; and for inverted hexahedra in any format but .vtu unless they are allowed, since
/// solvers give wrong results on them without a word. Error(kOutput) and Error(kInterrupted).
void write_hexahedra(const HexMesh& mesh, const std::filesystem::path& path, const Monitor& monitor = {},
                     InvertedHexahedra inverted = InvertedHexahedra::kRefused);

/// Throws what `write_hexahedra` would if it could not write; leaves no trace. Call before making hexahedra
/// to fail early.
void check_hexahedra_path(const std::filesystem::path& path);

/// Writes a map for other programs, in the format of the extension (docs/formats.md): the integer-grid map
/// for libHexEx (.hexex), or both maps for ParaView (.vtu). The file appears complete or not at all. Throws
/// Error(kUsage) for other extensions, and for a map that lacks coordinates or vertices; Error(kOutput) and
/// Error(kInterrupted).
void write_map(const HexMap& map, const std::filesystem::path& path, const Monitor& monitor = {});

/// Writes streamlines as polylines in the format of the extension (docs/streamlines.md): VTK (.vtu, or .vtp
/// as PolyData) with all that is known of them, or the bare lines as OBJ (.obj). The file appears complete or
/// not at all. `solve` is SolveReport::solve of their field: lines in its folder must name it. Throws
/// Error(kUsage) for other extensions and for a line whose tangents are not as many as its points or whose
/// seed is not among them, Error(kOutput) and Error(kInterrupted).
void write_streamlines(std::span<const Streamline> lines, const std::filesystem::path& path,
                       const Monitor& monitor = {}, const std::string& solve = {});

/// Throws what `write_streamlines` would if it could not write; leaves no trace. Call before tracing to fail
/// early.
void check_streamline_file(const std::filesystem::path& path);

/// Returns the text of report.json (docs/report.md).
std::string report_json(const SolveReport& report);

/// Returns a spectrum as JSON: {degree, matrix, eigenvalues, null_space, linear, constant} as in
/// SpectrumReport, with matrices as lists of rows.
std::string spectrum_json(const SpectrumReport& report);

/// Returns what `crossgrain check --json` prints, as in report.json (docs/report.md): hexahedra and faces, if
/// there are any; the answer, and the singular graphs of the grid and, if there are any, of the tets. Without
/// a field hexahedra, faces and warnings.
std::string check_json(const SolveReport& report);

/// @}

}  // namespace crossgrain
