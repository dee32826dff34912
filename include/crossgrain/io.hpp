// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "crossgrain/constraints.hpp"
#include "crossgrain/frame_field.hpp"
#include "crossgrain/hex_map.hpp"
#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/options.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/spectrum.hpp"
#include "crossgrain/streamlines.hpp"
#include "crossgrain/tet_frame_field.hpp"
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
/// or binary) or OFF; STEP (.step, .stp), IGES (.iges, .igs) or OpenCASCADE's BREP (.brep, .brp). Vertices
/// with equal coordinates are merged and unused vertices dropped, so that neighbouring triangles share
/// indices in every format. Throws Error(kInput) naming the file, the place in it and the remedy;
/// Error(kUsage) for options out of range.
///
/// Mesh files: polygons are triangulated in their own plane; colours, normals, materials and groups are
/// ignored; triangles without area are kept.
///
/// CAD files: the mesh has faces, solids, corner normals and creases, in millimetres if the format has units.
/// Faces point out of their solid. Faces and shells without a solid are sewn where they meet, and each shell
/// becomes a solid. OpenCASCADE reads the file, if Crossgrain was built with it, in a separate process that
/// ends with this call: a crash, a hang or too much memory there is an Error(kInput), as for any damaged
/// file. Cancelling the monitor kills that process and throws Error(kInterrupted). The result depends only on
/// the file and the options.
TriangleMesh read_surface(const std::filesystem::path& path, const ReadOptions& options = {},
                          const Monitor& monitor = {});

/// Reads a tet mesh. The extension, in either case, names the format: Medit (.mesh in text, .meshb in
/// binary), Gmsh (.msh, version 2 or 4.1) or VTK (.vtk, .vtu), in text or binary. Vertices and tets keep the
/// order of the file, including those that are unused, inverted or without volume. Tets of higher order are
/// read as straight ones, with a warning. Regions and the tags of edges and triangles are reference numbers
/// (Medit), physical groups or else entities (Gmsh), or an array of cell data (VTK: CellEntityIds or similar,
/// docs/command-line.md). All edges and triangles of a file are features, unless its Ridges (Medit) choose
/// among the edges. Throws Error(kInput) naming the file, the place in it and the remedy; also for files
/// without tets or with other solid elements.
TetMesh read_tets(const std::filesystem::path& path);

/// Writes a tet mesh with its regions and tags, in the format of the extension: Medit (.mesh), whose Ridges
/// are the stated edges, or Gmsh (.msh, version 2.2), whose physical groups have the tags of all but other
/// edges. `read_tets` reads the same mesh, in Medit without edges that are not stated if some are. The file
/// appears complete or not at all. Throws Error(kUsage) for other extensions, Error(kOutput) and
/// Error(kInterrupted).
void write_tets(const TetMesh& mesh, const std::filesystem::path& path, const Monitor& monitor = {});

/// Throws what `write_tets` would if it could not write; leaves no trace. Call before making tets to fail
/// early.
void check_tets_output(const std::filesystem::path& path);

/// Writes hexahedra in the format of the extension (docs/formats.md): VTK (.vtu) with their scaled Jacobian
/// and region; Medit (.mesh), Gmsh 4.1 (.msh) or Abaqus and CalculiX (.inp) with regions and with the
/// boundary by its tags. Vertices and hexahedra keep their order. The file appears complete or not at all.
/// Throws Error(kUsage) for other extensions, and for a mesh with corners that are no vertices, with a region
/// for some hexahedra only or with boundary faces that are no faces of hexahedra; Error(kOutput) and
/// Error(kInterrupted).
void write_hexahedra(const HexMesh& mesh, const std::filesystem::path& path, const Monitor& monitor = {});

/// File of hexahedra in the folder of a field from which `read_hexahedra` reads.
inline constexpr const char* kHexahedraFile = "hexahedra.vtu";

/// Reads what `write_hexahedra` has written to a .vtu file, to the bit but for the unit, which the file does
/// not tell; or the hexahedra in a folder (OutputOptions::hexahedra), with the unit of its report. If the
/// file is of an earlier version, which did not list the boundary, that has no tags. Throws Error(kInput),
/// also for a folder without hexahedra.
HexMesh read_hexahedra(const std::filesystem::path& path);

/// Throws what `write_hexahedra` would if it could not write; leaves no trace. Call before making hexahedra
/// to fail early.
void check_hexahedra_path(const std::filesystem::path& path);

