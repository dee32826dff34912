// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crossgrain/monitor.hpp"
#include "files/output_file.hpp"
#include "picture/image.hpp"

namespace crossgrain {

/// Whether a PNG file carries kPngMark (files/file_mark.hpp), as results do.
enum class PngMark { kNone, kProgram };

/// Writes a PNG file with 8 bits per channel: RGBA, or RGB if no pixel is transparent. The same image gives
/// the same bytes. Throws Error(kOutput), and Error(kInterrupted) once the monitor is cancelled.
void write_png(OutputFile& file, const Image& image, const Monitor& monitor, PngMark mark = PngMark::kNone);

}  // namespace crossgrain
