// SPDX-License-Identifier: Apache-2.0
// Frames as text: the nine numbers of the three unit axes one after the other, a line each.
#pragma once

#include <span>

#include "base/quaternion.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/types.hpp"
#include "files/output_file.hpp"

namespace crossgrain {

/// Writes 17 significant digits of every number, which read back as the same bits.
void write_frame_lines(OutputFile& file, std::span<const Frame> frames);

/// The same of frames as unit quaternions, with `between` after each of the first two axes: a blank, or the
/// end of a line, which gives three lines a frame. Throws Error(kInterrupted).
void write_frame_lines(OutputFile& file, std::span<const Quaternion> frames, char between,
                       const Monitor& monitor);

}  // namespace crossgrain
