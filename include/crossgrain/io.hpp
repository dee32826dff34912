// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "crossgrain/constraints.hpp"
#include "crossgrain/frame_field.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/options.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/spectrum.hpp"
#include "crossgrain/streamlines.hpp"
#include "crossgrain/tet_frame_field.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// How a surface is read. Of these, files of triangles take notice of max_memory_bytes only; the others say
/// how CAD files are read and cut into triangles.
struct ReadOptions {
  /// The finest cells that the surface is for, as in SolveOptions: along the longest side of the bounding
  /// box, 0 for kDefaultResolution; or their size in the unit of the mesh, which counts where positive.
  int resolution = 0;
  double cell_size = 0;

  /// How far triangles may be from the true surface, in cells. Normals come from the true surface, not from
  /// the triangles, so that a tenth is less than the grid can tell; but at most 1/40 and at least a millionth
  /// of the longest side, below which no octree reaches.
  double chord_error_cells = 0.1;

  /// The most that the normal may turn along an edge of a triangle: fillets much smaller than a cell keep
  /// their directions.
  double facet_angle_deg = 15;

  /// Edges where the true surface turns by more than this somewhere are creases.
  double crease_angle_deg = 35;

  /// How long reading a CAD file may take, besides 10 s for each megabyte of it. OpenCASCADE is never done
  /// with some damaged files; sound ones take less than a second, or a few where they have many thousands of
  /// faces.
  double read_seconds = 60;

  /// The most that the process may hold meanwhile, together with the one that reads CAD files; 0 for nine
  /// tenths of what the machine or the container has.
  std::size_t max_memory_bytes = 0;

  /// The program that reads CAD files, crossgrain_cad. Where empty it is looked for beside this library and
  /// the running program, in libexec/crossgrain/.
  std::filesystem::path cad_program = {};
};

/// The surface in a file. The extension names the format, in either case: STL (ASCII or binary), OBJ, PLY
/// (ASCII or binary) or OFF; STEP (.step, .stp), IGES (.iges, .igs) or OpenCASCADE's BREP (.brep, .brp).
/// Vertices of equal coordinates become one vertex and vertices that no triangle uses are dropped, so that
/// neighbouring triangles share indices whatever the format. Throws Error(kInput) naming the file, the place
/// in it and the mend.
///
/// Files of polygons: these are cut into triangles in their own plane; whatever else there is (colours,
/// normals, materials, groups) is passed over; triangles without area stay in.
///
/// CAD files: the mesh has faces, solids, corner normals and creases, in millimetres where the format has
/// units. Faces look out of their solid; faces and shells of no solid are sewn together where they meet, and
/// each shell counts as a solid of its own. They are read with OpenCASCADE, where Crossgrain was built with
/// it, by a process that is started for each file and gone when this returns: where it crashes, hangs or
/// needs too much memory there is an Error(kInput) as for any damaged file. That process is killed, and
/// Error(kInterrupted) thrown, once the monitor is cancelled. The result depends on nothing but the file and
/// the options; of these Error(kUsage) for angles, errors and times out of range.
TriangleMesh read_surface(const std::filesystem::path& path, const ReadOptions& options = {},
                          const Monitor& monitor = {});

/// The solid in a tet mesh file. The extension names the format, in either case: Medit (.mesh in text, .meshb
/// in binary), Gmsh (.msh, version 2 or 4.1), VTK (.vtk, .vtu); text or binary, whatever these formats allow.
/// Vertices and tets stand in the order of the file, those that are unused, inverted or without volume too.
/// Tets of higher order count as straight, with a warning. Regions and the tags of edges and triangles are
/// reference numbers (Medit), physical groups or else entities (Gmsh), or an array of cell data (VTK:
/// CellEntityIds or the like, docs/command-line.md); all edges and triangles that a file has are features,
/// unless its Ridges (Medit) choose among the edges. Throws Error(kInput) naming the file, the place in it
/// and the mend, also where there are no tets or solid elements of other shapes.
TetMesh read_tets(const std::filesystem::path& path);

/// Whether `read_tets`, and not `read_surface`, takes a file of this name, by its extension.
bool is_tet_file(const std::filesystem::path& path);

