// SPDX-License-Identifier: Apache-2.0
// A field on a tet mesh as files, beside those of the field on the grid.
//
//   onto.frames   the frame of each vertex, in the order of the mesh: nine numbers a line, as for `sample`
//   onto.vtu      the tets; point data and cell data axis_u, axis_v, axis_w
//   onto_singularities.vtu   the lines around which the frames of tets turn (io/singularity_file.hpp)
#pragma once

#include <filesystem>

#include "analysis/tet_field.hpp"
#include "crossgrain/frame_field.hpp"
#include "crossgrain/io.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/report.hpp"

namespace crossgrain {

/// `write_field` (crossgrain/io.hpp) with onto.frames, onto.vtu and onto_singularities.vtu: all six files or
/// none.
SolveReport write_field_onto(const FrameField& field, SolveReport report, const TetMesh& mesh,
                             const TetField& onto, const std::filesystem::path& folder,
                             const Monitor& monitor = {}, const OutputOptions& options = {});

}  // namespace crossgrain
