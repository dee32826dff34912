// SPDX-License-Identifier: Apache-2.0
// Writers of a field on tets. docs/formats.md and docs/field-file.md describe the files.
#pragma once

#include "crossgrain/hex_map.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "files/output_file.hpp"
#include "solve/tet_field.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// Input of the writers: a frame for each vertex and tet of the solid's mesh, and the singular lines.
struct TetOutput {
  const TetSolid& solid;
  const TetField& field;
  const SingularityGraph& lines;
  double hex_size = 1;          ///< OutputOptions::hex_size
  const HexMap* map = nullptr;  ///< OutputOptions::hex_map
};

// Each function writes a whole file and finishes it. Throws Error(kOutput), and Error(kInterrupted) once the
// monitor is cancelled.

/// Writes the axes of each vertex, one line per vertex.
void write_vertex_axes(OutputFile& file, const TetOutput& output, const Monitor& monitor);

/// Writes the tets as VTU, with axes on vertices and tets.
void write_tet_grid(OutputFile& file, const TetOutput& output, const Monitor& monitor);

/// Writes the tagged edges and triangles as VTU, with their tags.
void write_feature_grid(OutputFile& file, const TetOutput& output, const Monitor& monitor);

/// Writes the singularity graph of the tets as VTU polylines.
void write_tet_singularities(OutputFile& file, const TetOutput& output, const Monitor& monitor);

/// Writes the vertices and tets as a Medit mesh in text.
void write_medit(OutputFile& file, const TetOutput& output, const Monitor& monitor);

/// Writes FRA 1: the axes of each tet, of length 1 / hex_size, one line per axis.
void write_fra(OutputFile& file, const TetOutput& output, const Monitor& monitor);

/// Writes PERM 1: the matchings across faces that are not the identity.
void write_perm(OutputFile& file, const TetOutput& output, const Monitor& monitor);

/// Writes FRAME: the axes of each tet, one line per tet.
void write_frame(OutputFile& file, const TetOutput& output, const Monitor& monitor);

/// Writes a line `w x y z` for each vertex or tet.
void write_vertex_quaternions(OutputFile& file, const TetOutput& output, const Monitor& monitor);
void write_tet_quaternions(OutputFile& file, const TetOutput& output, const Monitor& monitor);

}  // namespace crossgrain
