// SPDX-License-Identifier: Apache-2.0
#include "results/onto_files.hpp"

#include <fmt/format.h>

#include <cassert>
#include <string>
#include <vector>

#include "crossgrain/error.hpp"
#include "crossgrain/result_folder.hpp"
#include "results/field_file.hpp"
#include "results/foreign_files.hpp"
#include "results/solve_id.hpp"
#include "results/tet_files.hpp"
#include "solve/tet_domain_data.hpp"

namespace crossgrain {
namespace {

/// Other programs match these files to the mesh file by its number of tets.
void warn_of_left_out_tets(const TetSolid& solid, const OutputOptions& options, SolveReport& report) {
  std::vector<std::string> names;
  for (const TetFile& file : tet_files())
    if (file.has_rows_of_tets && is_asked_for(file, options.formats)) names.push_back(file.name);
  const bool is_of_file = !report.onto || !report.onto->prepared;
  if (names.empty() || solid.left_out_tets == 0 || !is_of_file) return;
  const std::size_t tets = solid.mesh.tets.size();
  report.warnings.emplace_back(
      WarningKind::kLeftOutTets,
      fmt::format("tets left out: {} of {}; {} number the other {}, as onto.vtu does", solid.left_out_tets,
                  tets + solid.left_out_tets, fmt::join(names, ", "), tets),
      Remedy::kUseWrittenMesh);
}

void check_has_map(const TetOutput& output, const OutputOptions& options) {
  for (const TetFile& file : tet_files())
    if (file.is_of_map && output.map == nullptr && is_asked_for(file, options.formats))
      throw Error(ErrorKind::kUsage,
                  fmt::format("'{}' is a format of maps of hexahedra, and this field has none", file.format));
}

}  // namespace

SolveReport write_field_onto(const FrameField& field, SolveReport report, const TetOutput& output,
                             const std::filesystem::path& folder, const Monitor& monitor,
                             const OutputOptions& options) {
  assert(output.field.vertex_frames.size() == output.solid.mesh.vertices.size() &&
         output.field.tet_frames.size() == output.solid.mesh.tets.size());
  check_has_map(output, options);
  warn_of_left_out_tets(output.solid, options, report);
  return write_field_and(field, std::move(report), folder, monitor, options,
                         solve_id(field.data(), options, &output), [&](OutputFolder& files, SolveReport&) {
                           for (const TetFile& file : tet_files()) {
                             if (is_asked_for(file, options.formats))
                               file.write(files.create(file.name), output, monitor);
                             else
                               files.remove_at_commit(file.name);
                           }
                         });
}

SolveReport write_field(const TetFrameField& field, SolveReport report, const std::filesystem::path& folder,
                        const Monitor& monitor, const OutputOptions& options) {
  return write_field_onto(field.grid(), std::move(report),
                          {field.domain().data().solid, field.data(), field.singularities(), options.hex_size,
                           options.hex_map.get()},
                          folder, monitor, options);
}

SolveReport write_field(const TetFrameField& field, const std::filesystem::path& folder,
                        const Monitor& monitor, const OutputOptions& options) {
  return write_field(field, field.report(), folder, monitor, options);
}

std::shared_ptr<FolderReservation> check_onto_folder(const std::filesystem::path& folder,
                                                     const OutputOptions& options) {
  check_formats(options.formats);
  auto reservation = reserve_writable(folder, result_files(options, /*on_tets=*/true));
  check_foreign_files(folder, options, *reservation);
  return reservation;
}

}  // namespace crossgrain
