// SPDX-License-Identifier: Apache-2.0
#include "measure/crease_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "crossgrain/place.hpp"
#include "measure/alignment.hpp"
#include "measure/angle_statistics.hpp"
#include "surface/edge_uses.hpp"
#include "surface/faded_creases.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

/// Largest number of curves at a corner that one frame can follow: three faces at right angles.
constexpr std::size_t kCurvesOfAFrame = 3;

bool is_crowded(const CreaseCorner& corner) {
  return corner.directions > kCurvesOfAFrame;
}

struct Place {
  Vector3 position, tangent;
  double length;  ///< length of its part of the curve, positive
};

/// Adds the middles of equal parts of all segments of a curve.
void add_places(const CreaseCurve& curve, double step, std::vector<Place>& places) {
  for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
    const Vector3 along = curve.points[k + 1] - curve.points[k];
    if (norm(along) == 0) continue;
    const int parts = std::max(1, static_cast<int>(std::ceil(norm(along) / step)));
    for (int part = 0; part < parts; ++part) {
      const double t = (part + 0.5) / parts;
      const Vector3 tangent = (1 - t) * curve.tangents[k] + t * curve.tangents[k + 1];
      places.push_back({curve.points[k] + t * along, normalised(tangent), norm(along) / parts});
    }
  }
}

double length_of(const CreaseCurve& curve) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < curve.points.size(); ++k)
    sum += norm(curve.points[k + 1] - curve.points[k]);
  return sum;
}

/// The sharp curves of the surface and the inner faces. Each numbers its vertices by itself: the surface may
/// have been welded.
std::vector<CreaseCurve> curves_of(const Surface& surface, std::span<const EdgeUse> uses,
                                   const TriangleMesh& inner, const CreaseAngles& angles) {
  if (inner.triangles.empty()) return sharp_curves(surface, uses, angles);
  TriangleMesh both{surface.mesh.vertices, surface.mesh.triangles};
  const auto offset = static_cast<std::uint32_t>(both.vertices.size());
  both.vertices.insert(both.vertices.end(), inner.vertices.begin(), inner.vertices.end());
  for (const auto& [a, b, c] : inner.triangles)
    both.triangles.push_back({a + offset, b + offset, c + offset});
  return sharp_curves(prepare_surface(CheckedMesh::derived(weld(std::move(both)))), angles);
}

/// The curves without duplicates: solids that share a face in space but not in the file have its edges twice.
std::vector<CreaseCurve> without_repeats(const std::vector<CreaseCurve>& curves) {
  std::set<std::vector<Vector3>> seen;
  std::vector<CreaseCurve> result;
  for (const CreaseCurve& curve : curves) {
    std::vector<Vector3> points = curve.points;
    if (!points.empty() && points.back() < points.front()) std::ranges::reverse(points);
    if (seen.insert(std::move(points)).second) result.push_back(curve);
  }
  return result;
}

/// Returns the words before a place.
const char* first_at(std::size_t count) {
  return count == 1 ? "at" : "the first at";
}

}  // namespace

CreaseNetwork::CreaseNetwork(const Surface& surface, const TriangleMesh& inner, const CreaseAngles& angles,
                             bool inside_out) {
  const std::vector<EdgeUse> uses = sorted_edge_uses(surface.mesh.triangles);
  curves = surface.mesh.creases.empty() ? curves_of(surface, uses, inner, angles)
                                        : without_repeats(surface.mesh.creases);
  corners = corners_of(curves);
  if (surface.mesh.creases.empty() && inner.triangles.empty())
    faded = faded_crease_warning(surface, uses, angles);
  knives = knife_edges(surface, uses, inside_out);
}

SolveReport::Creases crease_report(const CreaseNetwork& creases, const PlaceSampler& sampler, double step) {
  SolveReport::Creases report;
  report.curves = creases.curves.size();
  report.corners = creases.corners.size();
  for (const CreaseCorner& corner : creases.corners) {
    if (is_crowded(corner) && report.crowded_corners++ < KnifeEdges::kMostPlaces)
      report.crowded_corner_places.push_back(corner.position);
  }
  report.knife_edges = creases.knives.count;
  report.knife_edge_places = creases.knives.places;
  std::vector<Place> places;
  for (const CreaseCurve& curve : creases.curves) {
    report.length += length_of(curve);
    add_places(curve, step, places);
  }
  std::vector<Vector3> positions;
  for (const Place& place : places) positions.push_back(place.position);
  const std::vector<Quaternion> frames = sampler.frames_at(positions);
  std::vector<WeightedAngle> angles_deg(places.size());
  parallel_for(places.size(), [&](std::size_t k) {
    angles_deg[k] = {angle_to_nearest_axis_deg(frames[k], places[k].tangent), places[k].length};
  });
  report.tangent_deg = summary_of(std::move(angles_deg));
  return report;
}

std::vector<Warning> crease_warnings(const CreaseNetwork& creases) {
  std::vector<Warning> warnings;
  if (creases.faded) warnings.push_back(*creases.faded);
  const auto crowded = std::ranges::find_if(creases.corners, is_crowded);
  if (crowded != creases.corners.end()) {
    const auto count = static_cast<std::size_t>(std::ranges::count_if(creases.corners, is_crowded));
    warnings.emplace_back(
        WarningKind::kCrowdedCorners,
        fmt::format("{} of more than three creases, {} {}: no frame has an axis across all "
                    "faces there",
                    counted(count, "corner"), first_at(count), words_of_place(crowded->position)));
  }
  if (creases.knives.count > 0) {
    warnings.emplace_back(
        WarningKind::kKnifeEdges,
        fmt::format("{} with less than 45 degrees of solid between two faces, {} {}: no frame "
                    "follows both",
                    counted(creases.knives.count, "edge"), first_at(creases.knives.count),
                    words_of_place(creases.knives.places[0])));
  }
  return warnings;
}

}  // namespace crossgrain
