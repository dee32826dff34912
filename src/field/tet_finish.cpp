// SPDX-License-Identifier: Apache-2.0
#include "field/tet_finish.hpp"

#include <cmath>
#include <memory>

#include "base/parallel.hpp"
#include "constraint/normal_form.hpp"
#include "field/energy.hpp"
#include "field/manifold_sweep.hpp"

namespace crossgrain {
namespace {

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

void align_held(const BoundaryVertices& boundary, std::vector<Quaternion>& frames) {
  parallel_for(boundary.size(), [&](std::size_t k) {
    if (!is_held(boundary, k)) return;
    Quaternion& frame = frames[boundary.vertices[k]];
    frame = with_axis_along(frame, boundary.normals[k]);
  });
}

template <int D>
std::vector<Quaternion> finish_in_degree(const TetSolid& solid, const std::vector<StiffnessEdge>& edges,
                                         const BoundaryVertices& boundary, std::vector<Quaternion> frames,
                                         const TetFinishOptions& options, const Monitor& monitor) {
  FieldGraph<D> graph{connectivity_of(solid.mesh.vertices.size(), edges), {}};
  graph.forms = vertex_forms<D>(graph.adjacency(), boundary, options);
  align_held(boundary, frames);
  std::vector<StoredQuaternion> stored(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) stored[i] = to_stored(frames[i]);
  FieldState<D> state = state_of<D>(std::move(stored));
  double energy = graph_energy(graph, state);
  for (int sweep = 0; sweep < options.most_sweeps; ++sweep) {
    const double decrease = manifold_sweep(graph, state);
    energy -= decrease;
    monitor.check();
    monitor.report({"tets", 0, graph.size(), sweep + 1, energy});
    if (decrease <= options.sweep_tolerance * energy) break;
  }
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i] = from_stored(state.frames[i]);
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
                                       const BoundaryVertices& boundary, std::vector<Quaternion> start,
                                       Degree degree, const TetFinishOptions& options,
                                       const Monitor& monitor) {
  return degree == Degree::kThree
             ? finish_in_degree<3>(solid, edges, boundary, std::move(start), options, monitor)
             : finish_in_degree<4>(solid, edges, boundary, std::move(start), options, monitor);
}

}  // namespace crossgrain
