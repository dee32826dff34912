// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "commands.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/samples.hpp"
#include "crossgrain/streamlines.hpp"
#include "crossgrain/tet_frame_field.hpp"
#include "crossgrain/writing.hpp"
#include "interruption.hpp"
#include "output.hpp"
#include "output_places.hpp"
#include "results/result_files.hpp"

namespace crossgrain::app {
namespace {

using Clock = std::chrono::steady_clock;

/// Default spacing of lines through spread seeds in longest sides: about as many lines as can be seen
/// through, or told apart on a surface or cut.
double usual_spacing(const SeedPlaces& places) {
  if (places.on_surface) return 0.08;
  return places.cut ? 0.05 : 0.15;
}

void check_files(const StreamlinesArguments& arguments) {
  const auto normal = [](const std::filesystem::path& path) { return path.lexically_normal(); };
  const std::filesystem::path output = normal(arguments.output), folder = arguments.field;
  std::vector<std::string> inputs{arguments.seeds};
  for (const std::string& name : all_result_files())
    if (name != kStreamlinesFile) inputs.push_back((folder / name).string());
  for (const std::string& input : inputs) {
    if (input.empty() || input == "-" || normal(input) != output) continue;
    throw Error(ErrorKind::kUsage,
                {input, "", "is an input or belongs to the field; choose another file for the lines"});
  }
}

std::string ends_line(const std::vector<Streamline>& lines) {
  std::array<std::size_t, 6> counts{};
  std::size_t closed = 0;
  for (const Streamline& line : lines) {
    if (line.last_end == StreamlineEnd::kClosed) {
      ++closed;
      continue;
    }
    ++counts[static_cast<std::size_t>(line.first_end)];
    ++counts[static_cast<std::size_t>(line.last_end)];
  }
  const auto of = [&](StreamlineEnd end) { return counts[static_cast<std::size_t>(end)]; };
  std::string text = fmt::format("ends       {} at the boundary, {} at singular arcs",
                                 of(StreamlineEnd::kBoundary), of(StreamlineEnd::kSingularArc));
  if (of(StreamlineEnd::kCrowded) > 0)
    text += fmt::format(", {} next to other lines", of(StreamlineEnd::kCrowded));
  if (of(StreamlineEnd::kLongest) > 0)
    text += fmt::format(", {} where lines may be no longer", of(StreamlineEnd::kLongest));
  if (of(StreamlineEnd::kAmbiguous) > 0)
    text += fmt::format(", {} where no axis goes on", of(StreamlineEnd::kAmbiguous));
  return text + fmt::format("; {} closed\n", counted(closed, "line"));
}

std::string summary_of(const std::vector<Streamline>& lines, std::size_t seeds, double seconds,
                       const std::string& output) {
  std::size_t points = 0;
  double length = 0;
  for (const Streamline& line : lines) {
    points += line.points.size();
    length += line.length;
  }
  return fmt::format("{} of {}, {}, {:.4g} long in all, traced in {:.3g} s\n", counted(lines.size(), "line"),
                     counted(seeds, "seed"), counted(points, "point"), length, seconds) +
         ends_line(lines) + fmt::format("result     {}\n", output);
}

void tell_of_seeds(const Streamlines& traced, std::size_t seeds, const std::string& source) {
  if (traced.lines.empty()) {
    throw Error(
        ErrorKind::kInput,
        {source, "",
         fmt::format("gives no line: of {} {} {} outside the field and {} at a singular arc; give points "
                     "inside, in the model's unit",
                     counted(seeds, "seed"), traced.outside_seeds, is_or_are(traced.outside_seeds),
                     traced.arc_seeds)});
  }
  if (traced.outside_seeds > 0)
    print_message(fmt::format("{} of {} {} outside the field", traced.outside_seeds, counted(seeds, "seed"),
                              is_or_are(traced.outside_seeds)));
  if (traced.arc_seeds > 0)
    print_message(fmt::format("{} of {} {} at a singular arc, where no line begins", traced.arc_seeds,
                              counted(seeds, "seed"), is_or_are(traced.arc_seeds)));
}

using AnyField = std::variant<FrameField, TetFrameField>;

AnyField read_any_field(const StreamlinesArguments& arguments) {
  if (arguments.choice == FieldChoice::kGrid) return read_field(arguments.field);
  if (auto field = read_tet_field(arguments.field)) return std::move(*field);
  if (arguments.choice == FieldChoice::kTets)
    throw Error(ErrorKind::kInput, {arguments.field, "", "has no field on tets"});
  return read_field(arguments.field);
}

std::string solve_of(const AnyField& field) {
  return std::visit([](const auto& any) { return any.report().solve; }, field);
}

std::vector<StreamlineSeed> seeds_of(const StreamlinesArguments& arguments, const StreamlineTracer& tracer,
                                     const Monitor& monitor) {
  const SeedPlaces& places = arguments.places;
  if (places.on_surface) return tracer.surface_seeds(arguments.count, monitor);
  if (places.cut) return tracer.cut_seeds(places.cut->axis, places.cut->position, arguments.count, monitor);
  std::vector<StreamlineSeed> seeds;
  for (const Vector3& point : tracer.spread_seeds(arguments.count, monitor)) seeds.push_back({point});
  return seeds;
}

}  // namespace

void run_streamlines(const StreamlinesArguments& arguments) {
  check_files(arguments);
  if (arguments.is_output_named) check_streamline_file(arguments.output);
  const AnyField field = read_any_field(arguments);
  if (!arguments.is_output_named) {
    check_output_file(arguments.output);
    check_streamline_file(arguments.output);
  }
  const bool are_given = !arguments.seeds.empty();
  std::vector<StreamlineSeed> seeds;
  if (are_given)
    for (const Vector3& point : read_points(arguments.seeds)) seeds.push_back({point});

  // Not earlier: the first Ctrl-C must end waiting for standard input.
  Monitor monitor;
  const Interruption interruption(monitor);
  StreamlineOptions options = arguments.options;
  options.spacing_sides = arguments.spacing.value_or(are_given ? 0 : usual_spacing(arguments.places));
  const StreamlineTracer tracer =
      std::visit([&](const auto& any) { return StreamlineTracer(any, options); }, field);
  const auto start = Clock::now();
  if (!are_given) seeds = seeds_of(arguments, tracer, monitor);
  const Streamlines traced = tracer.trace(seeds, monitor);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const std::string source = !are_given               ? arguments.field
                             : arguments.seeds == "-" ? "standard input"
                                                      : arguments.seeds;
  tell_of_seeds(traced, seeds.size(), source);
  write_streamlines(traced.lines, arguments.output, monitor, solve_of(field));
  if (!arguments.quiet) print_result(summary_of(traced.lines, seeds.size(), seconds, arguments.output));
}

}  // namespace crossgrain::app