/// Writes a map for other programs, in the format of the extension (docs/formats.md): the integer-grid map
/// for libHexEx (.hexex), or both maps for ParaView (.vtu). The file appears complete or not at all. Throws
/// Error(kUsage) for other extensions, and for a map that lacks coordinates or vertices; Error(kOutput) and
/// Error(kInterrupted).
void write_map(const HexMap& map, const std::filesystem::path& path, const Monitor& monitor = {});

/// Returns whether the extension of a file is one of a CAD file.
bool is_cad_file(const std::filesystem::path& path);

/// Returns whether the extension of a file is one that `read_tets` reads, not `read_surface`.
bool is_tet_file(const std::filesystem::path& path);

/// Reads and checks the constraints in a JSON file (docs/constraints.md), with the file and lines for
/// messages. Throws Error(kInput) naming the line, and for a file without constraints.
Constraints read_constraints(const std::filesystem::path& path);

/// A format for a field on tets (docs/formats.md).
struct OutputFormat {
  std::string name;
  std::string description;         ///< one line for a list of formats
  std::vector<std::string> files;  ///< names in the folder
  bool is_always_written = false;
  bool is_of_map = false;  ///< needs OutputOptions::hex_map
};

/// Returns all formats; those that are always written come first.
std::vector<OutputFormat> output_formats();

/// Name of the file with the cells in the folder of a field; of a field that several processes have written
/// (crossgrain/field_parts.hpp), that of the list of their files.
inline constexpr const char* kCellsFile = "field.vtu";
inline constexpr const char* kPiecesFile = "field.pvtu";

/// Returns whether the field in a folder is in the files of several processes.
bool is_in_pieces(const std::filesystem::path& folder);

/// Name of the page in the folder of a field (crossgrain/page.hpp).
inline constexpr const char* kPageFile = "report.html";

/// Names of the files with the singular lines of the grid, and of the tets, in the folder of a field.
inline constexpr const char* kSingularityFile = "singularities.vtu";
inline constexpr const char* kTetSingularityFile = "onto_singularities.vtu";

/// Takes the next bytes of a file.
using ByteSink = std::function<void(std::string_view bytes)>;

/// A file that `write_field` writes together with its own: all of them appear, or none.
struct CompanionFile {
  std::string name;  ///< in the folder; none of the library's own names but kPageFile

  /// Writes the content, given the report as it is written.
  using Writer = std::function<void(const SolveReport& report, const ByteSink& write)>;

  /// Returns the writer. Called once, while the field's own files are written, perhaps on another thread. The
  /// time counts in `seconds.write` of the report. Gets
  /// the monitor of `write_field`.
  std::function<Writer(const Monitor& monitor)> prepare;
};

/// What `write_field` does about files in its folder that this library did not write. It knows its own by a
/// mark in them or by the list in report.json (docs/field-file.md).
enum class ForeignFiles {
  kRefuse,  ///< fails if there is any, or a folder
  kKeep,    ///< fails only if one has the name of a result (`all_result_files`), and leaves the others
  kReplace  ///< replaces or removes those with names of results, and leaves the others
};

/// The sole right to write a field to a folder, until the last pointer to it goes or the process ends.
class FolderReservation;

/// Which cells `write_field` writes to field.vtu (all by default), and which further files. The report and
/// the files for tets always describe the whole field.
struct OutputOptions {
  /// Depth of the smallest cells written, 0 (the root cube) to 19. Deeper leaves are merged into their
  /// ancestor of this depth, even if that extends beyond the solid (docs/field-file.md).
  std::optional<int> level;

  /// Box that restricts the output to the cells that touch it. Model units; bounds may be infinite.
  std::optional<Box> clip;

  /// Names of formats (`output_formats`) for a field on tets, besides those that are always written; in any
  /// order, repetitions allowed.
  std::vector<std::string> formats = {};

  /// Edge of the hexahedra, in model units, that a map has whose gradients are the axes in onto.fra (the
  /// format "fra"): they are written with the length 1 / hex_size.
  double hex_size = 1;

  /// Hexahedra to write as hexahedra.vtu, .mesh, .msh and .inp (`write_hexahedra`); null for none.
  std::shared_ptr<const HexMesh> hexahedra = {};

  /// The map that they are cells of, for the formats that have it.
  std::shared_ptr<const HexMap> hex_map = {};

  /// A further file to write, such as the page that shows the field in a browser (`page_of`).
  std::optional<CompanionFile> companion = {};

  /// The default protects other files in the folder.
  ForeignFiles foreign_files = ForeignFiles::kRefuse;

