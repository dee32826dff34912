// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/page.hpp"
#include "crossgrain/read_limits.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/repair.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/tet_making.hpp"
#include "crossgrain/thread_limit.hpp"
#include "hex_command.hpp"
#include "interruption.hpp"
#include "job.hpp"
#include "messages.hpp"
#include "output.hpp"
#include "output_places.hpp"
#include "progress_lines.hpp"
#include "results/result_files.hpp"
#include "solve/tuned_solve.hpp"
#include "summary.hpp"

namespace crossgrain::app {
namespace {

/// No mesh of hexahedra fills the model; one does, but not as it should.
constexpr int kPartialHex = 6, kApproximateHex = 7;

int exit_code_after(HexOutcome outcome, bool accepts_approximate) {
  if (is_partial(outcome)) return kPartialHex;
  return outcome == HexOutcome::kAllHex || accepts_approximate ? 0 : kApproximateHex;
}

int exit_code_after(const SolveReport& report, bool accepts_approximate) {
  const bool is_stopped = report.hexahedra && report.hexahedra->is_stopped;
  if (report.unfinished || is_stopped) return exit_code_of(ErrorKind::kInterrupted);
  if (report.hexahedra)
    if (const int code = exit_code_after(report.hexahedra->outcome, accepts_approximate); code != 0)
      return code;
  const auto& warnings = report.warnings;
  return std::any_of(warnings.begin(), warnings.end(), is_unsettled) ? exit_code_of(ErrorKind::kLimit) : 0;
}

/// Prints a warning, unless it is among those that were printed: what was said of the model before the work
/// is in the report too.
void print_warning(Warning warning, const SolveArguments& arguments, std::set<std::string>& printed) {
  if (warning.file.empty()) warning.file = arguments.model;
  const std::string line = line_of(warning, arguments);
  if (printed.insert(line).second) print_message("warning: " + line);
}

TetMesh tets_of_file(const std::string& file, const Job& job) {
  TetMesh mesh = read_tets(file);
  if (job.arguments.unit != LengthUnit::kUnknown) mesh.unit = name_of(job.arguments.unit);
  // With --onto the model is the surface.
  job.tell(job.arguments.onto.empty() ? "model" : "onto", summary_of(mesh));
  return mesh;
}

TetMesh made_tets(const SolveArguments& arguments, const Monitor& monitor) {
  TetMakingOptions options;
  options.size = arguments.tet_size;
  options.crease_angle_deg = arguments.options.crease_angle_deg;
  options.max_memory_bytes = arguments.options.max_memory_bytes;
  options.read_seconds = arguments.read_seconds;
  options.glue = arguments.glue;
  options.unit = arguments.unit;
  return make_tets(std::filesystem::path(arguments.model), options, monitor);
}

/// Returns the tet mesh given as MODEL or with --onto, or made of MODEL; none otherwise.
std::optional<TetDomain> read_domain(const Job& job) {
  const SolveArguments& arguments = job.arguments;
  const std::string& file = arguments.onto.empty() ? arguments.model : arguments.onto;
  if (!solves_tets(arguments) && arguments.onto.empty()) return std::nullopt;
  TetMesh mesh = arguments.makes_tets ? made_tets(arguments, job.monitor) : tets_of_file(file, job);
  for (const Warning& warning : mesh.warnings) job.warn(warning);
  return naming(file, [&] {
    const TetDomain domain(std::move(mesh), arguments.tags);
    return arguments.prepare ? domain.prepared_for_map({.unite_solids = arguments.options.unite_solids})
                             : domain;
  });
}

Box bounds_of(const std::vector<Vector3>& points) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (const Vector3& point : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], point[axis]);
      box.high[axis] = std::max(box.high[axis], point[axis]);
    }
  }
  return box;
}

double longest_side(const std::vector<Vector3>& points) {
  const auto [low, high] = bounds_of(points);
  return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2], 0.0});
}

