// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "crossgrain/monitor.hpp"
#include "files/output_file.hpp"
#include "picture/image.hpp"

namespace crossgrain {

/// Texts that a PNG file carries.
struct PngTexts {
  bool has_mark = false;         ///< kPngMark (files/file_mark.hpp) and a seal (file_seal.hpp)
  std::string description = {};  ///< in UTF-8, for programs that show it and for screen readers
};

/// Writes a PNG file with 8 bits per channel: RGBA, or RGB if no pixel is transparent. The same image gives
/// the same bytes. Throws Error(kOutput), and Error(kInterrupted) once the monitor is cancelled.
void write_png(OutputFile& file, const Image& image, const Monitor& monitor, const PngTexts& texts = {});

}  // namespace crossgrain
