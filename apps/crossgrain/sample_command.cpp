// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>

#include "commands.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/message.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/samples.hpp"
#include "interruption.hpp"
#include "output.hpp"

namespace crossgrain::app {

namespace {

void check_files(const SampleArguments& arguments) {
  const auto same = [](const std::string& a, const std::string& b) {
    return a != "-" && !a.empty() &&
           std::filesystem::path(a).lexically_normal() == std::filesystem::path(b).lexically_normal();
  };
  if (same(arguments.output, arguments.points_file) || same(arguments.outside, arguments.points_file)) {
    throw Error(ErrorKind::kUsage,
                {arguments.points_file, "", "is the file of points; choose another file for the result"});
  }
  if (same(arguments.output, arguments.outside)) {
    throw Error(ErrorKind::kUsage,
                {arguments.output, "", "is given for both frames and outside points; choose two files"});
  }
}

}  // namespace

void run_sample(const SampleArguments& arguments) {
  const SampleFiles files{arguments.output, arguments.outside};
  check_files(arguments);
  check_sample_names(files);
  const FrameField field = read_field(arguments.field);
  const std::vector<Vector3> points =
      arguments.points_file.empty() ? arguments.points : read_points(arguments.points_file);

  // Not earlier: the first Ctrl-C must end waiting for standard input.
  Monitor monitor;
  const Interruption interruption(monitor);
  const std::size_t outside = write_samples(field, points, files, monitor);
  print_message(fmt::format("{} of {} {} outside the field{}", outside, counted(points.size(), "point"),
                            is_or_are(outside),
                            outside == 0   ? ""
                            : outside == 1 ? "; it got the nearest cell's frame"
                                           : "; they got the nearest cell's frame"));
}

}  // namespace crossgrain::app
