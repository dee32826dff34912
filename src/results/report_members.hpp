// SPDX-License-Identifier: Apache-2.0
// The members of report.json in the order of the file, listed once for writing and reading: describe(file,
// value) of each struct, for a JsonWriter with a constant value and for a JsonReader.
#pragma once

#include <concepts>
#include <type_traits>

#include "base/each_name.hpp"
#include "crossgrain/message.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/tet_domain.hpp"
#include "crossgrain/verdict.hpp"

namespace crossgrain {

template <class T, class Struct>
concept MaybeConst = std::same_as<std::remove_const_t<T>, Struct>;

#define CROSSGRAIN_MEMBER(value, name) file.member(#name, value.name);
#define CROSSGRAIN_MEMBERS(value, ...) CROSSGRAIN_EACH(CROSSGRAIN_MEMBER, value, __VA_ARGS__)

/// A struct of which all members have their own names in the file.
#define CROSSGRAIN_DESCRIBE(Struct, ...)          \
  template <class File, MaybeConst<Struct> Value> \
  void describe(File& file, Value& value) {       \
    CROSSGRAIN_MEMBERS(value, __VA_ARGS__)        \
  }

CROSSGRAIN_DESCRIBE(SolveReport::AngleSummary, mean, p95, max)

template <class File, MaybeConst<Answer::Reason> Reason>
void describe(File& file, Reason& reason) {
  CROSSGRAIN_MEMBERS(reason, kind, verdict, count, place, text)
  file.optional_name("remedy", reason.remedy);
  if (has_number(reason.remedy)) file.member("remedy_number", reason.remedy_number);
  file.note("next", words_of(reason.remedy, reason.remedy_number).c_str());
}

/// The first members of the file.
template <class File, MaybeConst<Answer> Value>
void describe(File& file, Value& answer) {
  file.member("verdict", answer.verdict);
  file.note("answer", sentence_of(answer).c_str());
  file.member("reasons", answer.reasons);
}

CROSSGRAIN_DESCRIBE(Box, low, high)

template <class File, MaybeConst<SolveReport::Model> Model>
void describe(File& file, Model& model) {
  CROSSGRAIN_MEMBERS(model, path, triangles, bounding_box, watertight, components)
  file.text("unit", model.unit);
  file.text("file_unit", model.file_unit);
}

template <class File, MaybeConst<ModelFace> Face>
void describe(File& file, Face& face) {
  file.member("number", face.number);
  CROSSGRAIN_MEMBERS(face, kind, area, centre, solids, quads, quads_area)
}

CROSSGRAIN_DESCRIBE(LevelStatistics, depth, cells, active_cells, sweeps, energy, seconds)
CROSSGRAIN_DESCRIBE(SolveReport::Energy, smoothness, boundary, unavoidable, total, deviation_max)
CROSSGRAIN_DESCRIBE(SolveReport::Alignment, mean, p95, max, excluded_share)
CROSSGRAIN_DESCRIBE(SolveReport::Spectrum, plane, axis, frame, free, conflicted)

CROSSGRAIN_DESCRIBE(SolveReport::Singularity::Arc, type, index, verdict, length, oblique_length, on_boundary,
                    place, nodes)
CROSSGRAIN_DESCRIBE(SolveReport::Singularity::Node, place, on_boundary, verdict, arcs)
CROSSGRAIN_DESCRIBE(SolveReport::Singularity::Crease, hexahedra, angle_deg, least_angle_deg, length, followed,
                    verdict, place, faces)
CROSSGRAIN_DESCRIBE(SolveReport::Singularity::Corner, hexahedra, creases, arcs, verdict, place, faces,
                    narrowest_deg)
CROSSGRAIN_DESCRIBE(SolveReport::Singularity, edges, length, arcs, nodes, boundary_ends, unresolved_loops,
                    unresolved_stubs, crease_hooks, short_arcs, contacts, verdict, not_meshable_arcs,
                    not_meshable_nodes, undecided_nodes, arc_list, node_list, crease_list, corner_list)

CROSSGRAIN_DESCRIBE(SolveReport::Seconds, read, grid, solve, write, total)

template <class File, class Report>
void describe_results(File& file, Report& report) {
  describe(file, report.answer);
  CROSSGRAIN_MEMBERS(report, model, degree, resolution, levels, energy, alignment_deg, spectrum, singularity,
                     seconds, peak_memory_bytes)
}

template <class File, MaybeConst<SolveReport::Finding> Finding>
void describe(File& file, Finding& finding) {
  CROSSGRAIN_MEMBERS(finding, kind, count, at_least, place, length, done)
  file.note("done_text", words_of(finding.done));
}

CROSSGRAIN_DESCRIBE(SolveReport::Input, triangles_solved, closed, findings)
CROSSGRAIN_DESCRIBE(SolveReport::Creases, curves, length, corners, crowded_corners, knife_edges,
                    crowded_corner_places, knife_edge_places, tangent_deg)
CROSSGRAIN_DESCRIBE(SolveReport::Region, region, cells, volume)

template <class File, MaybeConst<SolveReport::Interfaces> Interfaces>
void describe(File& file, Interfaces& interfaces) {
  file.member("area", interfaces.area);
  file.object("alignment_deg", [&](auto& angles) {
    angles.member("mean", interfaces.mean);
    angles.member("p95", interfaces.p95);
    angles.member("max", interfaces.max);
  });
}

CROSSGRAIN_DESCRIBE(SolveReport::Constraints::Points, count, outside, angle_deg)
CROSSGRAIN_DESCRIBE(SolveReport::Constraints::Polylines, count, outside, length, outside_length, angle_deg)
CROSSGRAIN_DESCRIBE(SolveReport::Constraints::Faces, count, area, angle_deg)
CROSSGRAIN_DESCRIBE(SolveReport::Constraints, points, polylines, faces, stresses, isotropic_stresses)
CROSSGRAIN_DESCRIBE(SolveReport::Walls, cells_wanted, thin_share, unresolved_share, deciding_cells,
                    thinnest_cells, resolution_needed, two_sheet_cells, tied_cells)
CROSSGRAIN_DESCRIBE(SolveReport::Decision, cell_size, cells, energy)
CROSSGRAIN_DESCRIBE(SolveReport::Coarser::Difference, only_coarser, index, place)
CROSSGRAIN_DESCRIBE(SolveReport::Coarser, resolution, arcs, nodes, boundary_ends, verdict, last_change,
                    differences)
CROSSGRAIN_DESCRIBE(Expectation, depth, after_seconds, resolution, active_cells, peak_memory_bytes, seconds)

template <class File, MaybeConst<SolveReport::Limited> Limited>
void describe(File& file, Limited& limited) {
  file.member("resolution_asked", limited.resolution_requested);
  CROSSGRAIN_MEMBERS(limited, memory_bytes, memory_needed_bytes)
}

template <class File, MaybeConst<SolveReport::Unfinished> Unfinished>
void describe(File& file, Unfinished& unfinished) {
  file.member("resolution_asked", unfinished.resolution_requested);
  CROSSGRAIN_MEMBERS(unfinished, levels_missing, tets_missing)
}

CROSSGRAIN_DESCRIBE(MapPreparation, tets_before, vertices_before, split_edges, split_faces, split_tets,
                    refused_splits)
CROSSGRAIN_DESCRIBE(SolveReport::Onto::Singular, interior_faces, boundary_faces)
CROSSGRAIN_DESCRIBE(SolveReport::Onto::Repair, moves, changed_faces, faults_before, faults, moved_vertices,
                    edges_before, length_before, contacts_before, arcs_before, boundary_ends_before,
                    removed_arcs, shortened_arcs, led_arcs, bent_edges, bent_length, energy_before, energy,
                    turned_deg, seconds)
CROSSGRAIN_DESCRIBE(SolveReport::Onto, vertices, tets, prepared, boundary, dirichlet, edge_sum, singular,
                    singularity, edge_length, unfollowed_share, normal_deg, crease_deg, feature_edge_deg,
                    edge_length_needed, outside_vertices, unused_vertices, inverted_tets, left_out_tets,
                    united, start, seconds, repair)

template <class File, MaybeConst<HexReport::Quality> Quality>
void describe(File& file, Quality& quality) {
  file.member("min", quality.least);
  CROSSGRAIN_MEMBERS(quality, one_percent, mean, worst_place, inverted, below_tenth, below_fifth,
                     shortest_edge, shortest_edge_place)
}

template <class File, MaybeConst<HexAttempt> Attempt>
void describe(File& file, Attempt& attempt) {
  file.text("kind", attempt.kind);
  CROSSGRAIN_MEMBERS(attempt, number, round, tets, tet_size, tet_edge, repair, size, faults,
                     arcs_without_length, seamless_flips, flips, outcome, hexahedra)
  file.text("failure", attempt.failure);
  CROSSGRAIN_MEMBERS(attempt, work, tet_seconds, seconds)
}

CROSSGRAIN_DESCRIBE(HexFeatures::Lack, kind, number, place, figure, share, size_to_show)
CROSSGRAIN_DESCRIBE(HexFeatures::Kept, all, kept)
CROSSGRAIN_DESCRIBE(HexFeatures::Distances, percentile_99, largest, place, largest_in_all, place_in_all)
CROSSGRAIN_DESCRIBE(HexFitTry, way, hexahedra, added, unplaced, lacking, least, inverted, seconds)
CROSSGRAIN_DESCRIBE(HexFeatures, corners, creases, crease_length, faces, of_mesh, of_model, volume_ratio,
                    shells, model_shells, lacking, too_small, small)

template <class File, MaybeConst<HexReport> Report>
void describe(File& file, Report& hexahedra) {
  file.member("outcome", hexahedra.outcome);
  file.note("sentence", sentence_of(hexahedra).c_str());
  file.text("reason", hexahedra.reason);
  file.text("detail", hexahedra.detail);
  file.text("map_fault", hexahedra.map_fault);
  file.optional_name("remedy", hexahedra.remedy);
  if (has_number(hexahedra.remedy)) file.member("remedy_number", hexahedra.remedy_number);
  if (hexahedra.remedy == Remedy::kUseHexSize) file.member("remedy_hexahedra", hexahedra.remedy_hexahedra);
  file.note("next", words_of(hexahedra.remedy, hexahedra.remedy_number).c_str());
  CROSSGRAIN_MEMBERS(hexahedra, places, size, used_size, mean_edge, expected, hexahedra, vertices, bodies,
                     is_coarse, left_out, left_out_place, crowded_faces, open_edges, pinched_vertices, model,
                     volume, model_volume, area, model_area, largest_distance, largest_distance_place,
                     mean_distance, largest_distance_of_model, largest_distance_of_model_place,
                     interface_faces, largest_interface_distance, features, fit_tries, best_fit)
  file.member("scaled_jacobian", hexahedra.quality);
  file.member("scaled_jacobian_before", hexahedra.quality_before);
  CROSSGRAIN_MEMBERS(hexahedra, inner_valences, boundary_valences, attempts, best_attempt, is_stopped)
  file.note("way", way_of(hexahedra).c_str());
  file.object("seconds", [&](auto& seconds) {
    seconds.member("repair", hexahedra.repair_seconds);
    seconds.member("map", hexahedra.map_seconds);
    seconds.member("extraction", hexahedra.extraction_seconds);
    seconds.member("smoothing", hexahedra.smoothing_seconds);
    seconds.member("analysis", hexahedra.analysis_seconds);
  });
}

CROSSGRAIN_DESCRIBE(ResultInventory::File, name, bytes, checksum)

template <class File, MaybeConst<Warning> Value>
void describe(File& file, Value& warning) {
  file.member("kind", warning.kind);
  file.text("file", warning.file);
  file.text("place", warning.place);
  file.member("text", warning.text);
  file.optional_name("remedy", warning.remedy);
  if (has_number(warning.remedy)) file.member("remedy_number", warning.remedy_number);
  file.note("advice", words_of(warning.remedy, warning.remedy_number).c_str());
}

template <class File, class Report>
void describe_doubts(File& file, Report& report) {
  file.optional_list("faces", report.faces);
  CROSSGRAIN_MEMBERS(report, input, creases)
  file.optional_list("regions", report.regions);
  CROSSGRAIN_MEMBERS(report, interfaces, constraints, walls, decision, coarser, expected, limited, unfinished,
                     onto, hexahedra)
  file.optional_list("files", report.files);
  file.member("warnings", report.warnings);
}

#undef CROSSGRAIN_DESCRIBE
#undef CROSSGRAIN_MEMBERS
#undef CROSSGRAIN_MEMBER

}  // namespace crossgrain
