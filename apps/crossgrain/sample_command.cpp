// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "commands.hpp"
#include "crossgrain/io.hpp"
#include "interruption.hpp"
#include "output.hpp"

namespace crossgrain::app {

void run_sample(const SampleArguments& arguments) {
  const FrameField field = read_field(arguments.field);
  const std::vector<Vector3> points = read_points(arguments.points);

  // Not before: waiting for standard input is ended by the first Ctrl-C.
  Monitor monitor;
  const Interruption interruption(monitor);
  const std::size_t outside = write_samples(field, points, {arguments.output, arguments.outside}, monitor);
  print_message(fmt::format("{} of {} points are outside the solid{}", outside, points.size(),
                            outside > 0 ? "; they got the nearest cell's frame" : ""));
}

}  // namespace crossgrain::app
