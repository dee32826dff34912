// SPDX-License-Identifier: Apache-2.0
// The names of all options. Each function calls visit(name, member) for every member of its struct, in the
// order of the header.
#pragma once

#include <string>

#include "base/each_name.hpp"
#include "c_interface/output_choices.hpp"
#include "crossgrain/hex_fit.hpp"
#include "crossgrain/hex_meshing.hpp"
#include "crossgrain/options.hpp"
#include "crossgrain/picture.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/repair.hpp"
#include "crossgrain/streamlines.hpp"
#include "crossgrain/tet_making.hpp"

namespace crossgrain {

/// The name of a member is its name in C++.
#define CROSSGRAIN_OPTION(visit, member) visit(#member, options.member);
#define CROSSGRAIN_OPTIONS(Struct, ...)                       \
  template <class Visit>                                      \
  void for_each_option(Struct& options, const Visit& visit) { \
    CROSSGRAIN_EACH(CROSSGRAIN_OPTION, visit, __VA_ARGS__)    \
  }

/// Those of an inner struct with a list of its own, as `name`.member.
template <class Options, class Visit>
void for_each_inner_option(const char* name, Options& options, const Visit& visit) {
  for_each_option(options, [&](const char* inner, auto& member) {
    visit((std::string(name) + "." + inner).c_str(), member);
  });
}

CROSSGRAIN_OPTIONS(SolveOptions, degree, resolution, cell_size, threads, max_memory_bytes, unite_solids, seed,
                   crease_angle_deg, boundary, for_page)
CROSSGRAIN_OPTIONS(ReadOptions, resolution, cell_size, facet_angle_deg, crease_angle_deg, glue, unit,
                   read_seconds, max_memory_bytes)
CROSSGRAIN_OPTIONS(TetTagOptions, keep_all)
CROSSGRAIN_OPTIONS(MapPreparationOptions, unite_solids)
CROSSGRAIN_OPTIONS(TetMakingOptions, size, edges, maker, edges_per_circle, crease_angle_deg, defeature,
                   seconds, max_memory_bytes, read_seconds, glue, unit)
CROSSGRAIN_OPTIONS(RepairOptions, moves_vertices, max_memory_bytes)
CROSSGRAIN_OPTIONS(HexOptions, size, cells, preference, thorough, threads)

template <class Visit>
void for_each_option(HexMeshingOptions& options, const Visit& visit) {
  for_each_inner_option("hexahedra", options.hexahedra, visit);
  for_each_inner_option("tets", options.tets, visit);
  for_each_inner_option("tags", options.tags, visit);
  for_each_inner_option("solve", options.solve, visit);
}

template <class Visit>
void for_each_option(HexFitOptions& options, const Visit& visit) {
  CROSSGRAIN_EACH(CROSSGRAIN_OPTION, visit, crease_angle_deg, defeature, read_seconds, glue, unit,
                  max_memory_bytes, threads)
  for_each_inner_option("tags", options.tags, visit);
}

CROSSGRAIN_OPTIONS(OutputChoices, level, clip, formats, hex_size, inverted_hexahedra, foreign_files, page)
CROSSGRAIN_OPTIONS(StreamlineOptions, axes, spacing_sides)
CROSSGRAIN_OPTIONS(PictureOptions, size, view, up_axis, colour, range, cut, frames, without, background,
                   quality_below)

#undef CROSSGRAIN_OPTIONS
#undef CROSSGRAIN_OPTION

}  // namespace crossgrain
