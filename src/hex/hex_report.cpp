// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/names.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/place.hpp"
#include "hex/attempt_kinds.hpp"
#include "hex/field_mapping.hpp"
#include "hex/model_fit.hpp"
#include "measure/fault_words.hpp"
#include "measure/hex_faces.hpp"
#include "measure/hex_quality.hpp"
#include "measure/hex_validity.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

/// Centres of the tets that a map flips, the most inverted first.
std::vector<Vector3> places_of_flips(const TetSolid& solid, const std::vector<double>& determinants) {
  std::vector<std::pair<double, std::size_t>> flipped;
  for (std::size_t t = 0; t < determinants.size(); ++t)
    if (!(determinants[t] > 0)) flipped.emplace_back(determinants[t], t);
  std::sort(flipped.begin(), flipped.end());
  std::vector<Vector3> places;
  for (const auto& [determinant, t] : flipped) {
    places.push_back(centroid_of_tet(solid.mesh, t));
  }
  return places;
}

/// Why a result is not whole.
struct Explanation {
  std::string reason, detail;
  Remedy remedy = Remedy::kNone;
  std::vector<Vector3> places = {};
  bool has_faces = false;  ///< the reason names faces
};

/// The first fault of a repaired field: of the surface before those inside. Only what is sharp can be made
/// less so: tets of a further size are one more draw, which helps too seldom to be advised
/// (docs/notes/hexahedra.md).
Explanation first_fault(const SolveReport::Singularity& graph, const FaceNoun& noun) {
  Explanation result;
  result.places = places_of_faults(graph);
  const auto take_first = [&](const auto& parts, const auto& remedy_of, bool has_faces) {
    for (const auto& part : parts) {
      if (part.verdict != Verdict::kNotMeshable || !result.reason.empty()) continue;
      if constexpr (requires { fault_of(part, noun); })
        result.reason = fault_of(part, noun);
      else
        result.reason = fault_of(part);
      result.remedy = remedy_of(part);
      result.has_faces = has_faces;
    }
  };
  const auto of_field = [](const auto&) { return Remedy::kNone; };
  take_first(
      graph.crease_list, [](const auto&) { return Remedy::kRoundEdge; }, true);
  take_first(
      graph.corner_list,
      [](const auto& corner) { return corner.creases.empty() ? Remedy::kNone : Remedy::kCutCorner; }, true);
  take_first(graph.node_list, of_field, false);
  take_first(graph.arc_list, of_field, false);
  return result;
}

Explanation explanation_of(const HexCandidate& best, const HexReport& report) {
  const HexAttempt& attempt = best.attempt;
  if (best.made && best.made->fills)
    return {
        fmt::format("they fill the model, but {} turned inside out",
                    report.quality.inverted == 1 ? "one is" : fmt::format("{} are", report.quality.inverted)),
        fmt::format("{} inverted after smoothing",
                    counted(report.quality.inverted, "hexahedron", "hexahedra")),
        Remedy::kNone, places_of_inverted(best.made->mesh)};
  if (attempt.faults > 0) {
    const SolveReport& field = best.followed->field().report();
    Explanation fault = first_fault(field.onto->singularity, noun_of(field.faces));
    fault.detail = fmt::format("none: no hexahedra can meet at {}",
                               counted(attempt.faults, "edge or vertex", "edges and vertices"));
    return fault;
  }
  if (attempt.arcs_without_length > 0)
    return {"hexahedra would be flat",
            fmt::format("none: {} would have no length, since both ends are on one layer of hexahedra",
                        counted(attempt.arcs_without_length, "singular arc")),
            Remedy::kNone, best.followed->arcs_without_length()};
  const std::size_t flips = attempt.flips.value_or(0);
  if (flips > 0) {
    const bool by_rounding = attempt.is_folded_by_rounding();
    return {by_rounding ? "hexahedra of this size would be turned inside out"
                        : "hexahedra would be turned inside out",
            fmt::format("{} inverted{}", counted(flips, "tet stays", "tets stay"),
                        by_rounding ? " with whole numbers of hexahedra" : ""),
            Remedy::kNone, places_of_flips(best.followed->solid(), best.following->determinants)};
  }
  if (const std::vector<std::uint32_t>& left_out = best.following->extracted.left_out; !left_out.empty()) {
    std::vector<Vector3> places;
    for (const std::uint32_t t : left_out) places.push_back(centroid_of_tet(best.followed->solid().mesh, t));
    return {"a hexahedron would overlap others, or lack a corner",
            fmt::format("{} of the grid, covered more than once or without a corner",
                        counted(left_out.size(), "cell")),
            Remedy::kNone, std::move(places)};
  }
  return {"hexahedra leave gaps, or cut off parts of the model", "", Remedy::kNone};
}

