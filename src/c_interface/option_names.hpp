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
#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/streamlines.hpp"
#include "crossgrain/tet_making.hpp"
#include "crossgrain/verdict.hpp"

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
  CROSSGRAIN_OPTION(refinement.by_surface);
  CROSSGRAIN_OPTION(refinement.by_spectral_conflict);
  CROSSGRAIN_OPTION(refinement.by_thickness);
  CROSSGRAIN_OPTION(refinement.by_energy_density);
  CROSSGRAIN_OPTION(refinement.thickness_cells);
  CROSSGRAIN_OPTION(refinement.unresolved_share);
  CROSSGRAIN_OPTION(refinement.energy_density_threshold);
  CROSSGRAIN_OPTION(refinement.coarsest_cells);
  CROSSGRAIN_OPTION(creases.least_deg);
  CROSSGRAIN_OPTION(creases.fading.sure_deg);
  CROSSGRAIN_OPTION(creases.fading.least_radii);
  CROSSGRAIN_OPTION(creases.corner_deg);
  CROSSGRAIN_OPTION(creases.knife_deg);
  CROSSGRAIN_OPTION(solver.boundary_weight);
  CROSSGRAIN_OPTION(solver.crease_weight);
  CROSSGRAIN_OPTION(solver.tagged_weight);
  CROSSGRAIN_OPTION(solver.diagonal_share);
  CROSSGRAIN_OPTION(solver.starts);
  CROSSGRAIN_OPTION(solver.start_cells);
  CROSSGRAIN_OPTION(solver.start_relaxation);
  CROSSGRAIN_OPTION(solver.level_relaxation);
  CROSSGRAIN_OPTION(solver.relaxed_cells);
  CROSSGRAIN_OPTION(solver.decision_cells);
  CROSSGRAIN_OPTION(solver.largest_decided);
  CROSSGRAIN_OPTION(solver.decided_relaxation);
  CROSSGRAIN_OPTION(solver.decided_relaxed_cells);
  CROSSGRAIN_OPTION(solver.turned_triangles);
  CROSSGRAIN_OPTION(solver.relaxation_degree);
  CROSSGRAIN_OPTION(solver.symmetrisation);
  CROSSGRAIN_OPTION(solver.over_relaxation);
  CROSSGRAIN_OPTION(solver.shift_relaxed_forms);
  CROSSGRAIN_OPTION(solver.most_sweeps);
  CROSSGRAIN_OPTION(solver.sweep_tolerance);
  CROSSGRAIN_OPTION(solver.resting_share);
  CROSSGRAIN_OPTION(solver.calm_fields.least_turn_deg);
  CROSSGRAIN_OPTION(solver.calm_fields.calm_turn_deg);
  CROSSGRAIN_OPTION(solver.calm_fields.more_sweeps);
  CROSSGRAIN_OPTION(solver.calm_fields.over_relaxation);
  CROSSGRAIN_OPTION(onto.boundary);
  CROSSGRAIN_OPTION(onto.cell_size_edges);
  CROSSGRAIN_OPTION(onto.fewest_cells);
  CROSSGRAIN_OPTION(onto.other_starts);
  CROSSGRAIN_OPTION(onto.same_box);
  CROSSGRAIN_OPTION(onto.race_sweeps);
  CROSSGRAIN_OPTION(onto.race_margin);
  CROSSGRAIN_OPTION(onto.race_tie);
  CROSSGRAIN_OPTION(onto.crease_weight);
  CROSSGRAIN_OPTION(onto.relaxation_sweeps);
  CROSSGRAIN_OPTION(onto.symmetrisation);
  CROSSGRAIN_OPTION(onto.over_relaxation);
  CROSSGRAIN_OPTION(onto.most_sweeps);
  CROSSGRAIN_OPTION(onto.sweep_tolerance);
  CROSSGRAIN_OPTION(onto.resting_share);
  CROSSGRAIN_OPTION(onto.calm_fields.least_turn_deg);
  CROSSGRAIN_OPTION(onto.calm_fields.calm_turn_deg);
  CROSSGRAIN_OPTION(onto.calm_fields.more_sweeps);
  CROSSGRAIN_OPTION(onto.calm_fields.over_relaxation);
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
  CROSSGRAIN_OPTION(least_share);
  CROSSGRAIN_OPTION(most_other_share);
  CROSSGRAIN_OPTION(fewest_region_tets);
  CROSSGRAIN_OPTION(fewest);
}

template <class Visit>
void for_each_option(MapPreparationOptions& options, const Visit& visit) {
  CROSSGRAIN_OPTION(cut_off_creases);
  CROSSGRAIN_OPTION(layer_spread_deg);
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
void for_each_option(SingularityOptions& options, const Visit& visit) {
  CROSSGRAIN_OPTION(merge_cells);
  CROSSGRAIN_OPTION(end_cells);
  CROSSGRAIN_OPTION(touch_cells);
  CROSSGRAIN_OPTION(touch_aside_cells);
  CROSSGRAIN_OPTION(hook_cells);
  CROSSGRAIN_OPTION(hook_reach_cells);
  CROSSGRAIN_OPTION(tip_reach_cells);
  CROSSGRAIN_OPTION(loop_cells);
  CROSSGRAIN_OPTION(shift_cells);
  CROSSGRAIN_OPTION(smoothing_rounds);
  CROSSGRAIN_OPTION(sign_cosine);
  CROSSGRAIN_OPTION(sign_cells);
  CROSSGRAIN_OPTION(rounding_deg);
  CROSSGRAIN_OPTION(sharp_deg);
  CROSSGRAIN_OPTION(bend_deg);
}

template <class Visit>
void for_each_option(AnswerOptions& options, const Visit& visit) {
  CROSSGRAIN_OPTION(wall_cells);
  CROSSGRAIN_OPTION(thin_share);
  CROSSGRAIN_OPTION(unfollowed_share);
  CROSSGRAIN_OPTION(unfollowed_deg);
  CROSSGRAIN_OPTION(short_per_arc);
  CROSSGRAIN_OPTION(few_short);
}

template <class Visit>
void for_each_option(StreamlineOptions& options, const Visit& visit) {
  CROSSGRAIN_OPTION(axes);
  CROSSGRAIN_OPTION(spacing_sides);
  CROSSGRAIN_OPTION(tolerance);
  CROSSGRAIN_OPTION(largest_step_cells);
  CROSSGRAIN_OPTION(smallest_step_cells);
  CROSSGRAIN_OPTION(arc_distance_cells);
  CROSSGRAIN_OPTION(closing_cells);
  CROSSGRAIN_OPTION(end_tolerance_cells);
  CROSSGRAIN_OPTION(longest_sides);
  CROSSGRAIN_OPTION(most_points);
}

template <class Visit>
void for_each_option(PictureOptions& options, const Visit& visit) {
  CROSSGRAIN_OPTION(width);
  CROSSGRAIN_OPTION(height);
  CROSSGRAIN_OPTION(view);
  CROSSGRAIN_OPTION(up_axis);
  CROSSGRAIN_OPTION(colour);
  CROSSGRAIN_OPTION(range);
  CROSSGRAIN_OPTION(cut);
  CROSSGRAIN_OPTION(frames);
  CROSSGRAIN_OPTION(frame_spacing);
  CROSSGRAIN_OPTION(lines);
  CROSSGRAIN_OPTION(creases);
  CROSSGRAIN_OPTION(legend);
  CROSSGRAIN_OPTION(opacity);
  CROSSGRAIN_OPTION(background);
  CROSSGRAIN_OPTION(quality_below);
}

#undef CROSSGRAIN_OPTION

}  // namespace crossgrain
