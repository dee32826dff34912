// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "commands.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/picture.hpp"
#include "crossgrain/read_limits.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/thread_limit.hpp"
#include "interruption.hpp"
#include "messages.hpp"
#include "output.hpp"
#include "output_places.hpp"
#include "results/one_solve.hpp"
#include "results/result_files.hpp"

namespace crossgrain::app {

namespace {

void check_files(const RenderArguments& arguments) {
  const auto normal = [](const std::filesystem::path& path) { return path.lexically_normal(); };
  for (const std::string& name : all_result_files()) {
    const std::filesystem::path input = std::filesystem::path(arguments.field) / name;
    if (normal(input) == normal(arguments.output))
      throw Error(ErrorKind::kUsage,
                  {input.string(), "", "belongs to the field; choose another file for the picture"});
  }
}

std::vector<AxisCurve> streamlines_in(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / kStreamlinesFile;
  if (!may_exist(path))
    throw Error(ErrorKind::kInput, {path.string(), "", "does not exist", Remedy::kTraceStreamlines});
  return read_streamlines(path);
}

/// What is drawn, read from the folder.
struct Field {
  std::variant<FrameField, TetFrameField> field;
  SingularityGraph lines;
  std::vector<AxisCurve> streamlines;
};

Field read_field_of(const RenderArguments& arguments) {
  const std::filesystem::path folder = arguments.field;
  const bool has_tets = may_exist(folder / kTetSingularityFile);
  if (arguments.choice == FieldChoice::kTets && !has_tets)
    throw Error(ErrorKind::kInput, {arguments.field, "", "has no field on tets"});
  const bool draws_tets = has_tets && arguments.choice != FieldChoice::kGrid;
  const auto read = [&]() -> std::variant<FrameField, TetFrameField> {
    if (!draws_tets) return read_field(folder);
    std::optional<TetFrameField> field = read_tet_field(folder);
    if (!field) throw Error(ErrorKind::kInput, {arguments.field, "", "lacks its tets", Remedy::kSolveAgain});
    return *std::move(field);
  };
  // The field first: if there is none, it is the folder that is wrong.
  std::variant<FrameField, TetFrameField> field = read();
  SingularityGraph lines = read_singularities(folder / (draws_tets ? kTetSingularityFile : kSingularityFile));
  std::vector<AxisCurve> streamlines;
  if (arguments.streamlines) streamlines = streamlines_in(folder);
  return {std::move(field), std::move(lines), std::move(streamlines)};
}

/// A mesh of hexahedra with what the report of its folder says of it.
struct HexSubject {
  HexMesh mesh;
  std::optional<HexReport> report;
};

/// Returns a line that says what is drawn of a mesh that does not fill its model.
std::string partial_line(const HexReport* report) {
  if (report == nullptr || report->outcome != HexOutcome::kPartial) return "";
  return fmt::format("hexahedra  {}\n",
                     sentence_of(*report, words_of(report->remedy, report->remedy_number, Command::kHex)));
}

/// Returns what is to be said of them.
std::string draw_hexahedra(const RenderArguments& arguments, const Monitor& monitor) {
  const std::filesystem::path folder = arguments.field;
  const HexSubject subject = read_one_solve(folder, [&] {
    return HexSubject{read_hexahedra(folder), report_of_result(folder).hexahedra};
  });
  const HexReport* const report = subject.report ? &*subject.report : nullptr;
  naming(arguments.field,
         [&] { render_picture(subject.mesh, arguments.output, arguments.options, report, monitor); });
  return partial_line(report);
}

/// Returns what is to be said of what is drawn.
std::string draw(const RenderArguments& arguments, const Monitor& monitor) {
  const std::filesystem::path folder = arguments.field;
  const bool has_any = may_exist(folder / kHexahedraFile) || may_exist(folder / kPartialHexahedraFile);
  if (arguments.subject == Subject::kHexahedra || (arguments.subject == Subject::kHexahedraIfAny && has_any))
    return draw_hexahedra(arguments, monitor);
  const Field subject = read_one_solve(folder, [&] { return read_field_of(arguments); });
  const PictureCurves curves{&subject.lines, subject.streamlines};
  const auto render = [&](const auto& field) {
    naming(arguments.field,
           [&] { render_picture(field, arguments.output, arguments.options, curves, monitor); });
  };
  std::visit(render, subject.field);
  return "";
}

}  // namespace

void run_render(const RenderArguments& arguments) {
  check_files(arguments);
  if (!arguments.is_output_named) check_output_file(arguments.output);
  Monitor monitor;
  const Interruption interruption(monitor);
  const ThreadLimit limit(arguments.threads);
  const auto start = std::chrono::steady_clock::now();
  const ReadLimits limits(monitor);
  const std::string said = draw(arguments, monitor);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (arguments.quiet) return;
  print_result(fmt::format("{} x {} pixels, drawn in {:.3g} s\n{}result     {}\n", arguments.options.size[0],
                           arguments.options.size[1], seconds.count(), said, arguments.output));
}

}  // namespace crossgrain::app
