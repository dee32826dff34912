// SPDX-License-Identifier: Apache-2.0
// Text files of frames, as their axes u, v and w or as unit quaternions. results/tet_writers.hpp declares
// the writers of a field on tets:
//
//   onto.frames    one line per vertex: ux uy uz vx vy vz wx wy wz
//   .fra           FRA 1 | tets 3 1 | three lines per tet, one per axis (CubeCover, Mint)
//   .frame         FRAME | tets | one line per tet | END (mouette)
//   .quaternions   one line per vertex or tet: w x y z
//
// No reader uses the last 1 of "tets 3 1".
#pragma once

#include <span>

#include "crossgrain/types.hpp"
#include "files/output_file.hpp"

namespace crossgrain {

/// Writes the nine numbers of the axes of each frame, one line per frame, with 17 significant digits, which
/// restore the same bits.
void write_frame_lines(OutputFile& file, std::span<const Frame> frames);

}  // namespace crossgrain
