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

bool is_zero(const Vector3& v) {
  return v == Vector3{0, 0, 0};
}

/// How frames at boundary vertices are constrained.
class Holds {
 public:
  Holds(const BoundaryVertices& boundary, TetBoundary which)
      : boundary_(boundary), all_(which == TetBoundary::kAll) {}

  /// Returns the axis that the frame of vertex k rotates about: the normal at a smooth vertex, the tangent at
  /// an edge inside. {0, 0, 0} if it is not restricted to one axis.
  Vector3 axis(std::size_t k) const {
    if (boundary_.classes[k] == BoundaryClass::kSmooth) return boundary_.normals[k];
    return all_ && boundary_.faces_at(k).empty() ? boundary_.tangents[k] : Vector3{0, 0, 0};
  }

  /// Returns whether normal and tagged edge fix the frame completely.
  bool is_pinned(std::size_t k) const {
    return all_ && boundary_.classes[k] == BoundaryClass::kSmooth && !is_zero(boundary_.tangents[k]);
  }

  /// Returns whether vertex k follows a form instead.
  bool has_form(std::size_t k) const {
    return all_ && (is_pinned(k) || (is_zero(axis(k)) && !boundary_.faces_at(k).empty()));
  }

  /// Rotates the frames of constrained vertices onto their axis; pinned ones onto both.
  void align(std::vector<Quaternion>& frames) const {
    parallel_for(boundary_.size(), [&](std::size_t k) {
      Quaternion& frame = frames[boundary_.vertices[k]];
      if (!is_zero(axis(k))) frame = with_axis_along(frame, axis(k));
      if (is_pinned(k)) frame = with_axis_along(frame, boundary_.tangents[k]);
    });
  }

  const BoundaryVertices& boundary() const { return boundary_; }

 private:
  const BoundaryVertices& boundary_;
  bool all_;
};

/// Weight of the form of a pinned vertex relative to the sum of its edge weights: the frame stays within a
/// degree of it, and is rotated onto it in the end.
constexpr double kPinnedWeight = 100;

/// Returns the form of a crease, corner or pinned vertex: its faces by area, and the tangent with half their
/// total weight.
template <int D>
QuadraticForm<D> crease_form(const BoundaryVertices& boundary, std::size_t k) {
  QuadraticForm<D> form;
  for (const FaceAtVertex& face : boundary.faces_at(k)) add_normal(form, face.normal, face.area_third);
  if (!is_zero(boundary.tangents[k])) add_axis(form, boundary.tangents[k], 0.5 * form.weight);
  return form;
}

template <int D>
CellForms<D> vertex_forms(const Adjacency& adjacency, const Holds& holds, const OntoOptions& options,
                          std::span<const VertexGuide> guides) {
  const BoundaryVertices& boundary = holds.boundary();
  CellForms<D> forms(adjacency.size());
  std::vector<std::uint32_t> creases;
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    if (holds.has_form(k)) {
      creases.push_back(boundary.vertices[k]);
      places.push_back(k);
    } else if (!is_zero(holds.axis(k))) {
      forms.hold_axis(boundary.vertices[k], holds.axis(k));
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
    const double weight = holds.is_pinned(places[c]) ? kPinnedWeight : options.crease_weight;
    forms.set_general(creases[c], form, degree_factor * weight * edge_weight / form.weight);
  }
  return forms;
}

Frames stored(const std::vector<Quaternion>& frames) {
  Frames result(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) result[i] = to_stored(frames[i]);
  return result;
}

/// Returns the frames in double precision, with the constrained axes exact to that precision.
std::vector<Quaternion> aligned(const Holds& holds, const Frames& frames) {
  std::vector<Quaternion> result(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) result[i] = from_stored(frames[i]);
  holds.align(result);
  return result;
}

template <int D>
FieldGraph<D> graph_of(const std::shared_ptr<const Connectivity>& connectivity, const Holds& holds,
                       const OntoOptions& options, std::span<const VertexGuide> guides) {
  return {connectivity, vertex_forms<D>(connectivity->adjacency, holds, options, guides)};
}

/// Relaxes in degree 4 for both degrees, as on the grid, and settles in the field's own.
template <int D>
SettledFrames solved(const std::shared_ptr<const Connectivity>& connectivity, const Holds& holds,
                     Frames frames, const OntoOptions& options, std::span<const VertexGuide> guides,
                     const Extent& extent, const SweepMonitor& after_sweep) {
  const FieldGraph<D> graph = graph_of<D>(connectivity, holds, options, guides);
  std::function<Frames(Frames)> relax;
  if (options.relaxation_sweeps > 0) {
    relax = [&](Frames came) {
      const RelaxationPlan plan{options.relaxation_sweeps, options.symmetrisation, options.over_relaxation};
      if constexpr (D == 4) {
        came = relaxed(graph, std::move(came), plan, after_sweep);
      } else {
        came = relaxed(graph_of<4>(connectivity, holds, options, guides), std::move(came), plan, after_sweep);
      }
      return stored(aligned(holds, came));
    };
  }
  const SettlingPlan settling = settling_plan(options, connectivity->adjacency, extent.volume, extent.side);
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
  // The shortest rotation between the two, by half its angle: 1 + cos t = 2 cos^2(t/2), sin t = 2 sin cos.
  const Vector3 turn = cross(nearest, direction);
  if (norm(turn) == 0) return frame;
  const Quaternion rotation{1 + dot(nearest, direction), turn[0], turn[1], turn[2]};
  return normalised(rotation * frame);
}

TetFrames finish_on_tets(const std::vector<StiffnessEdge>& edges, const BoundaryVertices& boundary,
                         std::vector<Quaternion> start, Degree degree, const OntoOptions& options,
                         const Monitor& monitor, const std::vector<VertexGuide>& guides,
                         const Extent& extent) {
  const auto connectivity = connectivity_of(start.size(), edges);
  const Holds holds(boundary, options.boundary);
  int sweeps = 0;
  const SweepMonitor after_sweep = [&](double energy) {
    monitor.check_stop();
    monitor.report({Phase::kTets, 0, start.size(), ++sweeps, energy});
  };
  holds.align(start);
  const SettledFrames result =
      degree == Degree::kThree
          ? solved<3>(connectivity, holds, stored(start), options, guides, extent, after_sweep)
          : solved<4>(connectivity, holds, stored(start), options, guides, extent, after_sweep);
  return {aligned(holds, result.frames), result.settled, sweeps};
}

}  // namespace crossgrain
