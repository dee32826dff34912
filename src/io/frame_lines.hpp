// SPDX-License-Identifier: Apache-2.0
// Frames as text: the nine numbers of the three unit axes one after the other, a line each.
#pragma once

#include <span>

#include "crossgrain/types.hpp"
#include "io/output_file.hpp"

namespace crossgrain {

/// Writes 17 significant digits of every number, which read back as the same bits. Lines are made in
/// parallel, all of them in memory at once: about 200 bytes a frame.
void write_frame_lines(OutputFile& file, std::span<const Frame> frames);

}  // namespace crossgrain
