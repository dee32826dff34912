// SPDX-License-Identifier: Apache-2.0
#include "fit/corner_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "fit/least_assignment.hpp"
#include "fit/nowhere.hpp"

namespace crossgrain {
namespace {

// Costs beside the distance in sizes. A missing edge is worth a quarter of a size, since a pillow or another
// way of the curve mends it; an order of edges that does not fit may leave a face without quads.
constexpr double kCornerReach = 3, kMissingEdge = 0.25, kUnfit = 0.75, kExitTurn = 0.5, kOtherNormal = 0.3;

/// More than any vertex within reach costs, so that no corner goes without in favour of others.
constexpr double kWithoutVertex = 1000;

/// Nearest vertices that a corner may have.
constexpr std::size_t kMostCornerCandidates = 12;

using NearVertex = std::pair<double, std::uint32_t>;  // distance, vertex

std::vector<NearVertex> near_vertices(const HexMesh& mesh, const QuadComplex& surface, const Vector3& point,
                                      std::uint32_t set, const SolidSets& sets, double size) {
  std::vector<NearVertex> near;
  for (const std::uint32_t v : surface.vertices()) {
    if (sets.of_vertex[v] != set) continue;
    const double distance = norm(mesh.vertices[v] - point) / size;
    if (distance <= kCornerReach) near.emplace_back(distance, v);
  }
  std::ranges::sort(near);
  if (near.size() > kMostCornerCandidates) near.resize(kMostCornerCandidates);
  return near;
}

/// Unit normals of the model at corners, by the angles of their triangles.
std::vector<Vector3> normals_at_corners(const FeatureComplex& features) {
  std::vector<std::uint32_t> corner_at(features.vertices.size(), kNowhere);
  for (std::uint32_t c = 0; c < features.corners.size(); ++c) corner_at[features.corners[c].vertex] = c;
  std::vector<Vector3> normals(features.corners.size(), Vector3{});
  for (std::size_t t = 0; t < features.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t corner = corner_at[features.triangles[t][k]];
      if (corner == kNowhere) continue;
      const auto points = features.points_of(t);
      const Vector3 a = points[(k + 1) % 3] - points[k], b = points[(k + 2) % 3] - points[k];
      const Vector3 area = cross(a, b);
      normals[corner] += std::atan2(norm(area), dot(a, b)) * normalised(area);
    }
  }
  for (Vector3& normal : normals) normal = normalised(normal);
  return normals;
}

Vector3 vertex_normal(const HexMesh& mesh, const QuadComplex& surface, std::uint32_t vertex) {
  Vector3 sum{};
  for (const std::uint32_t quad : surface.quads_of(vertex)) sum += area_vector(mesh, surface.quads()[quad]);
  return normalised(sum);
}

}  // namespace

CornerVertices corner_vertices(const HexMesh& mesh, const QuadComplex& surface,
                               const FeatureComplex& features, const SolidSets& sets, double size) {
  const std::size_t count = features.corners.size();
  const std::vector<Vector3> normals = normals_at_corners(features);
  const ExitSearch search(mesh, surface, features, sets, size);
  std::vector<std::vector<std::pair<AssignmentChoice, CornerExits>>> choices(count);
  parallel_for(
      count,
      [&](std::size_t c) {
        const auto corner = static_cast<std::uint32_t>(c);
        const std::uint32_t set = sets.of_corner[c];
        for (const auto& [distance, v] :
             near_vertices(mesh, surface, features.corners[c].point, set, sets, size)) {
          CornerExits exits = search.exits(corner, v);
          double cost =
              distance + kMissingEdge * static_cast<double>(exits.missing) + kExitTurn * exits.mean_turn;
          if (!exits.fits) cost += kUnfit;
          if (sets.sizes[set] == 2)
            cost += kOtherNormal * std::max(0.0, 0.5 - dot(normals[c], vertex_normal(mesh, surface, v)));
          choices[c].emplace_back(AssignmentChoice{corner, v, cost}, std::move(exits));
        }
      },
      1);
  std::vector<AssignmentChoice> all;
  for (const auto& of_corner : choices)
    for (const auto& [choice, exits] : of_corner) all.push_back(choice);
  CornerVertices result{least_assignment(count, all, kWithoutVertex), std::vector<CornerExits>(count)};
  for (std::size_t c = 0; c < count; ++c) {
    result.exits[c].edges.assign(features.corners[c].ends.size(), kNowhere);
    for (auto& [choice, exits] : choices[c])
      if (choice.column == result.vertices[c]) result.exits[c] = std::move(exits);
  }
  return result;
}

}  // namespace crossgrain