std::vector<Vector3> shown_places(const Explanation& why) {
  std::vector<Vector3> places = why.places;
  if (places.size() > HexReport::kMostPlaces) places.resize(HexReport::kMostPlaces);
  return places;
}

/// Numbers of the faces of the model within a distance of a place, of a nearest one at least.
std::vector<std::int32_t> faces_near(const TetSolid& solid, const Vector3& place, double distance) {
  const std::vector<std::int32_t> tags = tags_of_faces(solid.mesh, solid.boundary);
  std::map<std::int32_t, double> nearest;
  for (std::size_t k = 0; k < tags.size(); ++k) {
    const auto& [a, b, c] = solid.boundary[k];
    const std::array corners{solid.mesh.vertices[a], solid.mesh.vertices[b], solid.mesh.vertices[c]};
    const double away = norm(nearest_on_triangle(corners, place) - place);
    const auto known = nearest.emplace(tags[k], away).first;
    known->second = std::min(known->second, away);
  }
  std::vector<std::pair<double, std::int32_t>> by_distance;
  for (const auto& [face, away] : nearest)
    if (face != 0) by_distance.emplace_back(away, face);
  std::ranges::sort(by_distance);
  std::vector<std::int32_t> faces;
  for (const auto& [away, face] : by_distance)
    if (faces.empty() || away <= distance) faces.push_back(face);
  return faces;
}

/// Returns " at 1 2 3, near faces 4 and 5, and at 2 other places".
std::string words_of_places(const std::vector<Vector3>& places, const HexCandidate& best, bool with_faces) {
  if (places.empty()) return "";
  const Vector3& at = places.front();
  const SolveReport& field = best.followed->field().report();
  std::string text = " at " + words_of_place(at, longest_side(field.model.bounding_box));
  const double reach = best.attempt.size > 0 ? best.attempt.size : best.asked_size;
  const std::string faces =
      with_faces ? words_of_faces(faces_near(best.followed->solid(), at, reach), noun_of(field.faces)) : "";
  if (!faces.empty()) text += ", near " + faces;
  return places.size() == 1 ? text : text + ", and at " + counted(places.size() - 1, "other place");
}

}  // namespace

std::vector<Vector3> places_of_inverted(const HexMesh& mesh) {
  const std::vector<std::uint8_t> is_inverted = inverted_hexahedra(mesh);
  std::vector<std::pair<double, std::size_t>> inverted;
  for (std::size_t k = 0; k < is_inverted.size(); ++k)
    if (is_inverted[k]) inverted.emplace_back(least_jacobian(corners_of(mesh, k)).upper, k);
  std::sort(inverted.begin(), inverted.end());
  std::vector<Vector3> places;
  for (const auto& [least, k] : inverted) places.push_back(centre_of(mesh, k));
  return places;
}

Warning ended_at(const Error& limit) {
  return {WarningKind::kAttemptLimited,
          {limit.file(), "", "an attempt at better hexahedra ended early: " + limit.text(), limit.remedy()}};
}

