// SPDX-License-Identifier: Apache-2.0
// The files that a field on tets can be written to. What stands in them is in docs/formats.md and
// docs/field-file.md.
#pragma once

#include "crossgrain/monitor.hpp"
#include "files/output_file.hpp"
#include "solve/tet_field.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// What they are written from: a frame for each vertex and tet of the solid's mesh.
struct TetOutput {
  const TetSolid& solid;
  const TetField& field;
};

// Each writes a whole file and finishes it. Throws Error(kOutput), and Error(kInterrupted) once the monitor
// is cancelled.

/// The axes of each vertex, a line each.
void write_vertex_axes(OutputFile& file, const TetOutput& output, const Monitor& monitor);

/// The tets as VTU, with the axes on vertices and tets.
void write_tet_grid(OutputFile& file, const TetOutput& output, const Monitor& monitor);

/// The tagged edges and triangles as VTU, with their tags.
void write_feature_grid(OutputFile& file, const TetOutput& output, const Monitor& monitor);

/// The singularity graph of the tets as VTU polylines.
void write_tet_singularities(OutputFile& file, const TetOutput& output, const Monitor& monitor);

/// FRA 1: the axes of each tet, a line for each of the three.
void write_fra(OutputFile& file, const TetOutput& output, const Monitor& monitor);

/// PERM 1: the matchings across faces that are not the identity.
void write_perm(OutputFile& file, const TetOutput& output, const Monitor& monitor);

/// FRAME: the axes of each tet, a line each.
void write_frame(OutputFile& file, const TetOutput& output, const Monitor& monitor);

/// A line `w x y z` for each vertex or tet.
void write_vertex_quaternions(OutputFile& file, const TetOutput& output, const Monitor& monitor);
void write_tet_quaternions(OutputFile& file, const TetOutput& output, const Monitor& monitor);

}  // namespace crossgrain
