// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "base/names.hpp"
#include "base/vector3.hpp"
#include "hex/field_mapping.hpp"
#include "hex/model_fit.hpp"
#include "measure/hex_faces.hpp"
#include "measure/hex_quality.hpp"

namespace crossgrain {
namespace {

std::vector<Vector3> places_of_faults(const SolveReport::Singularity& graph) {
  std::vector<Vector3> places;
  for (const auto& corner : graph.corner_list)
    if (corner.verdict == Verdict::kNotMeshable) places.push_back(corner.place);
  for (const auto& node : graph.node_list)
    if (node.verdict == Verdict::kNotMeshable) places.push_back(node.place);
  for (const auto& arc : graph.arc_list)
    if (arc.verdict == Verdict::kNotMeshable) places.push_back(arc.place);
  return places;
}

/// Centres of the tets that a map flips, the most inverted first.
std::vector<Vector3> places_of_flips(const TetSolid& solid, const std::vector<double>& determinants) {
  std::vector<std::pair<double, std::size_t>> flipped;
  for (std::size_t t = 0; t < determinants.size(); ++t)
    if (!(determinants[t] > 0)) flipped.emplace_back(determinants[t], t);
  std::sort(flipped.begin(), flipped.end());
  std::vector<Vector3> places;
  for (const auto& [determinant, t] : flipped) {
    Vector3 centre{0, 0, 0};
    for (const std::uint32_t v : solid.mesh.tets[t]) centre += 0.25 * solid.mesh.vertices[v];
    places.push_back(centre);
  }
  return places;
}

}  // namespace

HexReport::Quality quality_of(const HexMesh& mesh) {
  HexReport::Quality quality;
  std::vector<double> values = scaled_jacobians(mesh);
  if (values.empty()) return quality;
  const auto worst = std::min_element(values.begin(), values.end());
  quality.least = *worst;
  quality.worst_place = centre_of(mesh, static_cast<std::size_t>(worst - values.begin()));
  for (const double value : values) {
    quality.mean += value / static_cast<double>(values.size());
    quality.inverted += is_inverted(value);
    quality.below_tenth += value < 0.1;
    quality.below_fifth += value < 0.2;
  }
  const auto hundredth = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 100);
  std::nth_element(values.begin(), hundredth, values.end());
  quality.one_percent = *hundredth;
  return quality;
}

void measure(const HexMesh& mesh, const TetSolid& model, HexReport& report) {
  report.hexahedra = mesh.hexahedra.size();
  report.vertices = mesh.vertices.size();
  report.bodies = count_bodies(mesh);
  const HexTopology topology = topology_of(mesh);
  report.crowded_faces = topology.crowded_faces;
  report.open_edges = topology.open_edges;
  report.pinched_vertices = topology.pinched_vertices;
  report.inner_valences = topology.inner_valences;
  report.boundary_valences = topology.boundary_valences;
  report.quality = quality_of(mesh);
  measure_fit(mesh, model, report);
}

void explain(const HexCandidate& best, HexReport& report) {
  if (report.outcome == HexOutcome::kAllHex) return;
  const HexAttempt& attempt = best.attempt;
  const std::size_t flips = attempt.flips.value_or(0);
  if (attempt.faults > 0) {
    report.places = places_of_faults(best.followed->field().report().onto->singularity);
    report.reason = fmt::format("no map: no hexahedra can meet at {}",
                                counted(attempt.faults, "edge or vertex", "edges and vertices"));
    report.remedy = "tets of another size, or a model without its sharpest corners";
  } else if (attempt.arcs_without_length > 0) {
    report.places = best.followed->arcs_without_length();
    report.reason =
        fmt::format("no map: {} would have no length, since both ends are on one layer of hexahedra",
                    counted(attempt.arcs_without_length, "singular arc"));
    report.remedy = "tets of another size";
  } else if (flips > 0) {
    report.places = places_of_flips(best.followed->solid(), best.following->determinants);
    const bool by_rounding = attempt.is_folded_by_rounding();
    report.reason = fmt::format("no map: {} inverted{}", counted(flips, "tet stays", "tets stay"),
                                by_rounding ? " with whole numbers of hexahedra" : "");
    report.remedy = by_rounding ? "a smaller size of hexahedra" : "tets of another size";
  } else if (best.following->extracted.left_out > 0) {
    report.reason =
        fmt::format("no map: it covers {} more than once, or without a corner",
                    counted(best.following->extracted.left_out, "cell of the grid", "cells of the grid"));
    report.remedy = "another size of hexahedra";
  } else if (report.quality.inverted > 0) {
    report.places = {report.quality.worst_place};
    report.reason =
        fmt::format("{} inverted", counted(report.quality.inverted, "hexahedron is", "hexahedra are"));
    report.remedy = "a smaller size of hexahedra";
  } else {
    report.reason = "the hexahedra do not close up";
    report.remedy = "another size of hexahedra";
  }
  if (report.places.size() > HexReport::kMostPlaces) report.places.resize(HexReport::kMostPlaces);
  if (report.places.empty()) return;
  const Vector3& at = report.places.front();
  report.reason += fmt::format("{} at {:.4g} {:.4g} {:.4g}", report.places.size() > 1 ? ", the first" : ",",
                               at[0], at[1], at[2]);
}

std::string end_of(const HexCandidate& candidate, double least_quality) {
  HexReport report;
  report.outcome = candidate.attempt.outcome;
  if (candidate.made) report.quality = candidate.made->quality;
  if (report.outcome != HexOutcome::kAllHex) {
    if (!candidate.followed) return "no mesh";
    explain(candidate, report);
    return report.reason + (candidate.unmended.empty() ? "" : ", with any of the repairs");
  }
  const std::string what =
      fmt::format("{} the model", candidate.attempt.hexahedra == 1
                                      ? "1 hexahedron fills"
                                      : fmt::format("{} hexahedra fill", candidate.attempt.hexahedra));
  if (candidate.made->is_coarse) return what + ", far fewer than asked for";
  if (report.quality.least >= least_quality) return what;
  return what + fmt::format(", the worst with a scaled Jacobian of {:.2g}", report.quality.least);
}

}  // namespace crossgrain
