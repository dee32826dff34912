// SPDX-License-Identifier: Apache-2.0
// The names of all options. Each function calls visit(name, member) for every member of its struct, in the
// order of the header.
#pragma once

#include <string>

#include "c_interface/output_choices.hpp"
#include "crossgrain/hex_meshing.hpp"
#include "crossgrain/options.hpp"
#include "crossgrain/picture.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/repair.hpp"
#include "crossgrain/streamlines.hpp"
#include "crossgrain/tet_making.hpp"

namespace crossgrain {

/// The name of a member is its name in C++.
#define CROSSGRAIN_OPTION(member) visit(#member, options.member)

/// Those of an inner struct with a list of its own, as `name`.member.
template <class Options, class Visit>
void for_each_inner_option(const char* name, Options& options, const Visit& visit) {
  for_each_option(options, [&](const char* inner, auto& member) {
    visit((std::string(name) + "." + inner).c_str(), member);
  });
}

template <class Visit>
void for_each_option(SolveOptions& options, const Visit& visit) {
  CROSSGRAIN_OPTION(degree);
  CROSSGRAIN_OPTION(resolution);
  CROSSGRAIN_OPTION(cell_size);
  CROSSGRAIN_OPTION(threads);
  CROSSGRAIN_OPTION(max_memory_bytes);
  CROSSGRAIN_OPTION(unite_solids);
  CROSSGRAIN_OPTION(seed);
  CROSSGRAIN_OPTION(crease_angle_deg);
  CROSSGRAIN_OPTION(boundary);
  CROSSGRAIN_OPTION(for_page);
}

template <class Visit>
void for_each_option(ReadOptions& options, const Visit& visit) {
  CROSSGRAIN_OPTION(resolution);
  CROSSGRAIN_OPTION(cell_size);
  CROSSGRAIN_OPTION(facet_angle_deg);
  CROSSGRAIN_OPTION(crease_angle_deg);
  CROSSGRAIN_OPTION(glue);
  CROSSGRAIN_OPTION(read_seconds);
  CROSSGRAIN_OPTION(max_memory_bytes);
}

template <class Visit>
void for_each_option(TetTagOptions& options, const Visit& visit) {
  CROSSGRAIN_OPTION(keep_all);
}

template <class Visit>
void for_each_option(MapPreparationOptions& options, const Visit& visit) {
  CROSSGRAIN_OPTION(unite_solids);
}

template <class Visit>
void for_each_option(TetMakingOptions& options, const Visit& visit) {
  CROSSGRAIN_OPTION(size);
  CROSSGRAIN_OPTION(edges);
  CROSSGRAIN_OPTION(maker);
  CROSSGRAIN_OPTION(edges_per_circle);
  CROSSGRAIN_OPTION(crease_angle_deg);
  CROSSGRAIN_OPTION(seconds);
  CROSSGRAIN_OPTION(max_memory_bytes);
  CROSSGRAIN_OPTION(read_seconds);
  CROSSGRAIN_OPTION(glue);
}

template <class Visit>
void for_each_option(RepairOptions& options, const Visit& visit) {
  CROSSGRAIN_OPTION(moves_vertices);
}

template <class Visit>
void for_each_option(HexOptions& options, const Visit& visit) {
  CROSSGRAIN_OPTION(size);
  CROSSGRAIN_OPTION(cells);
  CROSSGRAIN_OPTION(threads);
}

template <class Visit>
void for_each_option(HexMeshingOptions& options, const Visit& visit) {
  for_each_inner_option("hexahedra", options.hexahedra, visit);
  for_each_inner_option("tets", options.tets, visit);
  for_each_inner_option("tags", options.tags, visit);
  for_each_inner_option("solve", options.solve, visit);
}

template <class Visit>
void for_each_option(OutputChoices& options, const Visit& visit) {
  CROSSGRAIN_OPTION(level);
  CROSSGRAIN_OPTION(clip);
  CROSSGRAIN_OPTION(formats);
  CROSSGRAIN_OPTION(hex_size);
  CROSSGRAIN_OPTION(foreign_files);
  CROSSGRAIN_OPTION(page);
}

template <class Visit>
void for_each_option(StreamlineOptions& options, const Visit& visit) {
  CROSSGRAIN_OPTION(axes);
  CROSSGRAIN_OPTION(spacing_sides);
}

template <class Visit>
void for_each_option(PictureOptions& options, const Visit& visit) {
  CROSSGRAIN_OPTION(size);
  CROSSGRAIN_OPTION(view);
  CROSSGRAIN_OPTION(up_axis);
  CROSSGRAIN_OPTION(colour);
  CROSSGRAIN_OPTION(range);
  CROSSGRAIN_OPTION(cut);
  CROSSGRAIN_OPTION(frames);
  CROSSGRAIN_OPTION(without);
  CROSSGRAIN_OPTION(background);
  CROSSGRAIN_OPTION(quality_below);
}

#undef CROSSGRAIN_OPTION

}  // namespace crossgrain
