// SPDX-License-Identifier: Apache-2.0
// Frames as unit quaternions, `w x y z` a line.
#include <vector>

#include "base/quaternion.hpp"
#include "io/result/tet_writers.hpp"
#include "io/text/text_lines.hpp"

namespace crossgrain {
namespace {

void write_quaternions(OutputFile& file, const std::vector<Quaternion>& frames, const Monitor& monitor) {
  const auto put = [&](std::size_t i, char* out) {
    const Quaternion& q = frames[i];
    out = put_number(out, q.w, ' ');
    out = put_number(out, q.x, ' ');
    out = put_number(out, q.y, ' ');
    return put_number(out, q.z, '\n');
  };
  write_text_lines(file, frames.size(), 4 * kNumberBytes, put, monitor);
  file.finish();
}

}  // namespace

void write_vertex_quaternions(OutputFile& file, const TetOutput& output, const Monitor& monitor) {
  write_quaternions(file, output.field.vertex_frames, monitor);
}

void write_tet_quaternions(OutputFile& file, const TetOutput& output, const Monitor& monitor) {
  write_quaternions(file, output.field.tet_frames, monitor);
}

}  // namespace crossgrain
