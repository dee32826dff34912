// SPDX-License-Identifier: Apache-2.0
// Text files of frames, as their axes u, v and w or as unit quaternions. io/result/tet_writers.hpp declares
// the writers of a field on tets:
//
//   onto.frames    a line a vertex: ux uy uz vx vy vz wx wy wz
//   .fra           FRA 1 | tets 3 1 | three lines a tet, one an axis; no reader looks at the 1 (CubeCover,
//   Mint) .frame         FRAME | tets | a line a tet | END (mouette) .quaternions   a line a vertex or tet: w
//   x y z
#pragma once

#include <span>

#include "crossgrain/types.hpp"
#include "files/output_file.hpp"

namespace crossgrain {

/// The nine numbers of the axes of each frame, a line each; 17 significant digits, which read back as the
/// same bits.
void write_frame_lines(OutputFile& file, std::span<const Frame> frames);

}  // namespace crossgrain
