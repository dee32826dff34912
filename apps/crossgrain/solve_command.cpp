// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>

#include "commands.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/io.hpp"
#include "crossgrain/solve.hpp"
#include "crossgrain/thread_limit.hpp"
#include "interruption.hpp"
#include "output.hpp"
#include "progress_lines.hpp"

namespace crossgrain::app {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The library knows a mesh; the user knows the file it came from.
FrameField solve_model(const SolveArguments& arguments, const TriangleMesh& mesh, const Monitor& monitor) {
  try {
    if (arguments.from.empty()) return solve(mesh, arguments.options, monitor);
    return solve_from(read_field(arguments.from), mesh, arguments.options, monitor);
  } catch (const Error& error) {
    const bool of_mesh = error.kind() == ErrorKind::kInput || error.kind() == ErrorKind::kLimit;
    const std::string message = error.what();
    if (!of_mesh || (!arguments.from.empty() && message.starts_with(arguments.from))) throw;
    throw Error(error.kind(), arguments.model + ": " + message);
  }
}

std::string singularity_line(const SolveReport::Singularity& singularity) {
  if (singularity.arcs == 0) return "none";
  return fmt::format("{} arcs, {:.4g} long in all, {} nodes inside, {} ends on the surface", singularity.arcs,
                     singularity.length, singularity.nodes, singularity.boundary_ends);
}

std::string summary_of(const SolveReport& report, const std::string& output) {
  const auto& alignment = report.alignment_deg;
  std::string text = fmt::format("{} triangles, {}\n", report.model.triangles,
                                 report.model.watertight ? "watertight" : "not watertight");
  if (!report.levels.empty()) text += fmt::format("cells      {}\n", report.levels.back().active_cells);
  text += fmt::format("energy     {:.6g} (smoothness {:.6g}, boundary {:.6g})\n", report.energy.total,
                      report.energy.smoothness, report.energy.boundary);
  text += fmt::format(
      "alignment  {:.3g} degrees off the surface in the mean, 95 % within {:.3g}, all within {:.3g}; {:.2g} "
      "% left out\n",
      alignment.mean, alignment.p95, alignment.max, 100 * alignment.excluded_share);
  text += fmt::format("singular   {}\n", singularity_line(report.singularity));
  for (const std::string& warning : report.warnings) text += fmt::format("warning    {}\n", warning);
  text += fmt::format("result     {} and {}\n", (std::filesystem::path(output) / "field.vtu").string(),
                      (std::filesystem::path(output) / "report.json").string());
  return text;
}

}  // namespace

void run_solve(const SolveArguments& arguments) {
  const auto start = Clock::now();
  const ThreadLimit thread_limit(arguments.options.threads);
  check_field_folder(arguments.output);

  SolveReport report;
  {
    ProgressLines lines(!arguments.quiet && (arguments.progress || isatty(STDERR_FILENO)));
    Monitor monitor([&lines](const Progress& progress) { lines.show(progress); });
    const Interruption interruption(monitor);

    monitor.report({"read", 0, 0, 0, 0});
    const TriangleMesh mesh = read_surface(arguments.model);
    const double read_seconds = seconds_since(start);
    monitor.check();
    const FrameField field = solve_model(arguments, mesh, monitor);

    monitor.report({"write", 0, 0, 0, 0});
    report = field.report();
    report.model.path = arguments.model;
    report.seconds.read = read_seconds;
    report.seconds.total = seconds_since(start);
    write_field(field, report, arguments.output, monitor);
  }
  if (!arguments.quiet) print_result(summary_of(report, arguments.output));
}

}  // namespace crossgrain::app
