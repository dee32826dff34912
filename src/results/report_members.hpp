// SPDX-License-Identifier: Apache-2.0
// The members of report.json in the order of the file, listed once for writing and reading: File is a
// JsonWriter or a JsonReader.
#pragma once

#include "crossgrain/message.hpp"
#include "crossgrain/verdict.hpp"

namespace crossgrain {

template <class File, class Level>
void describe_level(File& file, Level& level) {
  file.member("depth", level.depth);
  file.member("cells", level.cells);
  file.member("active_cells", level.active_cells);
  file.member("sweeps", level.sweeps);
  file.member("energy", level.energy);
  file.member("seconds", level.seconds);
}

template <class File, class Report>
void describe_input(File& file, Report& report) {
  file.object("model", [&](auto& model) {
    model.member("path", report.model.path);
    model.member("triangles", report.model.triangles);
    model.object("bounding_box", [&](auto& box) {
      box.member("low", report.model.bounding_box.low);
      box.member("high", report.model.bounding_box.high);
    });
    model.member("watertight", report.model.watertight);
    model.member("components", report.model.components);
    model.text("unit", report.model.unit);
    model.text("file_unit", report.model.file_unit);
  });
  file.member("degree", report.degree);
  file.member("resolution", report.resolution);
}

template <class File, class Arc>
void describe_arc(File& file, Arc& arc) {
  file.name("type", arc.type);
  file.member("index", arc.index);
  file.name("verdict", arc.verdict);
  file.member("length", arc.length);
  file.member("oblique_length", arc.oblique_length);
  file.member("on_boundary", arc.on_boundary);
  file.member("place", arc.place);
  file.member("nodes", arc.nodes);
}

template <class File, class Node>
void describe_node(File& file, Node& node) {
  file.member("place", node.place);
  file.member("on_boundary", node.on_boundary);
  file.name("verdict", node.verdict);
  file.member("arcs", node.arcs);
}

template <class File, class Crease>
void describe_hexahedra(File& file, Crease& crease) {
  file.member("hexahedra", crease.hexahedra);
  file.member("angle_deg", crease.angle_deg);
  file.member("least_angle_deg", crease.least_angle_deg);
  file.member("length", crease.length);
  file.member("followed", crease.followed);
  file.name("verdict", crease.verdict);
  file.member("place", crease.place);
}

template <class File, class Corner>
void describe_corner(File& file, Corner& corner) {
  file.member("hexahedra", corner.hexahedra);
  file.member("creases", corner.creases);
  file.member("arcs", corner.arcs);
  file.name("verdict", corner.verdict);
  file.member("place", corner.place);
}

template <class File, class Singularity>
void describe_singularity(File& file, const char* key, Singularity& graph) {
  file.object(key, [&](auto& inner) {
    inner.member("edges", graph.edges);
    inner.member("length", graph.length);
    inner.member("arcs", graph.arcs);
    inner.member("nodes", graph.nodes);
    inner.member("boundary_ends", graph.boundary_ends);
    inner.member("unresolved_loops", graph.unresolved_loops);
    inner.member("unresolved_stubs", graph.unresolved_stubs);
    inner.member("crease_hooks", graph.crease_hooks);
    inner.member("short_arcs", graph.short_arcs);
    inner.member("contacts", graph.contacts);
    inner.name("verdict", graph.verdict);
    inner.member("not_meshable_arcs", graph.not_meshable_arcs);
    inner.member("not_meshable_nodes", graph.not_meshable_nodes);
    inner.member("undecided_nodes", graph.undecided_nodes);
    inner.list("arc_list", graph.arc_list, [](auto& list, auto& arc) { describe_arc(list, arc); });
    inner.list("node_list", graph.node_list, [](auto& list, auto& node) { describe_node(list, node); });
    inner.list("crease_list", graph.crease_list,
               [](auto& list, auto& crease) { describe_hexahedra(list, crease); });
    inner.list("corner_list", graph.corner_list,
               [](auto& list, auto& corner) { describe_corner(list, corner); });
  });
}

template <class File, class Report>
void describe_quality(File& file, Report& report) {
  file.object("energy", [&](auto& energy) {
    energy.member("smoothness", report.energy.smoothness);
    energy.member("boundary", report.energy.boundary);
    energy.member("unavoidable", report.energy.unavoidable);
    energy.member("total", report.energy.total);
    energy.member("deviation_max", report.energy.deviation_max);
  });
  file.object("alignment_deg", [&](auto& alignment) {
    alignment.member("mean", report.alignment_deg.mean);
    alignment.member("p95", report.alignment_deg.p95);
    alignment.member("max", report.alignment_deg.max);
    alignment.member("excluded_share", report.alignment_deg.excluded_share);
  });
  file.object("spectrum", [&](auto& spectrum) {
    spectrum.member("plane", report.spectrum.plane);
    spectrum.member("axis", report.spectrum.axis);
    spectrum.member("frame", report.spectrum.frame);
    spectrum.member("free", report.spectrum.free);
    spectrum.member("conflicted", report.spectrum.conflicted);
  });
  describe_singularity(file, "singularity", report.singularity);
}

template <class File, class Angles>
void describe_angles(File& file, const char* key, Angles& angles) {
  file.object(key, [&](auto& inner) {
    inner.member("mean", angles.mean);
    inner.member("p95", angles.p95);
    inner.member("max", angles.max);
  });
}

template <class File, class Repair>
void describe_repair(File& file, Repair& repair) {
  file.member("moves", repair.moves);
  file.member("changed_faces", repair.changed_faces);
  file.member("faults_before", repair.faults_before);
  file.member("faults", repair.faults);
  file.member("moved_vertices", repair.moved_vertices);
  file.member("edges_before", repair.edges_before);
  file.member("length_before", repair.length_before);
  file.member("contacts_before", repair.contacts_before);
  file.member("arcs_before", repair.arcs_before);
  file.member("boundary_ends_before", repair.boundary_ends_before);
  file.member("removed_arcs", repair.removed_arcs);
  file.member("shortened_arcs", repair.shortened_arcs);
  file.member("led_arcs", repair.led_arcs);
  file.member("bent_edges", repair.bent_edges);
  file.member("bent_length", repair.bent_length);
  file.member("energy_before", repair.energy_before);
  file.member("energy", repair.energy);
  describe_angles(file, "turned_deg", repair.turned_deg);
  file.member("seconds", repair.seconds);
}

template <class File, class Onto>
void describe_onto(File& file, Onto& onto) {
  file.member("vertices", onto.vertices);
  file.member("tets", onto.tets);
  file.optional_object("prepared", onto.prepared, [](auto& inner, auto& prepared) {
    inner.member("tets_before", prepared.tets_before);
    inner.member("vertices_before", prepared.vertices_before);
    inner.member("split_edges", prepared.split_edges);
    inner.member("split_faces", prepared.split_faces);
    inner.member("split_tets", prepared.split_tets);
    inner.member("refused_splits", prepared.refused_splits);
  });
  file.name("boundary", onto.boundary);
  file.member("dirichlet", onto.dirichlet);
  file.member("edge_sum", onto.edge_sum);
  file.object("singular", [&](auto& singular) {
    singular.member("interior_faces", onto.singular.interior_faces);
    singular.member("boundary_faces", onto.singular.boundary_faces);
  });
  describe_singularity(file, "singularity", onto.singularity);
  file.member("edge_length", onto.edge_length);
  file.member("unfollowed_share", onto.unfollowed_share);
  describe_angles(file, "normal_deg", onto.normal_deg);
  describe_angles(file, "crease_deg", onto.crease_deg);
  file.optional_object("feature_edge_deg", onto.feature_edge_deg, [](auto& inner, auto& angles) {
    inner.member("mean", angles.mean);
    inner.member("p95", angles.p95);
    inner.member("max", angles.max);
  });
  file.member("edge_length_needed", onto.edge_length_needed);
  file.member("outside_vertices", onto.outside_vertices);
  file.member("unused_vertices", onto.unused_vertices);
  file.member("inverted_tets", onto.inverted_tets);
  file.member("left_out_tets", onto.left_out_tets);
  file.member("united", onto.united);
  file.member("start", onto.start);
  file.member("seconds", onto.seconds);
  file.optional_object("repair", onto.repair,
                       [](auto& inner, auto& repair) { describe_repair(inner, repair); });
}

template <class File, class Quality>
void describe_scaled_jacobian(File& file, const char* key, Quality& quality) {
  file.object(key, [&](auto& inner) {
    inner.member("min", quality.least);
    inner.member("one_percent", quality.one_percent);
    inner.member("mean", quality.mean);
    inner.member("worst_place", quality.worst_place);
    inner.member("inverted", quality.inverted);
    inner.member("below_tenth", quality.below_tenth);
    inner.member("below_fifth", quality.below_fifth);
  });
}

template <class File, class Attempt>
void describe_attempt(File& file, Attempt& attempt) {
  file.text("kind", attempt.kind);
  file.member("round", attempt.round);
  file.member("tets", attempt.tets);
  file.member("tet_size", attempt.tet_size);
  file.member("repair", attempt.repair);
  file.member("size", attempt.size);
  file.member("faults", attempt.faults);
  file.member("arcs_without_length", attempt.arcs_without_length);
  file.member("seamless_flips", attempt.seamless_flips);
  file.member("flips", attempt.flips);
  file.name("outcome", attempt.outcome);
  file.member("hexahedra", attempt.hexahedra);
  file.text("failure", attempt.failure);
  file.member("work", attempt.work);
  file.member("tet_seconds", attempt.tet_seconds);
  file.member("seconds", attempt.seconds);
}

template <class File, class Hexahedra>
void describe_hex_mesh(File& file, Hexahedra& hexahedra) {
  file.name("outcome", hexahedra.outcome);
  file.text("reason", hexahedra.reason);
  file.text("remedy", hexahedra.remedy);
  file.member("places", hexahedra.places);
  file.member("size", hexahedra.size);
  file.member("used_size", hexahedra.used_size);
  file.member("hexahedra", hexahedra.hexahedra);
  file.member("vertices", hexahedra.vertices);
  file.member("is_coarse", hexahedra.is_coarse);
  file.member("left_out", hexahedra.left_out);
  file.member("crowded_faces", hexahedra.crowded_faces);
  file.member("open_edges", hexahedra.open_edges);
  file.member("pinched_vertices", hexahedra.pinched_vertices);
  file.member("volume", hexahedra.volume);
  file.member("model_volume", hexahedra.model_volume);
  file.member("area", hexahedra.area);
  file.member("model_area", hexahedra.model_area);
  file.member("largest_distance", hexahedra.largest_distance);
  file.member("mean_distance", hexahedra.mean_distance);
  file.member("largest_distance_of_model", hexahedra.largest_distance_of_model);
  describe_scaled_jacobian(file, "scaled_jacobian", hexahedra.quality);
  describe_scaled_jacobian(file, "scaled_jacobian_before", hexahedra.quality_before);
  file.member("inner_valences", hexahedra.inner_valences);
  file.member("boundary_valences", hexahedra.boundary_valences);
  file.list("attempts", hexahedra.attempts,
            [](auto& list, auto& attempt) { describe_attempt(list, attempt); });
  file.member("best_attempt", hexahedra.best_attempt);
  file.object("seconds", [&](auto& seconds) {
    seconds.member("repair", hexahedra.repair_seconds);
    seconds.member("map", hexahedra.map_seconds);
    seconds.member("extraction", hexahedra.extraction_seconds);
    seconds.member("smoothing", hexahedra.smoothing_seconds);
    seconds.member("analysis", hexahedra.analysis_seconds);
  });
}

template <class File, class Report>
void describe_cost(File& file, Report& report) {
  file.object("seconds", [&](auto& seconds) {
    seconds.member("read", report.seconds.read);
    seconds.member("grid", report.seconds.grid);
    seconds.member("solve", report.seconds.solve);
    seconds.member("write", report.seconds.write);
    seconds.member("total", report.seconds.total);
  });
  file.member("peak_memory_bytes", report.peak_memory_bytes);
}

template <class File, class Expected>
void describe_expected(File& file, Expected& expected) {
  file.member("depth", expected.depth);
  file.member("after_seconds", expected.after_seconds);
  file.member("resolution", expected.resolution);
  file.member("active_cells", expected.active_cells);
  file.member("peak_memory_bytes", expected.peak_memory_bytes);
  file.member("seconds", expected.seconds);
}

template <class File, class Limited>
void describe_limited(File& file, Limited& limited) {
  file.member("resolution_asked", limited.resolution_requested);
  file.member("memory_bytes", limited.memory_bytes);
  file.member("memory_needed_bytes", limited.memory_needed_bytes);
}

template <class File, class Unfinished>
void describe_unfinished(File& file, Unfinished& unfinished) {
  file.member("resolution_asked", unfinished.resolution_requested);
  file.member("levels_missing", unfinished.levels_missing);
  file.member("tets_missing", unfinished.tets_missing);
}

template <class File, class Report>
void describe_creases(File& file, Report& report) {
  file.object("creases", [&](auto& creases) {
    creases.member("curves", report.creases.curves);
    creases.member("length", report.creases.length);
    creases.member("corners", report.creases.corners);
    creases.member("crowded_corners", report.creases.crowded_corners);
    creases.member("knife_edges", report.creases.knife_edges);
    creases.member("crowded_corner_places", report.creases.crowded_corner_places);
    creases.member("knife_edge_places", report.creases.knife_edge_places);
    describe_angles(creases, "tangent_deg", report.creases.tangent_deg);
  });
}

template <class File, class Finding>
void describe_finding(File& file, Finding& finding) {
  file.name("kind", finding.kind);
  file.member("count", finding.count);
  file.member("at_least", finding.at_least);
  file.member("place", finding.place);
  file.member("length", finding.length);
  file.name("done", finding.done);
  file.note("done_text", words_of(finding.done));
}

template <class File, class Points>
void describe_points(File& file, const char* key, Points& points) {
  file.object(key, [&](auto& inner) {
    inner.member("count", points.count);
    inner.member("outside", points.outside);
    describe_angles(inner, "angle_deg", points.angle_deg);
  });
}

template <class File, class Constraints>
void describe_constraints(File& file, Constraints& constraints) {
  describe_points(file, "points", constraints.points);
  file.object("polylines", [&](auto& polylines) {
    polylines.member("count", constraints.polylines.count);
    polylines.member("outside", constraints.polylines.outside);
    polylines.member("length", constraints.polylines.length);
    polylines.member("outside_length", constraints.polylines.outside_length);
    describe_angles(polylines, "angle_deg", constraints.polylines.angle_deg);
  });
  file.object("faces", [&](auto& faces) {
    faces.member("count", constraints.faces.count);
    faces.member("area", constraints.faces.area);
    describe_angles(faces, "angle_deg", constraints.faces.angle_deg);
  });
  describe_points(file, "stresses", constraints.stresses);
  file.member("isotropic_stresses", constraints.isotropic_stresses);
}

template <class File, class Region>
void describe_region(File& file, Region& region) {
  file.member("region", region.region);
  file.member("cells", region.cells);
  file.member("volume", region.volume);
}

template <class File, class Interfaces>
void describe_interfaces(File& file, Interfaces& interfaces) {
  file.member("area", interfaces.area);
  file.object("alignment_deg", [&](auto& alignment) {
    alignment.member("mean", interfaces.mean);
    alignment.member("p95", interfaces.p95);
    alignment.member("max", interfaces.max);
  });
}

template <class File, class Report>
void describe_solids(File& file, Report& report) {
  file.optional_list("regions", report.regions,
                     [](auto& inner, auto& region) { describe_region(inner, region); });
  file.optional_object("interfaces", report.interfaces,
                       [](auto& inner, auto& interfaces) { describe_interfaces(inner, interfaces); });
}

template <class File, class Warning>
void describe_warning(File& file, Warning& warning) {
  file.name("kind", warning.kind);
  file.text("file", warning.file);
  file.text("place", warning.place);
  file.member("text", warning.text);
  file.optional_name("remedy", warning.remedy);
  file.note("advice", words_of(warning.remedy));
}

template <class File, class Decision>
void describe_decision(File& file, Decision& decision) {
  file.member("cell_size", decision.cell_size);
  file.member("cells", decision.cells);
  file.member("energy", decision.energy);
}

template <class File, class Coarser>
void describe_coarser(File& file, Coarser& coarser) {
  file.member("resolution", coarser.resolution);
  file.member("arcs", coarser.arcs);
  file.member("nodes", coarser.nodes);
  file.member("boundary_ends", coarser.boundary_ends);
  file.name("verdict", coarser.verdict);
  file.member("last_change", coarser.last_change);
  file.list("differences", coarser.differences, [](auto& inner, auto& difference) {
    inner.member("only_coarser", difference.only_coarser);
    inner.member("index", difference.index);
    inner.member("place", difference.place);
  });
}

/// The first members of the file.
template <class File, class Answer>
void describe_answer(File& file, Answer& answer) {
  file.name("verdict", answer.verdict);
  file.note("answer", sentence_of(answer).c_str());
  file.list("reasons", answer.reasons, [](auto& inner, auto& reason) {
    inner.name("kind", reason.kind);
    inner.name("verdict", reason.verdict);
    inner.member("count", reason.count);
    inner.member("place", reason.place);
    inner.member("text", reason.text);
    inner.optional_name("remedy", reason.remedy);
    if (has_number(reason.remedy)) inner.member("remedy_number", reason.remedy_number);
    inner.note("next", words_of(reason.remedy, reason.remedy_number).c_str());
  });
}

template <class File, class Report>
void describe_unmarked_files(File& file, Report& report) {
  file.optional_list("unmarked_files", report.unmarked_files, [](auto& inner, auto& unmarked) {
    inner.member("name", unmarked.name);
    inner.member("bytes", unmarked.bytes);
    inner.member("checksum", unmarked.checksum);
  });
}

template <class File, class Report>
void describe_doubts(File& file, Report& report) {
  file.object("input", [&](auto& input) {
    input.member("triangles_solved", report.input.triangles_solved);
    input.member("closed", report.input.closed);
    input.list("findings", report.input.findings,
               [](auto& inner, auto& finding) { describe_finding(inner, finding); });
  });
  describe_creases(file, report);
  describe_solids(file, report);
  file.optional_object("constraints", report.constraints,
                       [](auto& inner, auto& constraints) { describe_constraints(inner, constraints); });
  file.object("walls", [&](auto& walls) {
    walls.member("cells_wanted", report.walls.cells_wanted);
    walls.member("thin_share", report.walls.thin_share);
    walls.member("unresolved_share", report.walls.unresolved_share);
    walls.member("deciding_cells", report.walls.deciding_cells);
    walls.member("thinnest_cells", report.walls.thinnest_cells);
    walls.member("resolution_needed", report.walls.resolution_needed);
    walls.member("two_sheet_cells", report.walls.two_sheet_cells);
    walls.member("tied_cells", report.walls.tied_cells);
  });
  file.optional_object("decision", report.decision,
                       [](auto& inner, auto& decision) { describe_decision(inner, decision); });
  file.optional_object("coarser", report.coarser,
                       [](auto& inner, auto& coarser) { describe_coarser(inner, coarser); });
  file.optional_object("expected", report.expected,
                       [](auto& inner, auto& expected) { describe_expected(inner, expected); });
  file.optional_object("limited", report.limited,
                       [](auto& inner, auto& limited) { describe_limited(inner, limited); });
  file.optional_object("unfinished", report.unfinished,
                       [](auto& inner, auto& unfinished) { describe_unfinished(inner, unfinished); });
  file.optional_object("onto", report.onto, [](auto& inner, auto& onto) { describe_onto(inner, onto); });
  file.optional_object("hexahedra", report.hexahedra,
                       [](auto& inner, auto& hexahedra) { describe_hex_mesh(inner, hexahedra); });
  describe_unmarked_files(file, report);
  file.list("warnings", report.warnings,
            [](auto& inner, auto& warning) { describe_warning(inner, warning); });
}

template <class File, class Report>
void describe_results(File& file, Report& report) {
  describe_answer(file, report.answer);
  describe_input(file, report);
  file.list("levels", report.levels, [](auto& inner, auto& level) { describe_level(inner, level); });
  describe_quality(file, report);
  describe_cost(file, report);
}

}  // namespace crossgrain