  /// The right to write to this folder, from `check_field_folder` or `check_onto_folder`; without one,
  /// `write_field` reserves the folder itself.
  std::shared_ptr<FolderReservation> reservation = {};
};

/// Writes FOLDER/field.vtu, FOLDER/singularities.vtu and FOLDER/surface.vtu (docs/field-file.md), which
/// ParaView opens, and FOLDER/report.json (docs/report.md). Creates the folder if it does not exist. New
/// files are written elsewhere and then take the place of the earlier ones, all at once
/// (docs/command-line.md), so that a failure leaves the earlier ones. Files of an earlier field on tets,
/// kStreamlinesFile and an earlier companion that is not written again are removed. Adds the time to
/// `seconds.write` and `seconds.total` of the report and updates `peak_memory_bytes`. If no cell touches the
/// box of `options`, all cells are written, with a warning in the report. Returns the report as written.
/// Throws Error(kOutput); Error(kUsage) for invalid options and for formats of fields on tets;
/// Error(kInterrupted).
SolveReport write_field(const FrameField& field, const std::filesystem::path& folder,
                        const Monitor& monitor = {}, const OutputOptions& options = {});

/// Writes a part of a field (FrameField::is_part): all processes call it together, each writes a file
/// FOLDER/field_N.vtu with its cells, and process 0 all else, with FOLDER/field.pvtu in place of field.vtu,
/// which ParaView opens. Process 0 gets the report. Error(kUsage) with a box. If it fails in one process, the
/// others throw OtherProcessFailed or wait for the failed one.
///
/// Writes a field with a report of the caller's, for example with the path of the model and the time of
/// reading added.
SolveReport write_field(const FrameField& field, SolveReport report, const std::filesystem::path& folder,
                        const Monitor& monitor = {}, const OutputOptions& options = {});

/// Writes a field on tets: the files above and FOLDER/onto.frames, FOLDER/onto.vtu,
/// FOLDER/onto_singularities.vtu and the files of OutputOptions::formats (docs/formats.md), all or none.
/// Files of other formats from an earlier solve are removed. If tets were dropped and a format numbers tets,
/// the report gets a warning.
SolveReport write_field(const TetFrameField& field, SolveReport report, const std::filesystem::path& folder,
                        const Monitor& monitor = {}, const OutputOptions& options = {});
SolveReport write_field(const TetFrameField& field, const std::filesystem::path& folder,
                        const Monitor& monitor = {}, const OutputOptions& options = {});

/// Reads the field on the grid from a folder that `write_field` has written, bit for bit, also from pieces. A
/// field that was written in part or with merged cells becomes a field of those cells; everything else is
/// outside. Throws Error(kInput).
FrameField read_field(const std::filesystem::path& folder);

/// Reads the field on tets from a folder that `write_field` has written; none if the folder has no tets.
/// Frames of vertices equal those written to rounding; frames of tets are computed from them. The mesh has
/// vertices, tets and regions; tags of edges and faces are not in the folder. Throws Error(kInput).
std::optional<TetFrameField> read_tet_field(const std::filesystem::path& folder);

/// Computes the singular graph of the field on tets from the onto.vtu in a folder, faster than by
/// `read_tet_field`; none if there is no such file. Throws Error(kInput).
std::optional<SingularityGraph> read_onto_singularities(const std::filesystem::path& folder);

/// Returns whether the field in a folder was written with a box (OutputOptions::clip) and so lacks cells. Do
/// not start from such a field: `solve_from` would use the frames of the nearest cells instead. Throws
/// Error(kInput).
bool is_clipped_field(const std::filesystem::path& folder);

/// Returns false if there is certainly no such file. If the system does not tell, reading it will say why.
bool may_exist(const std::filesystem::path& path);

/// Returns whether a file has the mark that the files of this library carry, pictures included; those of
/// formats without comments do not (docs/field-file.md).
bool is_own_file(const std::filesystem::path& path);

/// Returns SolveReport::Model::path of the field in a folder; none if the folder has no readable report.
std::optional<std::string> model_of_result(const std::filesystem::path& folder);

/// Returns the report in the folder of a result, without reading the field. Throws Error(kInput).
SolveReport report_of_result(const std::filesystem::path& folder);

/// Returns SolveReport::solve that all files of a result name; empty if they name none. Finishes an
/// interrupted `write_field` first. Throws Error(kInput), naming two files, if they are of different solves.
std::string solve_of_result(const std::filesystem::path& folder);

