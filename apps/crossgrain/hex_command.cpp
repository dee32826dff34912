// SPDX-License-Identifier: Apache-2.0
#include "hex_command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "crossgrain/error.hpp"
#include "crossgrain/message.hpp"
#include "crossgrain/page.hpp"
#include "crossgrain/place.hpp"
#include "fit_command.hpp"
#include "messages.hpp"
#include "output.hpp"
#include "summary.hpp"

namespace crossgrain::app {
namespace {

/// Rows about corners and knife edges of the model that leave room for no hexahedra along its first field:
/// later attempts may fill the model all the same, then with poor hexahedra there as a rule.
std::string risk_lines(const Answer& answer) {
  std::string lines;
  for (const Answer::Reason& reason : answer.reasons) {
    const bool is_of_surface = reason.kind == ReasonKind::kKnifeEdge || reason.kind == ReasonKind::kCorner;
    if (!is_of_surface || reason.verdict != Verdict::kNotMeshable) continue;
    lines += fmt::format("risk       poor hexahedra, or no mesh, at {}", words_of_place(reason.place));
    if (reason.count > 1) lines += fmt::format(" and at {}", counted(reason.count - 1, "other place"));
    lines += fmt::format(": along the first field {}\n", reason.text);
  }
  return lines;
}

/// The best mesh that there was at a stop, as the message about it says.
std::string best_text(const HexReport& report) {
  return fmt::format("the best mesh so far, {}, {}", counted(report.hexahedra, "hexahedron", "hexahedra"),
                     name_of(report.outcome));
}

std::shared_ptr<const Hexahedra> or_best_so_far(const Job& job, const HexMeshingOptions& options) {
  try {
    auto made = std::make_shared<const Hexahedra>(
        make_hexahedra(std::filesystem::path(job.arguments.model), options, job.monitor));
    if (made->report().is_stopped) {
      job.leave_line();
      announce_stop(best_text(made->report()));
    }
    return made;
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kInterrupted || job.monitor.cancelled()) throw;
    throw Error(ErrorKind::kInterrupted, "interrupted before there was a mesh; nothing is written");
  }
}

/// The options, with what is said while hexahedra are made.
HexMeshingOptions heard_options(const Job& job) {
  HexMeshingOptions options = hex_options(job.arguments);
  options.on_warning = job.warn;
  options.on_expected = [&job](const HexExpectation& expected) {
    if (job.arguments.quiet) return;
    if (job.lines != nullptr) job.lines->expect(expected);
    job.leave_line();
    print_result(row("expected", sentence_of(expected)));
  };
  options.on_answer = [&job](const Answer& answer) {
    const std::string lines = risk_lines(answer);
    if (job.arguments.quiet || lines.empty()) return;
    job.leave_line();
    print_result(lines);
  };
  options.on_attempt_end = [&job](const HexAttemptEnd& end) {
    if (job.lines != nullptr) job.lines->end_attempt(end);
  };
  return options;
}

/// Writes hexahedra without a field.
SolveReport write_alone(const Job& job, const std::shared_ptr<FolderReservation>& reservation,
                        FittedHexahedra fitted) {
  if (fitted.hexahedra().is_stopped) {
    job.leave_line();
    announce_stop(best_text(fitted.hexahedra()));
  }
  announce_replaced(job);
  job.monitor.report({Phase::kWrite, 0, 0, 0, 0});
  fitted.report.seconds.total = seconds_since(job.start);
  OutputOptions options = output_options_for(job, reservation);
  options.formats.clear();  // these are for fields on tets
  if (job.arguments.page) options.companion = page_of(fitted);
  return write_fitted(fitted, job.arguments.output, job.monitor, options);
}

}  // namespace

std::shared_ptr<const Hexahedra> made_hexahedra(const Job& job) {
  return or_best_so_far(job, heard_options(job));
}

SolveReport fit_and_write(const Job& job, const std::shared_ptr<FolderReservation>& reservation) {
  job.monitor.report({Phase::kRead, 0, 0, 0, 0});
  return write_alone(job, reservation,
                     job.arguments.lattice ? lattice_mesh(job.arguments, heard_options(job), job.monitor)
                                           : fitted_mesh(job.arguments, job.warn, job.monitor));
}

SolveReport lattice_and_write(const Job& job, const std::shared_ptr<FolderReservation>& reservation,
                              const Error& error) {
  FittedHexahedra made = lattice_mesh_without_tets(error, job.arguments, heard_options(job), job.monitor);
  if (!job.arguments.output_options.formats.empty()) {
    job.leave_line();
    print_message(
        "warning: no file of a field or a map is written, since there are only hexahedra of a lattice");
  }
  return write_alone(job, reservation, std::move(made));
}

void leave_out_maps(const Job& job, OutputOptions& options) {
  const auto is_of_map = [](const std::string& name) { return name == "hexex" || name == "map"; };
  if (std::erase_if(options.formats, is_of_map) == 0) return;
  job.leave_line();
  print_message(
      "warning: no file of a map is written, since these are hexahedra of a lattice; see --map-only");
}

}  // namespace crossgrain::app
