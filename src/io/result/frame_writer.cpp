// SPDX-License-Identifier: Apache-2.0
// The .frame files of mouette:
//
//   FRAME
//   tets
//   ux uy uz vx vy vz wx wy wz        a line a tet
//   END
#include <fmt/format.h>

#include "io/result/frame_lines.hpp"
#include "io/result/tet_writers.hpp"

namespace crossgrain {

void write_frame(OutputFile& file, const TetOutput& output, const Monitor& monitor) {
  file.write(fmt::format("FRAME\n{}\n", output.field.tet_frames.size()));
  write_frame_lines(file, output.field.tet_frames, ' ', monitor);
  file.write("END\n");
  file.finish();
}

}  // namespace crossgrain