/// Returns read(), which reads files of a result, all of one solve: again if the result is replaced
/// meanwhile.
template <class Read>
auto read_one_solve(const std::filesystem::path& folder, const Read& read) {
  for (std::string solve = solve_of_result(folder);;) {
    std::exception_ptr failure;
    std::optional<decltype(read())> value;
    try {
      value.emplace(read());
    } catch (...) {
      failure = std::current_exception();
    }
    const std::string before = std::exchange(solve, solve_of_result(folder));
    if (solve != before) continue;
    if (failure) std::rethrow_exception(failure);
    return std::move(*value);
  }
}

/// Returns the names of the files that `write_field` writes with these options for a field on a grid or, with
/// `on_tets`, on tets; report.json comes last.
std::vector<std::string> result_files(const OutputOptions& options = {}, bool on_tets = false);

/// Returns the names of all files of the folder of a field: those of `write_field`, kPageFile and
/// kStreamlinesFile.
std::vector<std::string> all_result_files();

/// Throws Error(kOutput) if `write_field` could not or, because of foreign files, would not write to a
/// folder, and if another one is about to. Returns the sole right to do so; when that goes unused, nothing of
/// it is left. Call before a solve to fail early.
std::shared_ptr<FolderReservation> check_field_folder(const std::filesystem::path& folder,
                                                      const OutputOptions& options = {});

/// Checks the folder for a field on tets.
std::shared_ptr<FolderReservation> check_onto_folder(const std::filesystem::path& folder,
                                                     const OutputOptions& options = {});

// In the following, the path "-" stands for standard input or standard output. Text files have one item per
// line, with numbers separated by blanks; blank lines and everything after a word that begins with '#' are
// ignored.

/// Reads points, `x y z` per line. Throws Error(kInput) naming the line, and for a file without points.
std::vector<Vector3> read_points(const std::filesystem::path& path);

/// Reads normals of any length except zero, `nx ny nz [weight]` per line; the default weight is 1. Throws
/// Error(kInput) naming the line, and for a file without normals.
std::vector<WeightedNormal> read_normals(const std::filesystem::path& path);

/// Destinations of `write_samples`.
struct SampleFiles {
  std::filesystem::path frames = "-";

  /// Receives the points outside, `x y z` per line after a comment line; no such file if empty.
  std::filesystem::path outside;
};

/// Writes a comment line that names the columns, then the frame at each point (FrameField::sample), one line
/// per point: the nine numbers of its three unit axes, with 17 significant digits. Returns the number of
/// points outside all active cells. Both files appear complete or not at all. Throws Error(kOutput) and
/// Error(kInterrupted).
std::size_t write_samples(const FrameField& field, std::span<const Vector3> points, const SampleFiles& files,
                          const Monitor& monitor = {});

/// Default name of the file that `crossgrain streamlines` writes to the folder of a field.
inline constexpr const char* kStreamlinesFile = "streamlines.vtu";

/// Writes streamlines as polylines to a .vtu file (docs/streamlines.md), which ParaView opens. The file
/// appears complete or not at all. `solve` is SolveReport::solve of their field: lines in its folder must
/// name it. Throws Error(kUsage) for a line whose tangents are not as many as its points or whose seed is not
/// among them, Error(kOutput) and Error(kInterrupted).
void write_streamlines(std::span<const Streamline> lines, const std::filesystem::path& path,
                       const Monitor& monitor = {}, const std::string& solve = {});

/// Reads the lines that `write_streamlines` has written. Throws Error(kInput).
std::vector<AxisCurve> read_streamlines(const std::filesystem::path& path);

/// Reads the singular graph of the whole field from singularities.vtu or onto_singularities.vtu, without the
/// numbers of edges and loops, which are in the report. Throws Error(kInput).
SingularityGraph read_singularities(const std::filesystem::path& path);

/// Throws Error(kOutput) if `write_streamlines` could not write; leaves no trace. Call before tracing to fail
/// early.
void check_streamline_file(const std::filesystem::path& path);

/// Returns the text of report.json (docs/report.md).
std::string report_json(const SolveReport& report);

/// Returns a spectrum as JSON: {degree, matrix, eigenvalues, null_space, linear, constant} as in
/// SpectrumReport, with matrices as lists of rows.
std::string spectrum_json(const SpectrumReport& report);

/// Returns what `crossgrain check --json` prints: the answer, and the singular graphs of the grid and, if
/// there are any, of the tets, as in report.json (docs/report.md).
std::string check_json(const SolveReport& report);

/// @}

}  // namespace crossgrain