/// The constraints in a JSON file (docs/constraints.md), checked; `source` and lines are those of the file.
/// Throws Error(kInput) naming the line that is wrong, and where there are none at all.
Constraints read_constraints(const std::filesystem::path& path);

/// A format that a field on tets can be written in (docs/formats.md).
struct OutputFormat {
  std::string name;
  std::string description;         ///< for a list of them
  std::vector<std::string> files;  ///< what they are called in the folder
  bool is_always_written = false;
};

/// All of them, those first that are always written.
std::vector<OutputFormat> output_formats();

/// What the page of a field is called in its folder (crossgrain/page.hpp).
inline constexpr const char* kPageFile = "report.html";

/// A file that `write_field` writes together with its own: all of them appear, or none.
struct CompanionFile {
  std::string name;  ///< in the folder; none of the library's own names but kPageFile

  /// The content of the file, given the report as it is written.
  std::function<std::string(const SolveReport&)> text;
};

/// How much of a field `write_field` writes to field.vtu, by default all of it, and which formats it writes.
/// The report, and what is written for tets, are of the whole field in any case.
struct OutputOptions {
  /// Depth of the smallest cells written, 0 (the root cube) to 19. Leaves that are deeper become one cell,
  /// the ancestor of this depth, also where that reaches out of the solid (docs/field-file.md).
  std::optional<int> level;

  /// Only cells that have a point in common with this box are written. Model units; bounds may be infinite.
  std::optional<Box> clip;

  /// Names of formats (`output_formats`) to write a field on tets in, besides those that always are; in any
  /// order, and any number of times.
  std::vector<std::string> formats = {};

  /// Further files to write, such as the page that shows the field in a browser (`page_of`).
  std::vector<CompanionFile> companions = {};
};

/// Writes FOLDER/field.vtu, FOLDER/singularities.vtu and FOLDER/surface.vtu (docs/field-file.md), which
/// ParaView opens, and FOLDER/report.json (docs/report.md), making the folder where it is missing. All are
/// written beside and then renamed: a failure leaves what was there before. Files of an earlier field on
/// tets, kStreamlinesFile and a kPageFile that is not written anew are removed, so that a folder never holds
/// a mix of two solves. The report's seconds.write is what that took; it is added to seconds.total, and
/// peak_memory_bytes is brought up to date. Where no cell meets the box of `options`, all are written, with a
/// warning in the report: a solve is not lost for a box. Returns the report as written. Throws
/// Error(kOutput), Error(kUsage) for options that make no sense (of formats any, as they are of fields on
/// tets), and Error(kInterrupted) once the monitor is cancelled.
SolveReport write_field(const FrameField& field, const std::filesystem::path& folder,
                        const Monitor& monitor = {}, const OutputOptions& options = {});

/// The same with `report`, the field's own with the model's path and the time of reading it filled in, say.
SolveReport write_field(const FrameField& field, SolveReport report, const std::filesystem::path& folder,
                        const Monitor& monitor = {}, const OutputOptions& options = {});

/// The same with FOLDER/onto.frames, FOLDER/onto.vtu and FOLDER/onto_singularities.vtu and the files of
/// OutputOptions::formats (docs/formats.md): all files or none. Those of formats that are not asked for are
/// removed, should an earlier solve have written them. Where tets are left out, and files that number them
/// are asked for, the report written has a warning. Without `report`, the field's own.
SolveReport write_field(const TetFrameField& field, SolveReport report, const std::filesystem::path& folder,
                        const Monitor& monitor = {}, const OutputOptions& options = {});
SolveReport write_field(const TetFrameField& field, const std::filesystem::path& folder,
                        const Monitor& monitor = {}, const OutputOptions& options = {});

/// What `write_field` has written to a folder, to the bit; of a field on tets, the one on the grid. Of part
/// of a field or of merged cells, those: a field like any other, to which the rest is outside. Throws
/// Error(kInput).
FrameField read_field(const std::filesystem::path& folder);

/// The field on tets in a folder that `write_field` has written, with the one on the grid that it was carried
/// over from; none where the folder has no tets. Frames of vertices are those that were written to rounding,
/// frames of tets are computed from them. The mesh has vertices, tets and regions; what its file tagged is
/// not in the folder. Throws Error(kInput).
std::optional<TetFrameField> read_tet_field(const std::filesystem::path& folder);

