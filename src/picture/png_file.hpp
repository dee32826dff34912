// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crossgrain/monitor.hpp"
#include "files/output_file.hpp"
#include "picture/image.hpp"

namespace crossgrain {

/// Writes a PNG file of 8 bits a channel: RGBA, or RGB where no pixel is transparent. The same bytes for the
/// same image. Throws Error(kOutput), and Error(kInterrupted) once the monitor is cancelled.
void write_png(OutputFile& file, const Image& image, const Monitor& monitor);

}  // namespace crossgrain
