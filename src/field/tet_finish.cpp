// SPDX-License-Identifier: Apache-2.0
#include "field/tet_finish.hpp"

#include <cmath>
#include <memory>
#include <type_traits>

#include "base/parallel.hpp"
#include "constraint/normal_form.hpp"
#include "field/stages.hpp"

namespace crossgrain {
namespace {

using Frames = std::vector<StoredQuaternion>;

std::shared_ptr<const Connectivity> connectivity_of(std::size_t vertex_count,
                                                    const std::vector<StiffnessEdge>& edges) {
  std::vector<WeightedEdge> weighted(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    weighted[e] = {edges[e].i, edges[e].j, static_cast<float>(edges[e].weight)};
  }
  Connectivity connectivity;
  connectivity.adjacency = Adjacency(vertex_count, weighted);
  connectivity.colouring = greedy_colouring(connectivity.adjacency);
  return std::make_shared<const Connectivity>(std::move(connectivity));
}

/// The form of a crease or corner: its faces by area, and a crease's tangent with half the weight of them
/// all.
template <int D>
QuadraticForm<D> crease_form(const BoundaryVertices& boundary, std::size_t k) {
  QuadraticForm<D> form;
  for (const FaceAtVertex& face : boundary.faces_at(k)) add_normal(form, face.normal, face.area_third);
  if (boundary.classes[k] == BoundaryClass::kCrease) add_axis(form, boundary.tangents[k], 0.5 * form.weight);
  return form;
}

bool is_held(const BoundaryVertices& boundary, std::size_t k) {
  return boundary.classes[k] == BoundaryClass::kSmooth && dot(boundary.normals[k], boundary.normals[k]) > 0;
}

template <int D>
CellForms<D> vertex_forms(const Adjacency& adjacency, const BoundaryVertices& boundary,
                          const TetFinishOptions& options) {
  CellForms<D> forms(adjacency.size());
  std::vector<std::uint32_t> creases;
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    if (is_held(boundary, k)) {
      forms.hold_axis(boundary.vertices[k], boundary.normals[k]);
    } else if (options.constrain_creases && !boundary.faces_at(k).empty()) {
      creases.push_back(boundary.vertices[k]);
      places.push_back(k);
    }
  }
  forms.reserve_general(creases);
  const double degree_factor = D == 3 ? 5.0 / 3 : 1.0;
  for (std::size_t c = 0; c < creases.size(); ++c) {
    double edge_weight = 0;
    for (const Adjacency::Neighbour& neighbour : adjacency[creases[c]])
      edge_weight += std::abs(neighbour.weight);
    const QuadraticForm<D> form = crease_form<D>(boundary, places[c]);
    forms.set_general(creases[c], form, degree_factor * options.crease_weight * edge_weight / form.weight);
  }
  return forms;
}

/// Turns the frames of held vertices so that they have the axis that is held.
void align_held(const BoundaryVertices& boundary, std::vector<Quaternion>& frames) {
  parallel_for(boundary.size(), [&](std::size_t k) {
    if (!is_held(boundary, k)) return;
    Quaternion& frame = frames[boundary.vertices[k]];
    frame = with_axis_along(frame, boundary.normals[k]);
  });
}

void align_held(const BoundaryVertices& boundary, Frames& frames) {
  parallel_for(boundary.size(), [&](std::size_t k) {
    if (!is_held(boundary, k)) return;
    StoredQuaternion& frame = frames[boundary.vertices[k]];
    frame = to_stored(with_axis_along(from_stored(frame), boundary.normals[k]));
  });
}

template <int D>
std::vector<Quaternion> finish_in_degree(const TetSolid& solid, const std::vector<StiffnessEdge>& edges,
                                         const BoundaryVertices& boundary,
                                         const std::vector<Quaternion>& start,
                                         const TetFinishOptions& options, const Monitor& monitor) {
  const auto connectivity = connectivity_of(solid.mesh.vertices.size(), edges);
  const auto graph_in = [&]<int R>(std::integral_constant<int, R>) {
    return FieldGraph<R>{connectivity, vertex_forms<R>(connectivity->adjacency, boundary, options)};
  };
  const FieldGraph<D> graph = graph_in(std::integral_constant<int, D>());
  int sweeps = 0;
  const SweepMonitor after_sweep = [&](double energy) {
    monitor.check();
    monitor.report({"tets", 0, graph.size(), ++sweeps, energy});
  };
  std::function<Frames(Frames)> relax;
  if (options.relaxation_sweeps > 0) {
    relax = [&](Frames frames) {
      // In degree 4 for both degrees, as on the grid.
      if constexpr (D == 4) {
        frames =
            relaxed(graph, std::move(frames), options.relaxation_sweeps, options.symmetrisation, after_sweep);
      } else {
        frames = relaxed(graph_in(std::integral_constant<int, 4>()), std::move(frames),
                         options.relaxation_sweeps, options.symmetrisation, after_sweep);
      }
      align_held(boundary, frames);
      return frames;
    };
  }
  const SettlingLimits limits{options.most_sweeps, options.sweep_tolerance,
                              rounding_noise(connectivity->adjacency)};

  Frames stored(start.size());
  for (std::size_t i = 0; i < start.size(); ++i) stored[i] = to_stored(start[i]);
  align_held(boundary, stored);
  stored = relaxed_and_settled(graph, std::move(stored), relax, limits, after_sweep).frames;
  std::vector<Quaternion> frames(stored.size());
  for (std::size_t i = 0; i < stored.size(); ++i) frames[i] = from_stored(stored[i]);
  // Sweeps are in single precision; the boundary is held in double.
  align_held(boundary, frames);
  return frames;
}

}  // namespace

Quaternion with_axis_along(const Quaternion& frame, const Vector3& direction) {
  const auto axes = axes_of(frame);
  Vector3 nearest = axes[0];
  for (const Vector3& axis : axes) {
    if (std::abs(dot(axis, direction)) > std::abs(dot(nearest, direction))) nearest = axis;
  }
  if (dot(nearest, direction) < 0) nearest = -nearest;
  const Vector3 turn = cross(nearest, direction);
  const double sine = norm(turn);
  if (sine == 0) return frame;
  const double angle_rad = std::atan2(sine, dot(nearest, direction));
  return normalised(from_rotation_vector((angle_rad / sine) * turn) * frame);
}

std::vector<Quaternion> finish_on_tets(const TetSolid& solid, const std::vector<StiffnessEdge>& edges,
                                       const BoundaryVertices& boundary, const std::vector<Quaternion>& start,
                                       Degree degree, const TetFinishOptions& options,
                                       const Monitor& monitor) {
  return degree == Degree::kThree ? finish_in_degree<3>(solid, edges, boundary, start, options, monitor)
                                  : finish_in_degree<4>(solid, edges, boundary, start, options, monitor);
}

}  // namespace crossgrain
