// SPDX-License-Identifier: Apache-2.0
// Writes and reads a field as a folder of files. A few arrays define the field; they are stored as field
// data, and only they are read. What ParaView shows (axes, coefficients, ...) is derived from them.
#include "io/result/field_file.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/system_memory.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/io.hpp"
#include "field/field_data.hpp"
#include "files/output_folder.hpp"
#include "harmonics/deviation.hpp"
#include "harmonics/frame.hpp"
#include "io/json/json_file.hpp"
#include "io/result/field_arrays.hpp"
#include "io/result/foreign_files.hpp"
#include "io/result/leaf_corners.hpp"
#include "io/result/output_cells.hpp"
#include "io/result/report_file.hpp"
#include "io/result/result_files.hpp"
#include "io/result/singularity_file.hpp"
#include "io/result/solve_id.hpp"
#include "io/result/surface_file.hpp"
#include "io/result/tet_files.hpp"
#include "io/vtu/vtu_arrays.hpp"
#include "io/vtu/vtu_reader.hpp"
#include "io/vtu/vtu_writer.hpp"

namespace crossgrain {
namespace {

/// Returns a cell array of `components` floats; value_of(frame) returns any sequence of that many numbers.
template <class ValueOf>
VtuArray frame_array(const FieldData& data, const char* name, std::size_t components,
                     const ValueOf& value_of) {
  return float_array(VtuSection::kCellData, name, components, data.frames.size(),
                     [&data, value_of](std::size_t i) { return value_of(from_stored(data.frames[i])); });
}

/// Returns the coefficients of a frame in single precision, as in the file.
template <int D>
Coefficients<D> written_coefficients(const Quaternion& frame) {
  Coefficients<D> h = frame_coefficients<D>(frame);
  for (double& value : h) value = static_cast<float>(value);
  return h;
}

template <int D>
void add_coefficients(const FieldData& data, std::vector<VtuArray>& arrays) {
  arrays.push_back(frame_array(data, "coefficients", kCoefficientCount<D>, written_coefficients<D>));
  arrays.push_back(frame_array(data, "deviation", 1, [](const Quaternion& frame) {
    return std::array{deviation<D>(written_coefficients<D>(frame))};
  }));
}

VtuArray constraint_array(const std::vector<CellConstraint>& constraints) {
  return vtu_array<std::uint8_t>(VtuSection::kCellData, field_arrays::kConstraint, 1, constraints.size(),
                                 [&constraints](std::size_t begin, std::size_t end, std::uint8_t* out) {
                                   for (std::size_t i = begin; i < end; ++i)
                                     *out++ = static_cast<std::uint8_t>(constraints[i]);
                                 });
}

/// Adds the cell data of docs/design.md section 10.
void add_cell_data(const FieldData& data, std::vector<VtuArray>& arrays) {
  add_axes(
      VtuSection::kCellData, data.frames.size(),
      [&data](std::size_t i) { return from_stored(data.frames[i]); }, arrays);
  if (data.degree == Degree::kThree)
    add_coefficients<3>(data, arrays);
  else
    add_coefficients<4>(data, arrays);
  arrays.push_back(stored_array(VtuSection::kCellData, field_arrays::kEnergyDensity, data.energy_density));
  arrays.push_back(stored_array(VtuSection::kCellData, field_arrays::kAlignment, data.alignment_deg));
  const auto& leaves = data.tree.leaves();
  arrays.push_back(vtu_array<std::uint8_t>(VtuSection::kCellData, "level", 1, leaves.size(),
                                           [&leaves](std::size_t begin, std::size_t end, std::uint8_t* out) {
                                             for (std::size_t i = begin; i < end; ++i)
                                               *out++ = static_cast<std::uint8_t>(leaves[i].depth());
                                           }));
  arrays.push_back(stored_array(VtuSection::kCellData, field_arrays::kOnBoundary, data.on_boundary));
  if (!data.constraints.empty()) arrays.push_back(constraint_array(data.constraints));
  if (!data.regions.empty())
    arrays.push_back(stored_array(VtuSection::kCellData, field_arrays::kRegion, data.regions));
}

template <class Index>
void add_cells(const LeafCorners& corners, std::size_t cells, std::vector<VtuArray>& arrays) {
  arrays.push_back(vtu_array<Index>(VtuSection::kCells, "connectivity", 1, 8 * cells,
                                    [&corners](std::size_t begin, std::size_t end, Index* out) {
                                      corners.write_indices(begin, end, out);
                                    }));
  add_uniform_cells<Index>(cells, 8, kVtkVoxel, arrays);
}

void add_grid(const LeafCorners& corners, std::size_t cells, std::vector<VtuArray>& arrays) {
  arrays.push_back(vtu_array<double>(VtuSection::kPoints, "Points", 3, corners.size(),
                                     [&corners](std::size_t begin, std::size_t end, double* out) {
                                       corners.write_positions(begin, end, out);
                                     }));
  if (fits_32_bits(corners.size(), 8 * cells))
    add_cells<std::int32_t>(corners, cells, arrays);
  else
    add_cells<std::int64_t>(corners, cells, arrays);
}

void add_field_data(const FieldData& data, std::vector<VtuArray>& arrays) {
  const RootCube& root = data.tree.root();
  arrays.push_back(constant_array<std::uint32_t>(field_arrays::kSchema, {field_arrays::kSchemaNumber}));
  arrays.push_back(
      constant_array<std::uint32_t>(field_arrays::kDegree, {static_cast<std::uint32_t>(data.degree)}));
  arrays.push_back(constant_array<double>(field_arrays::kRootCube,
                                          {root.origin[0], root.origin[1], root.origin[2], root.size}));
  const auto& leaves = data.tree.leaves();
  arrays.push_back(
      vtu_array<std::uint64_t>(VtuSection::kFieldData, field_arrays::kCellAddress, 1, leaves.size(),
                               [&leaves](std::size_t begin, std::size_t end, std::uint64_t* out) {
                                 for (std::size_t i = begin; i < end; ++i) *out++ = leaves[i].packed();
                               }));
  arrays.push_back(vtu_array<float>(
      VtuSection::kFieldData, field_arrays::kFrame, 4, data.frames.size(),
      [&data](std::size_t begin, std::size_t end, float* out) {
        for (std::size_t i = begin; i < end; ++i) {
          const StoredQuaternion& q = data.frames[i];
          for (const float part : {q.w, q.x, q.y, q.z}) *out++ = part;
        }
      },
      VtuPacking::kMeasured));
  arrays.push_back(stored_array(VtuSection::kFieldData, field_arrays::kOpenFaces, data.open_faces));
}

/// Adds which part of the field the file holds, if not all of it.
void add_extent(const OutputOptions& options, std::vector<VtuArray>& arrays) {
  if (options.level)
    arrays.push_back(constant_array<std::uint32_t>(field_arrays::kOutputLevel,
                                                   {static_cast<std::uint32_t>(*options.level)}));
  if (options.clip) {
    const auto& [low, high] = *options.clip;
    arrays.push_back(
        constant_array<double>(field_arrays::kClipBox, {low[0], low[1], low[2], high[0], high[1], high[2]}));
  }
}

void write_field_file(const FieldData& data, const OutputOptions& options, OutputFile& file,
                      const Monitor& monitor) {
  const LeafCorners corners(data.tree);
  std::vector<VtuArray> arrays;
  add_field_data(data, arrays);
  add_extent(options, arrays);
  add_cell_data(data, arrays);
  add_grid(corners, data.tree.size(), arrays);
  watch(arrays, monitor);
  write_vtu(file, corners.size(), data.tree.size(), arrays);
  file.finish();
}

/// Writes the cells that the options select. If none meets the clip box, writes all cells and adds a warning
/// to the report.
void write_chosen_cells(const FieldData& data, OutputOptions options, OutputFile& file, SolveReport& report,
                        const Monitor& monitor) {
  if (ask_for_all(options, data.tree)) return write_field_file(data, options, file, monitor);
  FieldData part = output_cells(data, options, monitor);
  if (part.tree.size() == 0) {
    report.warnings.emplace_back(WarningKind::kClipMissed,
                                 "no cell touches the clip box, so field.vtu contains all cells");
    options.clip.reset();
    return write_chosen_cells(data, options, file, report, monitor);
  }
  write_field_file(part, options, file, monitor);
}

bool is_companion(const std::string& name, const OutputOptions& options) {
  const auto has_name = [&](const CompanionFile& file) { return file.name == name; };
  return std::any_of(options.companions.begin(), options.companions.end(), has_name);
}

}  // namespace

std::shared_ptr<FolderReservation> check_field_folder(const std::filesystem::path& folder,
                                                      const OutputOptions& options) {
  auto reservation = reserve_writable(folder, result_files(options));
  check_foreign_files(folder, options);
  return reservation;
}

SolveReport write_field_and(const FrameField& field, SolveReport report, const std::filesystem::path& folder,
                            const Monitor& monitor, const OutputOptions& options, const std::string& solve,
                            const std::function<void(OutputFolder&, SolveReport&)>& add_files) {
  check_output_options(options);
  check_formats(options.formats);
  auto reservation = options.reservation ? options.reservation : std::make_shared<FolderReservation>(folder);
  if (reservation->name() != folder.string())
    throw Error(ErrorKind::kUsage, "the folder '" + reservation->name() + "' is reserved, not this one");
  OutputFolder output(std::move(reservation));
  check_foreign_files(folder, options);
  Stopwatch stopwatch;
  stopwatch.start();
  report.solve = solve;
  output.set_solve(solve);
  std::vector<CompanionFile::Writer> companions;
  run_side_by_side(
      [&] {
        write_chosen_cells(field.data(), options, output.create(kFieldFile), report, monitor);
        write_singularities(output.create(kSingularityFile), field.singularities(), monitor);
        if (const auto surface = field.data().surface.get())
          write_surface(output.create(kSurfaceFile), *surface, monitor);
        else
          output.remove_at_commit(kSurfaceFile);
        report.unmarked_files.clear();
        add_files(output, report);
      },
      [&] {
        for (const CompanionFile& companion : options.companions)
          companions.push_back(companion.prepare(monitor));
      });
  list_companions(options, report);
  std::vector<std::string> earlier = companions_in(folder);
  earlier.insert(earlier.end(), {kStreamlinesFile, kPageFile});
  for (const std::string& name : earlier)
    if (!is_companion(name, options)) output.remove_at_commit(name);
  report.seconds.write = stopwatch.restart();
  report.seconds.total += report.seconds.write;
  report.peak_memory_bytes = std::max(report.peak_memory_bytes, peak_memory_bytes());
  warn_of_numbers_not_finite(report);
  output.create(kReportFile).write(report_json(report));
  for (std::size_t k = 0; k < companions.size(); ++k) {
    OutputFile& file = output.create(options.companions[k].name);
    companions[k](report, [&](std::string_view bytes) { file.write(bytes); });
  }
  monitor.check();
  output.commit();
  return report;
}

SolveReport write_field(const FrameField& field, SolveReport report, const std::filesystem::path& folder,
                        const Monitor& monitor, const OutputOptions& options) {
  if (!options.formats.empty())
    throw Error(ErrorKind::kUsage,
                "'" + options.formats.front() + "' is a format of fields on tets, and this field has none");
  // The report of a field read from a folder may contain results on tets, and files of an earlier field on
  // tets would seem to belong to this one.
  report.onto.reset();
  return write_field_and(field, std::move(report), folder, monitor, options, solve_id(field.data(), options),
                         [](OutputFolder& output, SolveReport&) {
                           for (const TetFile& file : tet_files()) output.remove_at_commit(file.name);
                         });
}

SolveReport write_field(const FrameField& field, const std::filesystem::path& folder, const Monitor& monitor,
                        const OutputOptions& options) {
  return write_field(field, field.report(), folder, monitor, options);
}

FrameField read_field(const std::filesystem::path& folder) {
  return read_one_solve(folder, [&] {
    auto data = std::make_shared<FieldData>(read_field_arrays(folder / kFieldFile));
    data->report = read_report(folder / kReportFile);
    check_listed_sizes(folder, data->report);
    data->surface = surface_in(folder / kSurfaceFile);
    return FrameField(std::move(data));
  });
}

bool is_clipped_field(const std::filesystem::path& folder) {
  complete_folder(folder);
  return VtuFile(folder / kFieldFile).find(VtuSection::kFieldData, field_arrays::kClipBox) != nullptr;
}

}  // namespace crossgrain