/// Throws if the box of --clip lies outside the model, before the solve.
void check_clip(const SolveArguments& arguments, const TriangleMesh& mesh) {
  if (!arguments.output_options.clip || mesh.vertices.empty()) return;
  const Box &clip = *arguments.output_options.clip, model = bounds_of(mesh.vertices);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (clip.low[axis] <= model.high[axis] && model.low[axis] <= clip.high[axis]) continue;
    throw Error(
        ErrorKind::kUsage,
        {arguments.model, "",
         fmt::format("reaches from {:.6g} to {:.6g} along {}, outside the box of --clip; give the box in the "
                     "model's unit",
                     model.low[axis], model.high[axis], "xyz"[axis])});
  }
}

/// Throws if the sizes differ so much that the units probably do, which gives a wrong field or a grid beyond
/// any memory.
void check_same_unit(const SolveArguments& arguments, const TriangleMesh& surface, const TetDomain& domain) {
  constexpr double kMostTimes = 5;  // the tets may fill only part of the solid
  const double size = longest_side(surface.vertices), tets_size = longest_side(domain.boundary().vertices);
  if (std::max(size, tets_size) <= kMostTimes * std::min(size, tets_size)) return;
  throw Error(ErrorKind::kInput, {arguments.onto, "",
                                  fmt::format("the tets are {:.3g} across, the surface {} is {:.3g}",
                                              tets_size, arguments.model, size),
                                  Remedy::kMatchUnits});
}

GridField solve_alone(const FrameField* earlier, const TriangleMesh& mesh, const SolveTuning& options,
                      const Monitor& monitor) {
  const FrameField field =
      earlier == nullptr ? solve(mesh, options, monitor) : solve_from(*earlier, mesh, options, monitor);
  return {field, field};
}

std::string expected_line(const Expectation& expected) {
  return fmt::format("expected   {:.3g} million cells, {:.3g} GB of memory, {:.3g} s in all\n",
                     static_cast<double>(expected.active_cells) / 1e6,
                     static_cast<double>(expected.peak_memory_bytes) / 1e9, expected.seconds);
}

/// Throws if the initial field was clipped, because cells outside it would have poor initial frames.
void check_start(const SolveArguments& arguments) {
  if (arguments.from.empty() || !is_clipped_field(arguments.from)) return;
  throw Error(
      ErrorKind::kInput,
      {arguments.from, "", "holds only part of a field; start from one that was written without --clip"});
}

ReadOptions read_options(const SolveArguments& arguments, const SolveOptions& options) {
  ReadOptions result = read_options_for(options);
  result.read_seconds = arguments.read_seconds;
  result.glue = arguments.glue;
  result.unit = arguments.unit;
  return result;
}

struct Inputs {
  SolveOptions options;  ///< with the constraints
  std::optional<TetDomain> domain;
  TriangleMesh mesh;
};

/// Reads and checks all files but the field of --from.
Inputs read_inputs(const Job& job) {
  const SolveArguments& arguments = job.arguments;
  const ReadLimits limits(job.monitor, arguments.options.max_memory_bytes);
  check_start(arguments);
  Inputs inputs{arguments.options, {}, {}};
  inputs.options.for_page = arguments.page;
  if (!arguments.constraints.empty()) inputs.options.constraints = read_constraints(arguments.constraints);
  inputs.domain = read_domain(job);
  if (inputs.domain && arguments.repair)
    naming(arguments.onto.empty() ? arguments.model : arguments.onto,
           [&] { check_repairable(*inputs.domain); });
  if (solves_tets(arguments)) {
    inputs.mesh = inputs.domain->boundary();
  } else {
    const SolveOptions sized = inputs.domain ? sized_for(*inputs.domain, inputs.options) : inputs.options;
    inputs.mesh = read_surface(arguments.model, read_options(arguments, sized), job.monitor);
  }
  for (const Warning& warning : inputs.mesh.warnings) job.warn(warning);
  if (!arguments.onto.empty()) check_same_unit(arguments, inputs.mesh, *inputs.domain);
  check_clip(arguments, inputs.mesh);
  return inputs;
}

/// What was read, solved, and made of it.
struct Solved {
  double read_seconds = 0;
  bool has_tets = false;
  GridField to_write;
  std::optional<TetFrameField> tet_field;
  std::shared_ptr<const Hexahedra> made;
};

