// SPDX-License-Identifier: Apache-2.0
#include "singularity/arc_type.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "singularity/arc_steps.hpp"
#include "singularity/vertex_link.hpp"

namespace crossgrain {
namespace {

using Graph = SingularityGraph;

/// Number of edges before and after over which the direction of an arc is taken.
constexpr std::size_t kDirectionEdges = 2;

/// Lengths along an arc in cells, by the rotation of the frames around it.
class Stretches {
 public:
  explicit Stretches(const SingularityTuning& options) : options_(options) {}

  void add(const FrameTurn& turn, double cells, double cosine) {
    all_ += cells;
    if (turn.kind == FrameTurn::Kind::kHalf) half_ += cells;
    if (!turn.is_about_an_axis()) all_no_axis_ += cells;
    no_axis_here_ = turn.is_about_an_axis() ? 0 : no_axis_here_ + cells;
    no_axis_ = std::max(no_axis_, no_axis_here_);
    if (!turn.is_about_an_axis() || std::abs(cosine) < options_.sign_cosine) return;
    if ((cosine > 0) != positive_now_) sign_here_ = 0;
    positive_now_ = cosine > 0;
    sign_here_ += cells;
    double& longest = positive_now_ ? positive_ : negative_;
    longest = std::max(longest, sign_here_);
  }

  Graph::ArcType type() const {
    if (is_too_long_for_two() || 2 * all_no_axis_ > all_) return Graph::ArcType::kNoAxis;
    const bool changes = std::min(positive_, negative_) >= options_.sign_cells;
    return changes ? Graph::ArcType::kChanging : Graph::ArcType::kRegular;
  }

  /// Whether neither sense lasts, on an arc long enough for both.
  bool is_of_no_sense() const {
    return all_ >= 2 * options_.sign_cells && std::max(positive_, negative_) < options_.sign_cells;
  }

  /// Whether third turns last so long that they are not two quarter turns side by side.
  bool is_too_long_for_two() const { return no_axis_ > options_.merge_cells; }

  bool is_by_half_turns() const { return 2 * half_ > all_; }

 private:
  const SingularityTuning& options_;
  double all_ = 0, half_ = 0;
  double all_no_axis_ = 0;
  double no_axis_ = 0, no_axis_here_ = 0;  ///< longest connected part, and the one up to here
  bool positive_now_ = true;
  double sign_here_ = 0;                ///< length since the last change of sign
  double positive_ = 0, negative_ = 0;  ///< the longest of either sign
};

class ArcWalk {
 public:
  ArcWalk(const MergedNetwork::Arc& arc, const SingularEdges& singular, const MergedNetwork& network,
          std::span<const Vector3> positions)
      : arc_(arc), singular_(singular), network_(network), positions_(positions) {}

  std::vector<ArcStep> steps() const {
    std::vector<ArcStep> steps;
    for (std::size_t k = 0; k < arc_.edges.size(); ++k) {
      const SingularEdge& edge = singular_.edges[arc_.edges[k]];
      const bool forward = network_.place_of[edge.ends[0]] == arc_.places[k];
      const double length = norm(positions_[arc_.places[k + 1]] - positions_[arc_.places[k]]);
      const double cell_size =
          (singular_.points[edge.ends[0]].cell_size + singular_.points[edge.ends[1]].cell_size) / 2;
      steps.push_back({edge.turn, direction(k), length, length / cell_size});
      if (!forward) steps.back().turn.axis = -edge.turn.axis;
    }
    return steps;
  }

 private:
  Vector3 direction(std::size_t edge) const {
    const std::size_t from = edge - std::min(edge, kDirectionEdges),
                      to = std::min(edge + 1 + kDirectionEdges, arc_.edges.size());
    return normalised(positions_[arc_.places[to]] - positions_[arc_.places[from]]);
  }

  const MergedNetwork::Arc& arc_;
  const SingularEdges& singular_;
  const MergedNetwork& network_;
  std::span<const Vector3> positions_;
};

Verdict verdict_of(const Graph::Arc& arc, const Stretches& stretches) {
  // Two hexahedra around an edge would have two faces in common.
  if (arc.index == 0.5 || arc.type == Graph::ArcType::kChanging || stretches.is_too_long_for_two())
    return Verdict::kNotMeshable;
  const bool is_regular = arc.type == Graph::ArcType::kRegular && !stretches.is_of_no_sense();
  return is_regular ? Verdict::kMeshable : Verdict::kUndecided;
}

std::vector<int> valences_of(std::span<const Graph::Arc* const> arcs) {
  std::vector<int> valences;
  for (const Graph::Arc* arc : arcs) valences.push_back(4 - static_cast<int>(std::lround(4 * arc->index)));
  return valences;
}

bool has_arc_of(Verdict verdict, std::span<const Graph::Arc* const> arcs) {
  return std::ranges::any_of(arcs, [&](const Graph::Arc* arc) { return arc->verdict == verdict; });
}

}  // namespace

Graph::Arc described(const MergedNetwork::Arc& arc, const SingularEdges& singular,
                     const MergedNetwork& network, std::span<const Vector3> positions,
                     const SingularityTuning& options) {
  Graph::Arc out;
  for (const std::uint32_t place : arc.places) {
    const auto& points = network.places[place].points;
    out.points.push_back(positions[place]);
    out.vertices.push_back(points.size() == 1 ? singular.points[points[0]].name : -1);
  }
  const std::vector<ArcStep> steps = ArcWalk(arc, singular, network, positions).steps();
  Stretches stretches(options);
  double sum = 0;
  for (const ArcStep& step : steps) {
    const double cosine = step.cosine();
    stretches.add(step.turn, step.cell_count, cosine);
    out.length += step.length;
    out.length_cells += step.cell_count;
    if (!step.turn.is_about_an_axis()) continue;
    sum += cosine * step.length;
    if (std::abs(cosine) < 1 / std::numbers::sqrt2) out.oblique_length += step.length;
  }
  out.axes = axes_along(steps, arc.closed);
  out.type = stretches.type();
  if (out.type == Graph::ArcType::kRegular)
    out.index = (sum < 0 ? -1 : 1) * (stretches.is_by_half_turns() ? 0.5 : 0.25);
  if (out.type == Graph::ArcType::kChanging) out.turning_points = turning_points(steps, arc.closed, options);
  out.verdict = verdict_of(out, stretches);
  return out;
}

Verdict node_verdict(std::span<const Graph::Arc* const> arcs) {
  if (has_arc_of(Verdict::kNotMeshable, arcs)) return Verdict::kNotMeshable;
  if (has_arc_of(Verdict::kUndecided, arcs)) return Verdict::kUndecided;
  const std::optional<bool> has_link = has_inner_link(valences_of(arcs));
  if (!has_link) return Verdict::kUndecided;
  return *has_link ? Verdict::kMeshable : Verdict::kNotMeshable;
}

Verdict end_verdict(std::span<const Graph::Arc* const> arcs) {
  const bool leave_room =
      has_arc_of(Verdict::kNotMeshable, arcs) || hexahedra_at_surface_vertex(valences_of(arcs), {}) >= 1;
  return leave_room ? Verdict::kMeshable : Verdict::kUndecided;
}

}  // namespace crossgrain
