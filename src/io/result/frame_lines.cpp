// SPDX-License-Identifier: Apache-2.0
#include "io/result/frame_lines.hpp"

#include "io/text/text_lines.hpp"
#include "sampling/orthonormal_frame.hpp"

namespace crossgrain {
namespace {

constexpr std::size_t kFrameBytes = 9 * kNumberBytes;

char* put_frame(char* out, const Frame& frame, char between) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Vector3& v = frame.axes[axis];
    out = put_number(out, v[0], ' ');
    out = put_number(out, v[1], ' ');
    out = put_number(out, v[2], axis == 2 ? '\n' : between);
  }
  return out;
}

}  // namespace

void write_frame_lines(OutputFile& file, std::span<const Frame> frames) {
  write_text_lines(file, frames.size(), kFrameBytes,
                   [&](std::size_t i, char* out) { return put_frame(out, frames[i], ' '); });
}

void write_frame_lines(OutputFile& file, std::span<const Quaternion> frames, char between,
                       const Monitor& monitor) {
  const auto put = [&](std::size_t i, char* out) {
    return put_frame(out, orthonormal_frame(frames[i]), between);
  };
  write_text_lines(file, frames.size(), kFrameBytes, put, monitor);
}

}  // namespace crossgrain