/// Throws what reading a model says that is none. That comes before what its folder is called: of plate.png
/// or plate.hexahedra the default one belongs to another model.
void check_is_model(const std::string& model) {
  if (may_be_model(model)) return;
  if (is_tet_file(model))
    read_tets(model);
  else
    read_surface(model);
}

/// Makes hexahedra of the model.
Solved meshed(const Job& job) {
  const auto made = made_hexahedra(job);
  const FrameField& grid = made->field.grid();
  return {made->field.report().seconds.read, true, {grid, grid}, made->field, made};
}

/// Solves, and transfers the field to the tets if there are any, unless a stop comes before that is complete.
Solved solve_inputs(const Job& job, const Inputs& inputs) {
  const auto& [arguments, on_grid, monitor, warn, tell, lines, begun] = job;
  const auto& [options, domain, mesh] = inputs;
  Solved result;
  result.has_tets = domain.has_value();
  std::optional<FrameField> earlier = naming(arguments.model, [&]() -> std::optional<FrameField> {
    if (arguments.from.empty()) return std::nullopt;
    const ReadLimits limits(monitor, options.max_memory_bytes);
    return read_field(arguments.from);
  });
  bool is_stopped = false;
  OntoStart start{solves_tets(arguments) ? nullptr : &mesh, earlier ? &*earlier : nullptr, {}};
  start.solve = [&](const FrameField* from, const TriangleMesh& surface, const SolveTuning& sized,
                    const Monitor& heard) {
    result.to_write = naming(arguments.model, [&] { return on_grid(from, surface, sized, heard); });
    earlier.reset();  // makes room
    is_stopped = heard.stopped();
    if (domain && !is_stopped) Interruption::set_has_field(false);
    return result.to_write.cells;
  };
  if (!domain) {
    start.solve(start.earlier, mesh, SolveTuning(options), monitor);
    return result;
  }
  try {
    result.tet_field = naming(arguments.onto.empty() ? arguments.model : arguments.onto, [&] {
      std::optional<TetFrameField> on_tets = solve_onto(*domain, start, SolveTuning(options), monitor);
      const RepairOptions repair{.max_memory_bytes = options.max_memory_bytes};
      return on_tets && arguments.repair ? repaired(*on_tets, repair, monitor) : on_tets;
    });
  } catch (const Error& error) {
    const bool has_grid = result.to_write.cells.has_value();
    if (error.kind() != ErrorKind::kInterrupted || monitor.cancelled() || !has_grid) throw;
    if (is_stopped) return result;
    job.leave_line();
    announce_stop(fmt::format("the field on the grid, {}, and none on the tets",
                              cells_text(result.to_write.cells->size())));
  }
  return result;
}

/// Reads, solves, and transfers the field to the tets if there are any.
Solved solved(const Job& job) {
  const Inputs inputs = read_inputs(job);
  const double read_seconds = seconds_since(job.start);
  job.monitor.check_stop();
  Solved result = solve_inputs(job, inputs);
  result.read_seconds = read_seconds;
  return result;
}

/// Solves, transfers the field to the tets if there are any, and writes all files.
SolveReport solve_and_write(const Job& job, const std::shared_ptr<FolderReservation>& reservation) {
  const SolveArguments& arguments = job.arguments;
  const Monitor& monitor = job.monitor;
  monitor.report({Phase::kRead, 0, 0, 0, 0});
  const auto [read_seconds, has_tets, to_write, tet_field, made] =
      arguments.hexahedra ? meshed(job) : solved(job);
  const FrameField& field = to_write.cells.value();
  announce_replaced(job);

  monitor.report({Phase::kWrite, 0, 0, 0, 0});
  OutputOptions output_options = output_options_for(job, reservation);
  if (made) {
    output_options.hexahedra = {made, &made->mesh};
    if (made->map.tets.empty())
      leave_out_maps(job, output_options);
    else
      output_options.hex_map = {made, &made->map};
  }
  if (arguments.page)
    output_options.companion =
        tet_field ? page_of(*tet_field, output_options.hexahedra) : page_of(to_write.shown.value());
  SolveReport report = tet_field ? tet_field->report() : field.report();
  report.model.path = arguments.model;
  report.seconds.read = read_seconds;
  report.seconds.total = seconds_since(job.start);
  if (report.expected) {
    // The library's clock starts after reading.
    report.expected->after_seconds += read_seconds;
    report.expected->seconds += read_seconds;
  }
  if (tet_field) return write_field(*tet_field, report, arguments.output, monitor, output_options);
  output_options.formats.clear();  // these are for fields on tets
  if (has_tets) mark_tets_missing(report);
  return write_field(field, report, arguments.output, monitor, output_options);
}