/// The lines around which the frames of tets turn, worked out anew from the onto.vtu that `write_field` has
/// written to a folder; none where there is none. Throws Error(kInput).
std::optional<SingularityGraph> read_onto_singularities(const std::filesystem::path& folder);

/// Whether cells are missing from the field in a folder, for it was written with a box (OutputOptions::clip).
/// Not to be started from: `solve_from` would take the frames of the nearest cells for those. Throws
/// Error(kInput).
bool is_clipped_field(const std::filesystem::path& folder);

/// The names of the files that `write_field` writes for a field on a grid or, with `on_tets`, on tets too,
/// for these options; report.json comes last.
std::vector<std::string> result_files(const OutputOptions& options = {}, bool on_tets = false);

/// The names of all files that the folder of a field may hold, written by `write_field` or `crossgrain
/// streamlines`.
std::vector<std::string> all_result_files();

/// Throws Error(kOutput) where `write_field` could not write to a folder; leaves no trace. To be asked before
/// a solve.
void check_field_folder(const std::filesystem::path& folder, const OutputOptions& options = {});

/// The same for a field on tets, and these options.
void check_onto_folder(const std::filesystem::path& folder, const OutputOptions& options = {});

/// In the following, the path "-" means standard input or standard output. Text files have one item a line,
/// its numbers separated by blanks; blank lines, and what follows a word that begins with '#', are passed
/// over.

/// Points, `x y z` a line. Throws Error(kInput) naming the line that is wrong, and where there is no point at
/// all.
std::vector<Vector3> read_points(const std::filesystem::path& path);

/// Normals of any length but zero, `nx ny nz [weight]` a line; the weight is 1 where it is left out. Throws
/// Error(kInput) naming the line that is wrong, and where there is no normal at all.
std::vector<WeightedNormal> read_normals(const std::filesystem::path& path);

/// Where `write_samples` writes to.
struct SampleFiles {
  std::filesystem::path frames = "-";

  /// The points outside, `x y z` a line; none where empty.
  std::filesystem::path outside;
};

/// Writes the frame at each point (FrameField::sample): the nine numbers of its three unit axes one after the
/// other, a line each, of 17 significant digits. Returns how many points are in no active cell. Both files
/// appear complete or not at all. Throws Error(kOutput), and Error(kInterrupted) once the monitor is
/// cancelled.
std::size_t write_samples(const FrameField& field, std::span<const Vector3> points, const SampleFiles& files,
                          const Monitor& monitor = {});

/// What `crossgrain streamlines` calls its file in the folder of a field, where it is given no other name.
inline constexpr const char* kStreamlinesFile = "streamlines.vtu";

/// Writes streamlines as polylines to a .vtu file (docs/streamlines.md), which ParaView opens. It appears
/// complete or not at all. Throws Error(kOutput), and Error(kInterrupted) once the monitor is cancelled.
void write_streamlines(std::span<const Streamline> lines, const std::filesystem::path& path,
                       const Monitor& monitor = {});

/// The points of each line that `write_streamlines` has written to a file, two at least, model units. Throws
/// Error(kInput).
std::vector<std::vector<Vector3>> read_streamline_points(const std::filesystem::path& path);

/// The graph in a file singularities.vtu or onto_singularities.vtu that `write_field` has written: that of
/// the whole field, without the counts of edges and loops, which are in the report. Throws Error(kInput).
SingularityGraph read_singularities(const std::filesystem::path& path);

/// Throws Error(kOutput) where `write_streamlines` could not write; leaves no trace. To be asked before
/// tracing.
void check_streamline_file(const std::filesystem::path& path);

/// A report as the JSON text of report.json (docs/report.md).
std::string report_json(const SolveReport& report);

/// A spectrum as JSON text: {degree, matrix, eigenvalues, null_space, linear, constant} as in SpectrumReport,
/// matrices as lists of rows.
std::string spectrum_json(const SpectrumReport& report);

/// Singularity graphs as JSON text, of a field on the grid and, unless null, of that on tets: {grid, tets},
/// each as `singularity` in report.json (docs/report.md).
std::string singularity_json(const SolveReport::Singularity& grid, const SolveReport::Singularity* tets);

}  // namespace crossgrain
