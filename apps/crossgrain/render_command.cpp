// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "commands.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/picture.hpp"
#include "crossgrain/thread_limit.hpp"
#include "interruption.hpp"
#include "output.hpp"

namespace crossgrain::app {

namespace {

void check_files(const RenderArguments& arguments) {
  const auto normal = [](const std::filesystem::path& path) { return path.lexically_normal(); };
  for (const char* name : {"field.vtu", "singularities.vtu", "surface.vtu", "report.json", "streamlines.vtu",
                           "onto.vtu", "onto.frames", "onto_singularities.vtu"}) {
    const std::filesystem::path input = std::filesystem::path(arguments.field) / name;
    if (normal(input) == normal(arguments.output))
      throw Error(ErrorKind::kUsage,
                  {input.string(), "", "is of the field; name another file for the picture"});
  }
}

}  // namespace

void run_render(const RenderArguments& arguments) {
  check_files(arguments);
  Monitor monitor;
  const Interruption interruption(monitor);
  const ThreadLimit limit(arguments.threads);
  const auto start = std::chrono::steady_clock::now();
  render_picture(arguments.field, arguments.output, arguments.options, monitor);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (arguments.quiet) return;
  print_result(fmt::format("{} x {} pixels, drawn in {:.3g} s\nresult     {}\n", arguments.options.width,
                           arguments.options.height, seconds.count(), arguments.output));
}

}  // namespace crossgrain::app