HexReport::Quality quality_of(const HexMesh& mesh) {
  HexReport::Quality quality;
  std::vector<double> values = scaled_jacobians(mesh);
  if (values.empty()) return quality;
  const auto worst = std::min_element(values.begin(), values.end());
  quality.least = *worst;
  quality.worst_place = centre_of(mesh, static_cast<std::size_t>(worst - values.begin()));
  for (const std::uint8_t is_inverted : inverted_hexahedra(mesh)) quality.inverted += is_inverted;
  for (const double value : values) {
    quality.mean += value / static_cast<double>(values.size());
    quality.below_tenth += value < 0.1;
    quality.below_fifth += value < 0.2;
  }
  const ShortestEdge shortest = shortest_edge(mesh);
  quality.shortest_edge = shortest.length;
  quality.shortest_edge_place = shortest.place;
  const auto hundredth = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 100);
  std::nth_element(values.begin(), hundredth, values.end());
  quality.one_percent = *hundredth;
  return quality;
}

void measure(const HexMesh& mesh, const TetSolid& model, FitTo fit_to, HexReport& report) {
  report.hexahedra = mesh.hexahedra.size();
  report.vertices = mesh.vertices.size();
  report.mean_edge = mean_edge(mesh);
  report.bodies = count_bodies(mesh);
  const HexTopology topology = topology_of(mesh);
  report.crowded_faces = topology.crowded_faces;
  report.open_edges = topology.open_edges;
  report.pinched_vertices = topology.pinched_vertices;
  report.inner_valences = topology.inner_valences;
  report.boundary_valences = topology.boundary_valences;
  report.quality = quality_of(mesh);
  measure_fit(mesh, model, fit_to, report);
}

void advise_smaller(HexReport& report) {
  report.remedy = Remedy::kUseHexSize;
  report.remedy_number = next_smaller_size(report.used_size);
}

void explain_shapes(double least_quality, HexReport& report) {
  if (report.quality.least >= least_quality) return;
  report.reason += fmt::format("{}badly shaped (worst scaled Jacobian {:.2g} at {})",
                               report.reason.empty() ? "" : "; it is ", report.quality.least,
                               words_of_place(report.quality.worst_place));
  report.places.insert(report.places.begin(), report.quality.worst_place);
  if (report.remedy == Remedy::kNone) advise_smaller(report);
}

void explain(const HexCandidate& best, HexReport& report) {
  report.reason.clear();
  if (report.outcome == HexOutcome::kAllHex) return;
  const Explanation why = explanation_of(best, report);
  report.places = shown_places(why);
  report.reason = why.reason + words_of_places(report.places, best, !why.has_faces);
  report.detail = why.detail;
  report.remedy = why.remedy;
  if (report.remedy == Remedy::kNone) advise_smaller(report);
}

EndWords end_of(const HexCandidate& candidate, double least_quality) {
  if (!candidate.text.empty()) return {candidate.text, ""};
  HexReport report;
  report.outcome = candidate.attempt.outcome;
  if (candidate.made) report.quality = candidate.made->quality;
  const bool is_complete = candidate.made && candidate.made->are_complete();
  if (!is_complete) {
    if (!candidate.followed) return {"no mesh", ""};
    const std::size_t of_part = candidate.made ? candidate.made->mesh.hexahedra.size() : 0;
    if (candidate.attempt.kind == kPartOfModel && of_part > 0)
      return {counted(of_part, "hexahedron fills", "hexahedra fill") + " a part of the model", ""};
    const Explanation why = explanation_of(candidate, report);
    const std::string where = words_of_places(shown_places(why), candidate, /*with_faces=*/false);
    return {why.reason + where, where.empty() ? "" : why.reason};
  }
  const std::size_t hexahedra = candidate.made->mesh.hexahedra.size();
  const std::string what = fmt::format(
      "{} the model", hexahedra == 1 ? "1 hexahedron fills" : fmt::format("{} hexahedra fill", hexahedra));
  if (candidate.made->is_coarse) return {what + ", far fewer than asked for", ""};
  if (!candidate.made->is_faithful) return {what + ", but do not keep all of it", ""};
  if (report.quality.least >= least_quality) return {what, ""};
  return {what + fmt::format(", the worst with a scaled Jacobian of {:.2g}", report.quality.least), ""};
}

}  // namespace crossgrain
