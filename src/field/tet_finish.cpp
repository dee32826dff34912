// SPDX-License-Identifier: Apache-2.0
#include "field/tet_finish.hpp"

#include <cmath>
#include <functional>
#include <memory>

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
  connectivity.order = greedy_colouring(connectivity.adjacency);
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
                          const OntoOptions& options, std::span<const VertexGuide> guides) {
  CellForms<D> forms(adjacency.size());
  std::vector<std::uint32_t> creases;
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    if (is_held(boundary, k)) {
      forms.hold_axis(boundary.vertices[k], boundary.normals[k]);
    } else if (options.boundary == TetBoundary::kAll && !boundary.faces_at(k).empty()) {
      creases.push_back(boundary.vertices[k]);
      places.push_back(k);
    }
  }
  std::vector<std::uint32_t> generals = guided_vertices(guides);
  generals.insert(generals.end(), creases.begin(), creases.end());
  forms.reserve_general(generals);
  set_guides(forms, adjacency, guides);
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
    Quaternion& frame = frames[boundary.vertices[k]];
    if (is_held(boundary, k)) frame = with_axis_along(frame, boundary.normals[k]);
  });
}

Frames stored(const std::vector<Quaternion>& frames) {
  Frames result(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) result[i] = to_stored(frames[i]);
  return result;
}

/// In double precision, and with the axes that are held in that precision too.
std::vector<Quaternion> aligned(const BoundaryVertices& boundary, const Frames& frames) {
  std::vector<Quaternion> result(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) result[i] = from_stored(frames[i]);
  align_held(boundary, result);
  return result;
}

template <int D>
FieldGraph<D> graph_of(const std::shared_ptr<const Connectivity>& connectivity,
                       const BoundaryVertices& boundary, const OntoOptions& options,
                       std::span<const VertexGuide> guides) {
  return {connectivity, vertex_forms<D>(connectivity->adjacency, boundary, options, guides)};
}

/// Relaxes in degree 4 for both degrees, as on the grid, and settles in the field's own.
template <int D>
SettledFrames solved(const std::shared_ptr<const Connectivity>& connectivity,
                     const BoundaryVertices& boundary, Frames frames, const OntoOptions& options,
                     std::span<const VertexGuide> guides, const SweepMonitor& after_sweep) {
  const FieldGraph<D> graph = graph_of<D>(connectivity, boundary, options, guides);
  std::function<Frames(Frames)> relax;
  if (options.relaxation_sweeps > 0) {
    relax = [&](Frames came) {
      const RelaxationPlan plan{options.relaxation_sweeps, options.symmetrisation, options.over_relaxation};
      if constexpr (D == 4) {
        came = relaxed(graph, std::move(came), plan, after_sweep);
      } else {
        came =
            relaxed(graph_of<4>(connectivity, boundary, options, guides), std::move(came), plan, after_sweep);
      }
      return stored(aligned(boundary, came));
    };
  }
  const SettlingPlan settling{options.most_sweeps, options.over_relaxation, options.sweep_tolerance,
                              rounding_noise(connectivity->adjacency)};
  return relaxed_and_settled(graph, std::move(frames), relax, settling, after_sweep);
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

TetFrames finish_on_tets(const std::vector<StiffnessEdge>& edges, const BoundaryVertices& boundary,
                         std::vector<Quaternion> start, Degree degree, const OntoOptions& options,
                         const Monitor& monitor, const std::vector<VertexGuide>& guides) {
  const auto connectivity = connectivity_of(start.size(), edges);
  int sweeps = 0;
  const SweepMonitor after_sweep = [&](double energy) {
    monitor.check();
    monitor.report({"tets", 0, start.size(), ++sweeps, energy});
  };
  align_held(boundary, start);
  const SettledFrames result =
      degree == Degree::kThree
          ? solved<3>(connectivity, boundary, stored(start), options, guides, after_sweep)
          : solved<4>(connectivity, boundary, stored(start), options, guides, after_sweep);
  return {aligned(boundary, result.frames), result.settled};
}

}  // namespace crossgrain
