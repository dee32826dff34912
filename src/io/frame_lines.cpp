// SPDX-License-Identifier: Apache-2.0
#include "io/frame_lines.hpp"

#include <charconv>
#include <string>
#include <vector>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

/// Frames that one task turns into text: about 200 kB.
constexpr std::size_t kFramesAtOnce = 1024;

constexpr int kDigits = 17;

/// Of one number: sign, digits, point, an exponent such as e-308, and the blank after it.
constexpr std::size_t kNumberBytes = kDigits + 8;

char* put(char* out, const Frame& frame) {
  for (const Vector3& axis : frame.axes) {
    for (const double number : axis) {
      out = std::to_chars(out, out + kNumberBytes, number, std::chars_format::general, kDigits).ptr;
      *out++ = ' ';
    }
  }
  out[-1] = '\n';
  return out;
}

}  // namespace

void write_frame_lines(OutputFile& file, std::span<const Frame> frames) {
  std::vector<std::string> texts((frames.size() + kFramesAtOnce - 1) / kFramesAtOnce);
  parallel_for_chunks(frames.size(), kFramesAtOnce, [&](std::size_t begin, std::size_t end) {
    std::string& text = texts[begin / kFramesAtOnce];
    text.resize((end - begin) * 9 * kNumberBytes);
    char* out = text.data();
    for (std::size_t i = begin; i < end; ++i) out = put(out, frames[i]);
    text.resize(static_cast<std::size_t>(out - text.data()));
  });
  for (const std::string& text : texts) file.write(text);
}

}  // namespace crossgrain
