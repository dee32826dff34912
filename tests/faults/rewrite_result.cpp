// SPDX-License-Identifier: Apache-2.0
// rewrite_result FROM TO [XMAX]: reads a field and writes it again, only the cells below XMAX if that is
// given, so that tests have large results without their solves. Prints a line when it begins to write.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>

#include "crossgrain/result_folder.hpp"

int main(int argc, char** argv) {
  try {
    const crossgrain::FrameField field = crossgrain::read_field(argv[1]);
    std::puts("writing");
    std::fflush(stdout);
    crossgrain::OutputOptions options;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (argc > 3)
      options.clip =
          crossgrain::Box{{-kInfinity, -kInfinity, -kInfinity}, {std::atof(argv[3]), kInfinity, kInfinity}};
    crossgrain::write_field(field, argv[2], {}, options);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
