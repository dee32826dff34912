// SPDX-License-Identifier: Apache-2.0
#include "field/tet_finish.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "base/parallel.hpp"
#include "constraint/normal_form.hpp"
#include "field/stages.hpp"

namespace crossgrain {
namespace {

/// Starts are compared after their relaxation and so many manifold sweeps. A later start must end lower by
/// more than this fraction, so that what the sweeps leave decides nothing (docs/notes/solver.md).
constexpr int kRaceSweeps = 10;
constexpr double kRaceTie = 3e-4;

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
CellForms<D> vertex_forms(const Adjacency& adjacency, const Holds& holds, const TetFinishing& options,
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

/// Finishes one start or the best of several, in the field's own degree.
template <int D>
class Finish {
 public:
  Finish(std::shared_ptr<const Connectivity> connectivity, const Holds& holds, const TetFinishing& options,
         std::span<const VertexGuide> guides, const Extent& extent, const SweepMonitor& after_sweep)
      : connectivity_(std::move(connectivity)),
        holds_(holds),
        options_(options),
        guides_(guides),
        after_sweep_(after_sweep),
        plan_(settling_plan(options, *connectivity_, extent.volume, extent.side)),
        graph_{connectivity_, vertex_forms<D>(connectivity_->adjacency, holds, options, guides)} {
    if (D != 4)
      relaxed_graph_ = {connectivity_, vertex_forms<4>(connectivity_->adjacency, holds, options, guides)};
  }

  SettledFrames of(Frames start) {
    if (options_.relaxation_sweeps == 0) return settled(graph_, std::move(start), plan_, after_sweep_);
    Frames changed = relaxed(start, after_sweep_);
    return lower_settled(graph_, std::move(changed), std::move(start), plan_, after_sweep_);
  }

  /// Sets `best` to the number of the start that ends lowest. Starts that are behind after a few sweeps are
  /// not finished.
  SettledFrames of_best(std::vector<Frames> starts, std::size_t& best) {
    const double energy_before = graph_energy(graph_, state_of<D>(starts.front()));
    std::vector<SettledFrames> raced = raced_from(starts);
    std::vector<double> energies;
    for (const SettledFrames& frames : raced) energies.push_back(compared(frames));
    const double highest = (1 + options_.race_margin) * *std::min_element(energies.begin(), energies.end());
    SettledFrames result;
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < raced.size(); ++k) {
      if (!(energies[k] <= highest + plan_.noise)) continue;
      if (!raced[k].settled) raced[k] = settled(graph_, std::move(raced[k].frames), plan_, after_sweep_);
      const double energy = compared(raced[k]);
      if (!(energy < (1 - kRaceTie) * lowest)) continue;
      lowest = energy;
      result = std::move(raced[k]);
      best = k;
    }
    if (result.energy <= energy_before) return result;
    best = 0;
    return settled(graph_, std::move(starts.front()), plan_, after_sweep_);
  }

 private:
  /// Relaxes all starts and settles them for a few sweeps. Small graphs keep one thread busy, so two halves
  /// of the starts go side by side; only the first is reported.
  std::vector<SettledFrames> raced_from(const std::vector<Frames>& starts) {
    SettlingPlan race = plan_;
    race.most_sweeps = std::min(kRaceSweeps, plan_.most_sweeps);
    race.more_sweeps = 0;
    std::vector<SettledFrames> raced(starts.size());
    const auto run = [&](std::size_t begin, std::size_t end, const SweepMonitor& after_sweep) {
      for (std::size_t k = begin; k < end; ++k)
        raced[k] = settled(graph_, relaxed(starts[k], after_sweep), race, after_sweep);
    };
    const std::size_t half = starts.size() / 2;
    run_side_by_side([&] { run(0, half, after_sweep_); },
                     [&] { run(half, starts.size(), [](double) { check_watched(); }); });
    return raced;
  }

  /// The energy by which starts are compared: the Dirichlet energy that the report gives, without what
  /// creases add; with guides inside what is minimised, so that a field that ignores them does not win.
  double compared(const SettledFrames& settled) const {
    if (!guides_.empty()) return settled.energy;
    return graph_energy(FieldGraph<4>{connectivity_, CellForms<4>(settled.frames.size())},
                        state_of<4>(settled.frames));
  }

  /// Relaxes in degree 4 for both degrees, as on the grid.
  Frames relaxed(Frames frames, const SweepMonitor& after_sweep) {
    const RelaxationPlan plan{options_.relaxation_sweeps, options_.symmetrisation, options_.over_relaxation};
    const auto& graph = [this]() -> const FieldGraph<4>& {
      if constexpr (D == 4) return graph_;
      return relaxed_graph_;
    }();
    return stored(aligned(holds_, crossgrain::relaxed(graph, std::move(frames), plan, after_sweep)));
  }

  const std::shared_ptr<const Connectivity> connectivity_;
  const Holds& holds_;
  const TetFinishing& options_;
  const std::span<const VertexGuide> guides_;
  const SweepMonitor& after_sweep_;
  const SettlingPlan plan_;
  const FieldGraph<D> graph_;
  FieldGraph<4> relaxed_graph_;  ///< in degree 3
};

template <int D>
SettledFrames finished(Finish<D> finish, std::vector<Frames> starts, std::size_t& best) {
  best = 0;
  return starts.size() == 1 ? finish.of(std::move(starts.front())) : finish.of_best(std::move(starts), best);
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
                         std::vector<std::vector<Quaternion>> starts, Degree degree,
                         const TetFinishing& options, const Monitor& monitor,
                         const std::vector<VertexGuide>& guides, const Extent& extent) {
  const std::size_t vertices = starts.front().size();
  const auto connectivity = connectivity_of(vertices, edges);
  const Holds holds(boundary, options.boundary);
  TetFrames result;
  const SweepMonitor after_sweep = [&](double energy) {
    monitor.check_stop();
    monitor.report({Phase::kTets, 0, vertices, ++result.sweeps, energy});
  };
  std::vector<Frames> stored_starts;
  for (std::vector<Quaternion>& start : starts) {
    holds.align(start);
    stored_starts.push_back(stored(start));
  }
  const SettledFrames found = degree == Degree::kThree
                                  ? finished<3>({connectivity, holds, options, guides, extent, after_sweep},
                                                std::move(stored_starts), result.start)
                                  : finished<4>({connectivity, holds, options, guides, extent, after_sweep},
                                                std::move(stored_starts), result.start);
  result.frames = aligned(holds, found.frames);
  result.settled = found.settled;
  return result;
}

}  // namespace crossgrain
