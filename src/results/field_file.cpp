// SPDX-License-Identifier: Apache-2.0
// Writes and reads a field as a folder of files.
#include "results/field_file.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/system_memory.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/writing.hpp"
#include "field/field_data.hpp"
#include "files/output_folder.hpp"
#include "mesh_files/hex/hex_writers.hpp"
#include "results/cell_file.hpp"
#include "results/field_arrays.hpp"
#include "results/field_pieces.hpp"
#include "results/foreign_files.hpp"
#include "results/one_solve.hpp"
#include "results/output_cells.hpp"
#include "results/report_file.hpp"
#include "results/result_files.hpp"
#include "results/singularity_file.hpp"
#include "results/solve_id.hpp"
#include "results/surface_file.hpp"
#include "results/tet_files.hpp"
#include "text/json_file.hpp"
#include "vtu/array_names.hpp"
#include "vtu/vtu_reader.hpp"

namespace crossgrain {
namespace {

/// Writes the cells that the options select. If none meets the clip box, writes all cells and adds a warning
/// to the report.
void write_chosen_cells(const FieldData& data, OutputOptions options, OutputFile& file, SolveReport& report,
                        const Monitor& monitor) {
  if (ask_for_all(options, data.tree)) return write_cell_file(data, options, file, monitor);
  FieldData part = output_cells(data, options, monitor);
  if (part.tree.size() == 0) {
    report.warnings.emplace_back(WarningKind::kClipMissed,
                                 "no cell touches the clip box, so field.vtu contains all cells");
    options.clip.reset();
    return write_chosen_cells(data, options, file, report, monitor);
  }
  write_cell_file(part, options, file, monitor);
}

}  // namespace

std::shared_ptr<FolderReservation> check_field_folder(const std::filesystem::path& folder,
                                                      const OutputOptions& options) {
  auto reservation = reserve_writable(folder, result_files(options));
  check_foreign_files(folder, options, *reservation);
  return reservation;
}

namespace {

/// Writes the files of hexahedra, and removes earlier ones.
void add_hexahedra(const OutputOptions& options, OutputFolder& output, const Monitor& monitor) {
  const std::vector<std::string> names = hexahedra_files(options);
  for (const std::string& name : all_hexahedra_file_names())
    if (std::find(names.begin(), names.end(), name) == names.end()) output.remove_at_commit(name);
  if (names.empty()) return;
  const HexOutput shown(*options.hexahedra);
  for (const std::string& name : names) write_hexahedra_file(output.create(name), shown, monitor);
}

/// Removes files of an earlier result, unless they are written again.
void remove_earlier(const std::filesystem::path& folder, OutputFolder& output) {
  for (const char* name : {kStreamlinesFile, kPageFile}) output.remove_at_commit(name);
  for (const std::string& name : pieces_in(folder)) output.remove_at_commit(name);
  // Companions have names that only the report knows.
  for (const std::string& name : listed_names_in(folder)) output.remove_at_commit(name);
}

/// Writes a folder; the cells by `write_cells`. By a field that processes share, these are called before all
/// else, since they exchange messages.
SolveReport write_folder(const FrameField& field, SolveReport report, const std::filesystem::path& folder,
                         const Monitor& monitor, const OutputOptions& options, const std::string& solve,
                         const AddFiles& write_cells, const AddFiles& add_files) {
  const bool is_shared = !field.data().share().is_whole();
  const auto add_all = [&](OutputFolder& output, SolveReport& written) {
    if (!is_shared) write_cells(output, written);
    write_singularities(output.create(kSingularityFile), field.singularities(), monitor);
    if (const auto surface = field.data().surface.get())
      write_surface(output.create(kSurfaceFile), *surface, monitor);
    else
      output.remove_at_commit(kSurfaceFile);
    add_files(output, written);
  };
  return write_result(std::move(report), folder, monitor, options, solve, add_all,
                      is_shared ? write_cells : AddFiles());
}

/// Writes a field that processes share; the first one writes all but their pieces. Returns its report there.
SolveReport write_parts(const FrameField& field, SolveReport report, const std::filesystem::path& folder,
                        const Monitor& monitor, const OutputOptions& options) {
  if (options.clip)
    throw Error(ErrorKind::kUsage, "the parts of a field cannot be clipped; gather it (whole_of_parts)");
  check_output_options(options);
  const std::string solve = solve_id(field.data(), options);
  std::optional<FieldData> merged;
  if (options.level) merged = merged_part(field.data(), options, monitor);
  const FieldData& cells = merged ? *merged : field.data();
  if (!cells.share().is_of_first()) {
    write_pieces(cells, options, nullptr, monitor);
    return report;
  }
  bool is_begun = false;
  const auto write_cells = [&](OutputFolder& output, SolveReport& written) {
    is_begun = true;
    written.files = write_pieces(cells, options, &output, monitor);
    output.remove_at_commit(kCellsFile);
  };
  try {
    return write_folder(field, std::move(report), folder, monitor, options, solve, write_cells,
                        remove_tet_files);
  } catch (...) {
    if (!is_begun) cancel_pieces(cells);
    throw;
  }
}

}  // namespace

SolveReport write_result(SolveReport report, const std::filesystem::path& folder, const Monitor& monitor,
                         const OutputOptions& options, const std::string& solve, const AddFiles& add_files,
                         const AddFiles& add_first) {
  check_output_options(options);
  check_formats(options.formats);
  auto reservation = options.reservation ? options.reservation : std::make_shared<FolderReservation>(folder);
  if (reservation->name() != folder.string())
    throw Error(ErrorKind::kUsage, "the folder '" + reservation->name() + "' is reserved, not this one");
  check_foreign_files(folder, options, *reservation, monitor);
  OutputFolder output(std::move(reservation));
  // What is made for a file on the way may sort millions of faces.
  const WatchedLoops watched(monitor, Stops::kIgnored);
  Stopwatch stopwatch;
  report.solve = solve;
  report.files.clear();
  output.set_solve(solve);
  CompanionFile::Writer companion;
  if (add_first) add_first(output, report);
  run_side_by_side(
      [&] {
        add_files(output, report);
        add_hexahedra(options, output, monitor);
      },
      [&] {
        if (options.companion) companion = options.companion->prepare(monitor);
      });
  remove_earlier(folder, output);
  report.seconds.write = stopwatch.restart();
  report.seconds.total += report.seconds.write;
  report.peak_memory_bytes = std::max(report.peak_memory_bytes, peak_memory_bytes());
  warn_of_numbers_not_finite(report);
  for (ResultInventory::File& file : output.created()) report.files.push_back(std::move(file));
  if (options.companion) {
    OutputFile& file = output.create(options.companion->name);
    companion(report, [&](std::string_view bytes) { file.write(bytes); });
    report.files.push_back(output.created().back());
  }
  output.create(kReportFile).write(sealed_report_json(report));
  monitor.check();
  output.commit();
  return report;
}

void remove_tet_files(OutputFolder& output, SolveReport&) {
  for (const TetFile& file : tet_files()) output.remove_at_commit(file.name);
}

SolveReport write_field_and(const FrameField& field, SolveReport report, const std::filesystem::path& folder,
                            const Monitor& monitor, const OutputOptions& options, const std::string& solve,
                            const AddFiles& add_files) {
  const auto write_cells = [&](OutputFolder& output, SolveReport& written) {
    write_chosen_cells(field.data(), options, output.create(kCellsFile), written, monitor);
    output.remove_at_commit(kPiecesFile);
  };
  return write_folder(field, std::move(report), folder, monitor, options, solve, write_cells, add_files);
}

SolveReport write_field(const FrameField& field, SolveReport report, const std::filesystem::path& folder,
                        const Monitor& monitor, const OutputOptions& options) {
  if (!options.formats.empty())
    throw Error(ErrorKind::kUsage,
                "'" + options.formats.front() + "' is a format of fields on tets, and this field has none");
  // The report of a field read from a folder may contain results on tets.
  report.onto.reset();
  if (!field.data().share().is_whole())
    return write_parts(field, std::move(report), folder, monitor, options);
  return write_field_and(field, std::move(report), folder, monitor, options, solve_id(field.data(), options),
                         remove_tet_files);
}

SolveReport write_field(const FrameField& field, const std::filesystem::path& folder, const Monitor& monitor,
                        const OutputOptions& options) {
  return write_field(field, field.report(), folder, monitor, options);
}

FrameField read_field(const std::filesystem::path& folder) {
  return read_one_solve(folder, [&] {
    auto data = std::make_shared<FieldData>(read_field_arrays(cell_files(folder)));
    data->report = read_report(folder / kReportFile);
    check_listed_sizes(folder, data->report);
    data->surface = surface_in(folder / kSurfaceFile);
    return FrameField(std::move(data));
  });
}

bool is_clipped_field(const std::filesystem::path& folder) {
  complete_folder(folder);
  return VtuFile(cell_files(folder).front()).find(VtuSection::kFieldData, field_arrays::kClipBox) != nullptr;
}

}  // namespace crossgrain
