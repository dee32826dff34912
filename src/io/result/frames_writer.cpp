// SPDX-License-Identifier: Apache-2.0
// onto.frames.
#include "io/result/frame_lines.hpp"
#include "io/result/tet_writers.hpp"

namespace crossgrain {

void write_vertex_axes(OutputFile& file, const TetOutput& output, const Monitor& monitor) {
  write_frame_lines(file, output.field.vertex_frames, ' ', monitor);
  file.finish();
}

}  // namespace crossgrain
