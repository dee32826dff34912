// SPDX-License-Identifier: Apache-2.0
#include "measure/tet_evaluation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "base/elementary.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "harmonics/frame.hpp"
#include "measure/angle_statistics.hpp"
#include "singularity/matching.hpp"

namespace crossgrain {
namespace {

std::vector<Coefficients<4>> coefficients_of(std::span<const Quaternion> frames) {
  std::vector<Coefficients<4>> h(frames.size());
  parallel_for(h.size(), [&](std::size_t i) { h[i] = frame_coefficients<4>(frames[i]); });
  return h;
}

double squared_distance(const Coefficients<4>& a, const Coefficients<4>& b) {
  return squared_norm(difference(a, b));
}

/// The angle in degrees between a normal and the nearest axis. Axes are normalised, since the rounding of the
/// quaternion's norm would show in an arc cosine near 1.
double angle_deg(const Quaternion& frame, const Vector3& unit_normal) {
  double cosine = 0;
  for (const Vector3& axis : axes_of(frame))
    cosine = std::max(cosine, std::abs(dot(axis, unit_normal)) / norm(axis));
  return arc_cosine(std::min(cosine, 1.0)) * (180 / std::numbers::pi);
}

CubeRotation matching_of(const Quaternion& from, const Quaternion& to) {
  return nearest_cube_rotation(conjugate(to) * from);
}

bool is_singular(const Quaternion& a, const Quaternion& b, const Quaternion& c) {
  return !(matching_of(c, a) * (matching_of(b, c) * matching_of(a, b))).is_identity();
}

/// Number of singular faces among vertices_of(k), k < count.
template <class VerticesOf>
std::size_t count_singular(std::size_t count, std::span<const Quaternion> frames,
                           const VerticesOf& vertices_of) {
  return static_cast<std::size_t>(parallel_sum(count, [&](std::size_t k) {
    const auto& [a, b, c] = vertices_of(k);
    return is_singular(frames[a], frames[b], frames[c]) ? 1.0 : 0.0;
  }));
}

void measure_smoothness(std::span<const StiffnessEdge> edges, std::span<const Quaternion> frames,
                        VertexFieldEvaluation& result) {
  const std::vector<Coefficients<4>> h = coefficients_of(frames);
  const auto squared_change = [&](const StiffnessEdge& edge) {
    return squared_distance(h[edge.i], h[edge.j]);
  };
  result.dirichlet = 0.5 * parallel_sum(edges.size(), [&](std::size_t e) {
                       return edges[e].weight * squared_change(edges[e]);
                     });
  result.edge_sum = parallel_sum(edges.size(), [&](std::size_t e) { return squared_change(edges[e]); });
}

void measure_alignment(const BoundaryVertices& boundary, std::span<const Quaternion> frames,
                       VertexFieldEvaluation& result) {
  constexpr double kSmoothSpreadDeg = BoundaryVertexOptions{}.smooth_spread_deg;
  std::vector<double> at_smooth, at_creases;
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    const Quaternion& frame = frames[boundary.vertices[k]];
    if (boundary.spread_deg[k] < kSmoothSpreadDeg) {
      at_smooth.push_back(angle_deg(frame, boundary.normals[k]));
      continue;
    }
    for (const FaceAtVertex& face : boundary.faces_at(k)) at_creases.push_back(angle_deg(frame, face.normal));
  }
  result.normal_deg = summary_of(std::move(at_smooth));
  result.crease_deg = summary_of(std::move(at_creases));
}

/// Vector along the normal with twice the area as its length.
Vector3 area_vector(const TetMesh& mesh, const std::array<std::uint32_t, 3>& face) {
  const auto& [a, b, c] = face;
  return cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
}

Vector3 centroid(const TetMesh& mesh, std::uint32_t tet) {
  const auto& [a, b, c, d] = mesh.tets[tet];
  return 0.25 * (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c] + mesh.vertices[d]);
}

}  // namespace

VertexFieldEvaluation evaluate_vertex_field(const TetSolid& solid, const BoundaryVertices& boundary,
                                            std::span<const StiffnessEdge> edges,
                                            std::span<const Quaternion> frames) {
  assert(frames.size() == solid.mesh.vertices.size());
  VertexFieldEvaluation result;
  measure_smoothness(edges, frames, result);
  const auto inner_face = [&](std::size_t k) { return solid.inner_faces[k].vertices; };
  const auto boundary_face = [&](std::size_t k) { return solid.boundary[k]; };
  result.singular = {count_singular(solid.inner_faces.size(), frames, inner_face),
                     count_singular(solid.boundary.size(), frames, boundary_face)};
  measure_alignment(boundary, frames, result);
  return result;
}

std::optional<SolveReport::AngleSummary> angles_along(const TetSolid& solid,
                                                      std::span<const std::array<std::uint32_t, 2>> edges,
                                                      std::span<const Quaternion> frames) {
  std::vector<double> angles;
  for (const auto& [a, b] : edges) {
    const Vector3 direction = normalised(solid.mesh.vertices[b] - solid.mesh.vertices[a]);
    if (direction == Vector3{0, 0, 0}) continue;
    for (const std::uint32_t v : {a, b}) angles.push_back(angle_deg(frames[v], direction));
  }
  if (angles.empty()) return std::nullopt;
  return summary_of(std::move(angles));
}

double unfollowed_share(const TetSolid& solid, std::span<const Quaternion> frames, double limit_deg) {
  double all = 0, unfollowed = 0;
  for (std::size_t k = 0; k < solid.boundary.size(); ++k) {
    const std::uint32_t tet = solid.boundary_tets[k];
    const Vector3 area = area_vector(solid.mesh, solid.boundary[k]);
    if (tet == kNoTet || norm(area) == 0) continue;
    all += norm(area);
    if (angle_deg(frames[tet], normalised(area)) > limit_deg) unfollowed += norm(area);
  }
  return all > 0 ? unfollowed / all : 0;
}

CellFieldEvaluation evaluate_cell_field(const TetSolid& solid, std::span<const Quaternion> frames) {
  assert(frames.size() == solid.mesh.tets.size());
  const TetMesh& mesh = solid.mesh;
  const std::vector<Coefficients<4>> h = coefficients_of(frames);
  CellFieldEvaluation result;
  result.dirichlet = 0.5 * parallel_sum(solid.inner_faces.size(), [&](std::size_t k) {
                       const auto& [vertices, tets] = solid.inner_faces[k];
                       if (tets[1] == kNoTet) return 0.0;
                       const double area = 0.5 * norm(area_vector(mesh, vertices));
                       const double distance = norm(centroid(mesh, tets[0]) - centroid(mesh, tets[1]));
                       return area / distance * squared_distance(h[tets[0]], h[tets[1]]);
                     });
  std::vector<double> angles;
  for (std::size_t k = 0; k < solid.boundary.size(); ++k) {
    const std::uint32_t tet = solid.boundary_tets[k];
    if (tet == kNoTet) continue;
    const Vector3 normal = normalised(area_vector(mesh, solid.boundary[k]));
    angles.push_back(angle_deg(frames[tet], normal));
  }
  result.normal_deg = summary_of(std::move(angles));
  return result;
}

}  // namespace crossgrain
