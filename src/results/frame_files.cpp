// SPDX-License-Identifier: Apache-2.0
#include "results/frame_files.hpp"

#include <fmt/format.h>

#include <vector>

#include "base/quaternion.hpp"
#include "results/tet_writers.hpp"
#include "sampling/orthonormal_frame.hpp"
#include "text/text_lines.hpp"

namespace crossgrain {
namespace {

constexpr std::size_t kFrameBytes = 9 * kNumberBytes;

/// `between` follows each of the first two axes: a blank, or a line end. Axes have the length 1 / divisor.
char* put_frame(char* out, const Frame& frame, char between, double divisor = 1) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vector3 v = frame.axes[axis];
    for (double& coordinate : v) coordinate /= divisor;
    out = put_number(out, v[0], ' ');
    out = put_number(out, v[1], ' ');
    out = put_number(out, v[2], axis == 2 ? '\n' : between);
  }
  return out;
}

void write_axes(OutputFile& file, const std::vector<Quaternion>& frames, char between, const Monitor& monitor,
                double divisor = 1) {
  const auto put = [&](std::size_t i, char* out) {
    return put_frame(out, orthonormal_frame(frames[i]), between, divisor);
  };
  write_text_lines(file, frames.size(), kFrameBytes, put, monitor);
}

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

void write_frame_lines(OutputFile& file, std::span<const Frame> frames) {
  write_text_lines(file, frames.size(), kFrameBytes,
                   [&](std::size_t i, char* out) { return put_frame(out, frames[i], ' '); });
}

void write_vertex_axes(OutputFile& file, const TetOutput& output, const Monitor& monitor) {
  write_axes(file, output.field.vertex_frames, ' ', monitor);
  file.finish();
}

void write_fra(OutputFile& file, const TetOutput& output, const Monitor& monitor) {
  file.write(fmt::format("FRA 1\n{} 3 1\n", output.field.tet_frames.size()));
  write_axes(file, output.field.tet_frames, '\n', monitor, output.hex_size);
  file.finish();
}

void write_frame(OutputFile& file, const TetOutput& output, const Monitor& monitor) {
  file.write(fmt::format("FRAME\n{}\n", output.field.tet_frames.size()));
  write_axes(file, output.field.tet_frames, ' ', monitor);
  file.write("END\n");
  file.finish();
}

void write_vertex_quaternions(OutputFile& file, const TetOutput& output, const Monitor& monitor) {
  write_quaternions(file, output.field.vertex_frames, monitor);
}

void write_tet_quaternions(OutputFile& file, const TetOutput& output, const Monitor& monitor) {
  write_quaternions(file, output.field.tet_frames, monitor);
}

}  // namespace crossgrain
