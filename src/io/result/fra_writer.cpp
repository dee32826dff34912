// SPDX-License-Identifier: Apache-2.0
// The .fra files of CubeCover and Mint, version 1:
//
//   FRA 1
//   tets 3 1        frames, vectors a frame, and a number that no reader looks at
//   x y z           three lines a tet, one an axis
#include <fmt/format.h>

#include "io/result/frame_lines.hpp"
#include "io/result/tet_writers.hpp"

namespace crossgrain {

void write_fra(OutputFile& file, const TetOutput& output, const Monitor& monitor) {
  file.write(fmt::format("FRA 1\n{} 3 1\n", output.field.tet_frames.size()));
  write_frame_lines(file, output.field.tet_frames, '\n', monitor);
  file.finish();
}

}  // namespace crossgrain
