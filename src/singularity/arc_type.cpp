// SPDX-License-Identifier: Apache-2.0
#include "singularity/arc_type.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "singularity/vertex_link.hpp"

namespace crossgrain {
namespace {

using Graph = SingularityGraph;

/// Number of edges before and after over which the direction of an arc is taken.
constexpr std::size_t kReach = 2;

/// Lengths along an arc in cells, by the rotation of the frames around it.
struct Stretches {
  double positive = 0, negative = 0;
  double across = 0;  ///< longest connected part
  double all = 0, no_axis = 0, half = 0;
};

class ArcWalk {
 public:
  ArcWalk(const MergedNetwork::Arc& arc, const SingularEdges& singular, const MergedNetwork& network,
          std::span<const Vector3> positions)
      : arc_(arc), singular_(singular), network_(network), positions_(positions) {}

  /// Calls visit(edge, length, cells, cosine) for each edge in order: the cosine is that of the angle between
  /// the arc and the axis of rotation of the frames, by the right-hand rule about the arc.
  template <class Visit>
  void visit(const Visit& visit) const {
    for (std::size_t k = 0; k < arc_.edges.size(); ++k) {
      const SingularEdge& edge = singular_.edges[arc_.edges[k]];
      const bool forward = network_.place_of[edge.ends[0]] == arc_.places[k];
      const double length = norm(positions_[arc_.places[k + 1]] - positions_[arc_.places[k]]);
      const double cell_size =
          (singular_.points[edge.ends[0]].cell_size + singular_.points[edge.ends[1]].cell_size) / 2;
      const double cosine = (forward ? 1 : -1) * dot(direction(k), edge.turn.axis);
      visit(edge, length, length / cell_size, cosine);
    }
  }

 private:
  Vector3 direction(std::size_t edge) const {
    const std::size_t from = edge - std::min(edge, kReach),
                      to = std::min(edge + 1 + kReach, arc_.edges.size());
    const Vector3 way = positions_[arc_.places[to]] - positions_[arc_.places[from]];
    const double length = norm(way);
    return length > 0 ? (1 / length) * way : Vector3{0, 0, 0};
  }

  const MergedNetwork::Arc& arc_;
  const SingularEdges& singular_;
  const MergedNetwork& network_;
  std::span<const Vector3> positions_;
};

Graph::ArcType type_of(const Stretches& cells, const SingularityOptions& options) {
  if (2 * cells.no_axis > cells.all) return Graph::ArcType::kNoAxis;
  if (std::min(cells.positive, cells.negative) > options.across_cells) return Graph::ArcType::kChanging;
  if (cells.across > options.across_cells) return Graph::ArcType::kAcross;
  return Graph::ArcType::kRegular;
}

}  // namespace

Graph::Arc described(const MergedNetwork::Arc& arc, const SingularEdges& singular,
                     const MergedNetwork& network, std::span<const Vector3> positions,
                     const SingularityOptions& options) {
  Graph::Arc out;
  for (const std::uint32_t place : arc.places) {
    const auto& points = network.places[place].points;
    out.points.push_back(positions[place]);
    out.vertices.push_back(points.size() == 1 ? singular.points[points[0]].name : -1);
  }
  Stretches cells;
  double across_here = 0, sum = 0;
  ArcWalk(arc, singular, network, positions)
      .visit([&](const SingularEdge& edge, double length, double own_cells, double cosine) {
        const bool along = edge.turn.is_about_an_axis() && std::abs(cosine) >= 1 / std::numbers::sqrt2;
        out.length += length;
        sum += cosine * length;
        cells.all += own_cells;
        if (!edge.turn.is_about_an_axis()) cells.no_axis += own_cells;
        if (edge.turn.kind == FrameTurn::Kind::kHalf) cells.half += own_cells;
        if (along) {
          (cosine > 0 ? cells.positive : cells.negative) += own_cells;
          across_here = 0;
        } else {
          out.across_length += length;
          across_here += own_cells;
          cells.across = std::max(cells.across, across_here);
        }
      });
  out.type = type_of(cells, options);
  if (out.type == Graph::ArcType::kRegular)
    out.index = (sum < 0 ? -1 : 1) * (2 * cells.half > cells.all ? 0.5 : 0.25);
  // Two hexahedra around an edge would have two faces in common.
  const bool meshable = out.type == Graph::ArcType::kRegular && out.index != 0.5;
  out.verdict = meshable ? Graph::Verdict::kMeshable : Graph::Verdict::kNotMeshable;
  return out;
}

Graph::Verdict node_verdict(std::span<const Graph::Arc* const> arcs) {
  std::vector<int> valences;
  for (const Graph::Arc* arc : arcs) {
    if (arc->verdict == Graph::Verdict::kNotMeshable) return Graph::Verdict::kNotMeshable;
    valences.push_back(4 - static_cast<int>(std::lround(4 * arc->index)));
  }
  const std::optional<bool> has_link = has_inner_link(valences);
  if (!has_link) return Graph::Verdict::kUndecided;
  return *has_link ? Graph::Verdict::kMeshable : Graph::Verdict::kNotMeshable;
}

}  // namespace crossgrain
