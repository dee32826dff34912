// SPDX-License-Identifier: Apache-2.0
#include "analysis/interface_report.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/alignment.hpp"
#include "analysis/angle_statistics.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "surface/surface.hpp"

namespace crossgrain {
namespace {

/// Parts along an edge at most: a triangle across a grid of 2^19 cells would else have more than memory.
constexpr int kMostParts = 512;

struct Place {
  Vector3 position, normal;
  double area;
};

/// The centroids of the n^2 equal parts that lines along its edges cut a triangle into.
void add_places(const std::array<Vector3, 3>& corners, const std::array<Vector3, 3>& normals, double step,
                std::vector<Place>& places) {
  const auto& [a, b, c] = corners;
  const double longest = std::max({norm(b - a), norm(c - b), norm(a - c)});
  const int parts = std::clamp(static_cast<int>(std::ceil(longest / step)), 1, kMostParts);
  const double area = shape_of(corners).area / (parts * parts);
  const auto add = [&](double u, double v) {
    const Vector3 normal = (1 - u - v) * normals[0] + u * normals[1] + v * normals[2];
    places.push_back({a + u * (b - a) + v * (c - a), normalised(normal), area});
  };
  for (int i = 0; i < parts; ++i) {
    for (int j = 0; i + j < parts; ++j) {
      add((i + 1.0 / 3) / parts, (j + 1.0 / 3) / parts);
      if (i + j + 1 < parts) add((i + 2.0 / 3) / parts, (j + 2.0 / 3) / parts);
    }
  }
}

}  // namespace

std::optional<SolveReport::Interfaces> interface_report(const TriangleMesh& inner, const Sampler& sampler,
                                                        double step) {
  if (inner.triangles.empty()) return std::nullopt;
  std::vector<Place> places;
  for (std::size_t t = 0; t < inner.triangles.size(); ++t) {
    const auto& [a, b, c] = inner.triangles[t];
    add_places({inner.vertices[a], inner.vertices[b], inner.vertices[c]}, inner.corner_normals[t], step,
               places);
  }
  std::vector<float> angles_deg(places.size());
  std::vector<SurfacePiece> pieces(places.size());
  parallel_for(places.size(), [&](std::size_t k) {
    const auto& [position, normal, area] = places[k];
    angles_deg[k] = static_cast<float>(angle_to_nearest_axis_deg(sampler.at(position).frame, normal));
    pieces[k] = {0, static_cast<float>(area)};
  });
  SolveReport::Interfaces report;
  for (const Place& place : places) report.area += place.area;
  const SolveReport::Alignment alignment = angle_statistics(pieces, angles_deg);
  report.mean = alignment.mean;
  report.p95 = alignment.p95;
  report.max = alignment.max;
  return report;
}

}  // namespace crossgrain
