// SPDX-License-Identifier: Apache-2.0
// Text files of frames, as their axes u, v and w or as unit quaternions. io/result/tet_writers.hpp declares
// the writers of a field on tets:
//
//   onto.frames    one line per vertex: ux uy uz vx vy vz wx wy wz
//   .fra           FRA 1 | tets 3 1 | three lines per tet, one per axis (CubeCover, Mint; readers ignore the 1)
//   .frame         FRAME | tets | one line per tet | END (mouette)
//   .quaternions   one line per vertex or tet: w x y z
#pragma once

#include <span>

#include "crossgrain/types.hpp"
#include "files/output_file.hpp"

namespace crossgrain {

/// The nine numbers of the axes of each frame, a line each; 17 significant digits, which read back as the
/// same bits.
void write_frame_lines(OutputFile& file, std::span<const Frame> frames);

}  // namespace crossgrain
