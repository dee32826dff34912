// SPDX-License-Identifier: Apache-2.0
#include "measure/interface_report.hpp"

#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "measure/alignment.hpp"
#include "measure/angle_statistics.hpp"
#include "surface/surface.hpp"

namespace crossgrain {
namespace {

/// Largest number of halvings of a triangle: without it, one across a grid of 2^19 cells would have more
/// parts than memory.
constexpr int kMostHalvings = 18;

struct InterfacePlace {
  Vector3 position, normal;
  double area;
};

/// Adds the centroids of the parts of a triangle that is halved across its longest edge while that is longer
/// than `step`. Long thin triangles, such as those of a cylinder, get no more parts than needed.
void add_places(const std::array<Vector3, 3>& corners, const std::array<Vector3, 3>& normals, double step,
                int halvings, std::vector<InterfacePlace>& places) {
  std::size_t longest = 0;
  const auto length = [&](std::size_t edge) { return norm(corners[(edge + 1) % 3] - corners[edge]); };
  for (std::size_t edge = 1; edge < 3; ++edge) {
    if (length(edge) > length(longest)) longest = edge;
  }
  if (halvings == 0 || length(longest) <= step) {
    const Vector3 centroid = (1.0 / 3) * (corners[0] + corners[1] + corners[2]);
    places.push_back({centroid, normalised(normals[0] + normals[1] + normals[2]), shape_of(corners).area});
    return;
  }
  const std::size_t from = longest, to = (longest + 1) % 3;
  for (const auto& [kept, moved] : {std::pair{from, to}, std::pair{to, from}}) {
    auto half = corners;
    auto half_normals = normals;
    half[moved] = 0.5 * (corners[kept] + corners[moved]);
    half_normals[moved] = 0.5 * (normals[kept] + normals[moved]);
    add_places(half, half_normals, step, halvings - 1, places);
  }
}

}  // namespace

std::optional<SolveReport::Interfaces> interface_report(const TriangleMesh& inner,
                                                        const PlaceSampler& sampler, double step) {
  if (inner.triangles.empty()) return std::nullopt;
  std::vector<InterfacePlace> places;
  for (std::size_t t = 0; t < inner.triangles.size(); ++t) {
    add_places(corners_of(inner.triangles[t], inner.vertices), inner.corner_normals[t], step, kMostHalvings,
               places);
  }
  std::vector<Vector3> positions;
  for (const InterfacePlace& place : places) positions.push_back(place.position);
  const std::vector<Quaternion> frames = sampler.frames_at(positions);
  std::vector<float> angles_deg(places.size());
  std::vector<SurfacePiece> pieces(places.size());
  parallel_for(places.size(), [&](std::size_t k) {
    const auto& [position, normal, area] = places[k];
    angles_deg[k] = static_cast<float>(angle_to_nearest_axis_deg(frames[k], normal));
    pieces[k] = {0, static_cast<float>(area)};
  });
  SolveReport::Interfaces report;
  for (const InterfacePlace& place : places) report.area += place.area;
  const SolveReport::Alignment alignment = angle_statistics(pieces, angles_deg, report.area);
  report.mean = alignment.mean.value_or(0);
  report.p95 = alignment.p95.value_or(0);
  report.max = alignment.max.value_or(0);
  return report;
}

}  // namespace crossgrain
