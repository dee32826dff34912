// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "crossgrain/frame_field.hpp"
#include "crossgrain/hex_map.hpp"
#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/streamlines.hpp"
#include "crossgrain/tet_frame_field.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup files Files, pages and pictures
/// @{

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

  /// Writes the content, given the report as it is written, but for this file in its list.
  using Writer = std::function<void(const SolveReport& report, const ByteSink& write)>;

  /// Returns the writer. Called once, while the field's own files are written, perhaps on another thread. The
  /// time counts in `seconds.write` of the report. Gets
  /// the monitor of `write_field`.
  std::function<Writer(const Monitor& monitor)> prepare;
};

/// What `write_field` does about files in its folder that this library did not write, and about results that
/// were changed since. It knows its own by the list in report.json, and what has no name of a result by a
/// mark (docs/field-file.md).
enum class ForeignFiles {
  kRefuse,  ///< fails if there is any, or a folder
  kKeep,    ///< fails only if one has the name of a result (`all_result_files`), and leaves the others
  kReplace  ///< replaces or removes those with names of results, changed or not, and leaves the others
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

  /// Hexahedra to write as hexahedra.vtu, .mesh, .msh and .inp (`write_hexahedra`), of a partial mesh as
  /// hexahedra.partial.vtu and so on; null for none. With inverted ones .vtu alone, for display.
  std::shared_ptr<const HexMesh> hexahedra = {};

  /// Whether hexahedra are written in all formats even if some are inverted, which solvers take for sound.
  bool inverted_hexahedra = false;

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

/// Of a field that processes share (whole_of_parts): all call it together, each writes a file
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

/// Files of hexahedra in the folder of a field from which `read_hexahedra` reads: the second of a partial
/// mesh. A folder has one of them at most.
inline constexpr const char* kHexahedraFile = "hexahedra.vtu";
inline constexpr const char* kPartialHexahedraFile = "hexahedra.partial.vtu";

/// Reads the hexahedra in the folder of a result (OutputOptions::hexahedra), whole or partial, with the unit
/// of its report; or a file of any mesher. The extension, in either case, names the format: Medit (.mesh in
/// text, .meshb in binary), Gmsh (.msh, version 2 or 4.1), VTK (.vtk, .vtu) or an input file of Abaqus and
/// CalculiX
/// (.inp), in text or binary; each of them may be packed by gzip (.msh.gz).
///
/// What `write_hexahedra` has written to a .vtu file is restored to the bit but for the unit, which no file
/// tells. Of other files vertices of no hexahedron are left out; meshes of left-handed hexahedra are turned
/// right-handed, and hexahedra of higher order read by their corners, both with a warning. Regions are
/// reference numbers (Medit), physical groups or else entities (Gmsh), an array of cell data (VTK) or sets
/// (.inp), as for `read_tets`; faces of the boundary have the tags of the quads that the file lists on them.
///
/// Throws Error(kInput) naming the file, the place in it and the remedy; also for files without hexahedra or
/// with other solid elements, and for a folder without hexahedra.
HexMesh read_hexahedra(const std::filesystem::path& path);

/// Default name of the file that `crossgrain streamlines` writes to the folder of a field.
inline constexpr const char* kStreamlinesFile = "streamlines.vtu";

/// Returns SolveReport::Model::path of the field in a folder; none if the folder has no readable report.
std::optional<std::string> model_of_result(const std::filesystem::path& folder);

/// Returns the report in the folder of a result, without reading the field. Throws Error(kInput).
SolveReport report_of_result(const std::filesystem::path& folder);

/// Returns SolveReport::solve that all files of a result name; empty if they name none. Finishes an
/// interrupted `write_field` first. Throws Error(kInput), naming two files, if they are of different solves,
/// and if there is no such folder.
std::string solve_of_result(const std::filesystem::path& folder);

/// Returns the names of the files that `write_field` writes with these options for a field on a grid or, with
/// `on_tets`, on tets; report.json comes last.
std::vector<std::string> result_files(const OutputOptions& options = {}, bool on_tets = false);

/// The same for the field of a report, with the hexahedra that it is about instead of those of the options.
std::vector<std::string> result_files(OutputOptions options, const SolveReport& report);

/// Throws Error(kOutput) if `write_field` could not or, because of foreign files, would not write to a
/// folder, and if another one is about to. Returns the sole right to do so; when that goes unused, nothing of
/// it is left. Call before a solve to fail early.
std::shared_ptr<FolderReservation> check_field_folder(const std::filesystem::path& folder,
                                                      const OutputOptions& options = {});

/// Checks the folder for a field on tets.
std::shared_ptr<FolderReservation> check_onto_folder(const std::filesystem::path& folder,
                                                     const OutputOptions& options = {});

/// Reads the lines that `write_streamlines` has written. Throws Error(kInput).
std::vector<AxisCurve> read_streamlines(const std::filesystem::path& path);

/// Reads the singular graph of the whole field from singularities.vtu or onto_singularities.vtu, without the
/// numbers of edges and loops, which are in the report. Throws Error(kInput).
SingularityGraph read_singularities(const std::filesystem::path& path);

/// @}

}  // namespace crossgrain