/// As solve_and_write; `hex` makes a lattice where no tets can be made.
SolveReport solve_or_fill(const Job& job, const std::shared_ptr<FolderReservation>& reservation) {
  try {
    return solve_and_write(job, reservation);
  } catch (const Error& error) {
    if (!job.arguments.hexahedra) throw;
    return lattice_and_write(job, reservation, error);
  }
}

}  // namespace

void help_solve(const SolveArguments& arguments, const SolveOnGrid& together) {
  const ThreadLimit thread_limit(arguments.options.threads);
  const Monitor monitor;
  const Job job{arguments, together, monitor};
  const Solved result = solve_inputs(job, read_inputs(job));
  OutputOptions output_options = arguments.output_options;
  output_options.formats.clear();
  if (const auto& cells = result.to_write.cells)
    write_field(*cells, cells->report(), arguments.output, monitor, output_options);
}

int run_solve(const SolveArguments& arguments, const SolveOnGrid& together) {
  const auto start = Clock::now();
  const ThreadLimit thread_limit(arguments.options.threads);
  check_is_model(arguments.model);
  const auto reservation = reserve_output_folder(arguments);
  SolveReport report;
  std::set<std::string> warned;
  {
    ProgressLines lines(arguments.progress, arguments.quiet);
    const auto expect = [&](Expectation expected) {
      expected.seconds += seconds_since(start) - expected.after_seconds;
      lines.expect(expected);
      if (arguments.quiet) return;
      lines.end_line();
      print_result(expected_line(expected));
    };
    const auto show = [&](const Progress& progress) {
      // The solves of a search for hexahedra are no results.
      const bool is_analysis = progress.phase == Phase::kAnalysis && !arguments.hexahedra;
      if (is_analysis || progress.phase == Phase::kWrite) Interruption::set_has_field(true);
      const bool is_stopped_level = is_analysis && progress.level < progress.levels;
      if (is_stopped_level) {
        lines.leave_line();
        announce_stop(
            fmt::format("level {} of {}, {}", progress.level, progress.levels, cells_text(progress.cells)));
      }
      lines.show(progress);
    };
    const auto tell = [&](const char* what, const ModelSummary& model) {
      if (arguments.quiet) return;
      lines.tell(model);
      print_result(row(what, sentence_of(model)));
    };
    bool has_model = false;
    Monitor monitor(show, expect, [&](const ModelSummary& model) {
      if (!std::exchange(has_model, true)) tell("model", model);
    });
    if (!together) monitor.allow_stops();
    const Interruption interruption(monitor, lines.is_moving());
    const auto warn = [&](const Warning& warning) {
      lines.end_line();
      print_warning(warning, arguments, warned);
    };
    const SolveOnGrid on_grid = together ? together : solve_alone;
    const Job job{arguments, on_grid, monitor, warn, tell, &lines, start};
    const bool is_of_field = arguments.mesh.empty() && !arguments.lattice;
    report = is_of_field ? solve_or_fill(job, reservation) : fit_and_write(job, reservation);
    lines.end_line();
  }
  for (const Warning& warning : report.warnings)
    if (is_always_printed(warning) && !is_said(warning, report)) print_warning(warning, arguments, warned);
  const bool is_short = report.hexahedra && report.hexahedra->outcome != HexOutcome::kAllHex;
  if (arguments.quiet && is_short)
    print_message(arguments.model + ": " + line_of(*report.hexahedra, arguments));
  if (!arguments.quiet) print_result(summary_of(report, arguments));
  return exit_code_after(report, arguments.accepts_approximate);
}

}  // namespace crossgrain::app
