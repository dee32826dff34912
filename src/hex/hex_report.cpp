// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "base/names.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "hex/field_mapping.hpp"
#include "measure/hex_faces.hpp"
#include "measure/hex_quality.hpp"
#include "surface/bvh.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

/// Each face as four triangles around its centroid.
TriangleMesh triangles_of(const HexMesh& mesh) {
  TriangleMesh triangles;
  triangles.vertices = mesh.vertices;
  for (const HexMesh::Face& face : mesh.boundary) {
    Vector3 centre{0, 0, 0};
    for (const std::uint32_t v : face.vertices) centre += 0.25 * mesh.vertices[v];
    const auto middle = static_cast<std::uint32_t>(triangles.vertices.size());
    triangles.vertices.push_back(centre);
    for (std::size_t k = 0; k < 4; ++k)
      triangles.triangles.push_back({face.vertices[k], face.vertices[(k + 1) % 4], middle});
  }
  return triangles;
}

std::vector<double> distances_to(const TriangleBvh& tree, const std::vector<Vector3>& points) {
  std::vector<double> distances(points.size());
  parallel_for(points.size(),
               [&](std::size_t k) { distances[k] = std::sqrt(tree.nearest(points[k]).squared_distance); });
  return distances;
}

void measure_distances(const HexMesh& mesh, const Surface& model, HexReport& report) {
  std::vector<std::uint32_t> used;
  for (const HexMesh::Face& face : mesh.boundary)
    used.insert(used.end(), face.vertices.begin(), face.vertices.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  std::vector<Vector3> points;
  for (const std::uint32_t v : used) points.push_back(mesh.vertices[v]);
  const std::vector<double> distances = distances_to(TriangleBvh(model), points);
  report.largest_distance = *std::max_element(distances.begin(), distances.end());
  report.mean_distance =
      std::accumulate(distances.begin(), distances.end(), 0.0) / static_cast<double>(distances.size());

  report.largest_distance_of_model = largest_distance_to(mesh, model.mesh);
}

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

double largest_distance_to(const HexMesh& mesh, const TriangleMesh& surface) {
  std::vector<Vector3> points;
  for (const auto& triangle : surface.triangles) {
    Vector3 centroid{0, 0, 0};
    for (const std::uint32_t v : triangle) {
      points.push_back(surface.vertices[v]);
      centroid += (1.0 / 3) * surface.vertices[v];
    }
    points.push_back(centroid);
  }
  const Surface own = prepare_surface(CheckedMesh::derived(triangles_of(mesh)));
  const std::vector<double> distances = distances_to(TriangleBvh(own), points);
  return distances.empty() ? 0 : *std::max_element(distances.begin(), distances.end());
}

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
  const HexTopology topology = topology_of(mesh);
  report.crowded_faces = topology.crowded_faces;
  report.open_edges = topology.open_edges;
  report.pinched_vertices = topology.pinched_vertices;
  report.inner_valences = topology.inner_valences;
  report.boundary_valences = topology.boundary_valences;
  report.quality = quality_of(mesh);
  const std::vector<double> volumes = volumes_of(mesh);
  report.volume = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  report.area = boundary_area(mesh);
  report.model_volume = volume_of(model.mesh);
  TriangleMesh surface;
  surface.vertices = model.mesh.vertices;
  surface.triangles = model.boundary;
  const Surface prepared = prepare_surface(CheckedMesh::derived(std::move(surface)));
  report.model_area = std::accumulate(prepared.areas.begin(), prepared.areas.end(), 0.0);
  if (!mesh.boundary.empty()) measure_distances(mesh, prepared, report);
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
    return report.reason;
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
