// SPDX-License-Identifier: Apache-2.0
#include "singularity/surface_hexahedra.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/parallel.hpp"
#include "singularity/corner_faces.hpp"
#include "singularity/cube_group.hpp"
#include "singularity/matching.hpp"
#include "singularity/singularity_tuning.hpp"
#include "singularity/vertex_link.hpp"

namespace crossgrain {
namespace {

using Summary = SolveReport::Singularity;

constexpr int kFlat = 2;

/// Angle within which of 45, 135, 225 or 315 degrees of solid the number of hexahedra at a crease is left to
/// the frames, or undecided.
constexpr double kRoundingDeg = 5;

/// Largest number of arcs at a corner of which every selection is tried: the nearest ones.
constexpr std::size_t kMostArcs = 4;

/// The numbers of hexahedra that a crease of this angle may have: the nearest, and another where rounding
/// decides.
std::vector<int> numbers_near(double angle_deg) {
  std::vector<int> numbers;
  for (int k = 0; k <= 4; ++k)
    if (std::abs(angle_deg - 90 * k) < 45 + kRoundingDeg) numbers.push_back(k);
  std::ranges::sort(
      numbers, [&](int a, int b) { return std::abs(angle_deg - 90 * a) < std::abs(angle_deg - 90 * b); });
  return numbers;
}

double length_of(std::span<const CreaseVote> votes, int hexahedra) {
  double length = 0;
  for (const CreaseVote& vote : votes)
    if (vote.hexahedra == hexahedra) length += vote.length;
  return length;
}

/// A crease with what decides its number of hexahedra.
struct JudgedCrease {
  std::vector<int> numbers;  ///< possible ones
  int hexahedra = kFlat;     ///< the one of them that most frames follow
  double followed = 0;       ///< share of the length where frames do
  bool is_resolved = false;  ///< longer than a few cells

  bool is_flat() const { return numbers.size() == 1 && hexahedra == kFlat; }
};

class SurfaceJudge {
 public:
  SurfaceJudge(const SolidSurface& surface, const SolidCreases& creases, const SurfaceCells& cells,
               const SingularityGraph& graph)
      : surface_(surface), creases_(creases), cells_(cells), graph_(graph), fans_(surface) {}

  void judge(const VotesAlong& votes_along, Summary& summary) {
    judged_.resize(creases_.creases.size());
    parallel_for(judged_.size(), [&](std::size_t c) {
      judged_[c] = judged(creases_.creases[c], votes_along(creases_.creases[c]));
    });
    for (std::size_t c = 0; c < judged_.size(); ++c)
      if (!judged_[c].is_flat() && judged_[c].is_resolved)
        summary.crease_list.push_back(described(creases_.creases[c], judged_[c]));
    for (const SolidCorner& corner : creases_.corners)
      if (has_other_than_flat(corner)) summary.corner_list.push_back(described(corner));
  }

 private:
  JudgedCrease judged(const SolidCrease& crease, const std::vector<CreaseVote>& votes) const {
    JudgedCrease result{numbers_near(crease.mean_angle_deg)};
    result.hexahedra = *std::ranges::max_element(
        result.numbers, [&](int a, int b) { return length_of(votes, a) < length_of(votes, b); });
    double all = 0;
    for (const CreaseVote& vote : votes) all += vote.length;
    result.followed = all > 0 ? length_of(votes, result.hexahedra) / all : 0;
    result.is_resolved = crease.length > kMergeCells * cells_.size_at(crease.edges.front().ends[0]);
    return result;
  }

  /// Knife edges have no room for a hexahedron, whatever the frames do.
  Verdict verdict_of(const SolidCrease& crease) const {
    const double least = crease.edges[crease.sharpest].angle_deg;
    if (least > 45 + kRoundingDeg) return Verdict::kMeshable;
    double knife = 0;
    for (const SolidCrease::Edge& edge : crease.edges)
      if (edge.angle_deg < 45 - kRoundingDeg) knife += edge.length;
    const bool is_knife = knife >= cells_.size_at(crease.edges[crease.sharpest].ends[0]);
    return is_knife ? Verdict::kNotMeshable : Verdict::kUndecided;
  }

  Summary::Crease described(const SolidCrease& crease, const JudgedCrease& judged) const {
    const SolidCrease::Edge& sharpest = crease.edges[crease.sharpest];
    return {.hexahedra = judged.hexahedra,
            .angle_deg = crease.mean_angle_deg,
            .least_angle_deg = sharpest.angle_deg,
            .length = crease.length,
            .followed = judged.followed,
            .verdict = verdict_of(crease),
            .place = 0.5 * (surface_.vertices[sharpest.ends[0]] + surface_.vertices[sharpest.ends[1]]),
            .faces = fans_.beside(sharpest)};
  }

  bool has_other_than_flat(const SolidCorner& corner) const {
    const auto is_resolved = [&](std::uint32_t c) { return judged_[c].is_resolved; };
    const auto& creases = corner.creases;
    const bool is_seen = std::ranges::any_of(creases, is_resolved);
    if (!is_seen && (creases.size() == 1 || !cells_.see_all)) return false;
    return std::ranges::any_of(creases, [&](std::uint32_t c) { return !judged_[c].is_flat(); });
  }

  Summary::Corner described(const SolidCorner& corner) {
    Summary::Corner result;
    result.place = surface_.vertices[corner.vertex];
    std::vector<int> own;
    for (const std::uint32_t c : corner.creases) own.push_back(judged_[c].hexahedra);
    const std::vector<int> valences = valences_near(corner.vertex);
    const auto link = first_link(own, valences);
    result.arcs = link.value_or(std::vector<int>{});
    for (const int k : own)
      if (k != kFlat) result.creases.push_back(k);
    result.hexahedra = hexahedra_at_surface_vertex(result.arcs, result.creases);
    result.verdict = link ? Verdict::kMeshable : verdict_without_link(corner, valences);
    const CornerFaces around = fans_.at(corner.vertex);
    result.faces = around.faces;
    result.narrowest_deg = around.narrowest_deg;
    return result;
  }

  /// Valences of the arcs that end near a vertex, nearest first.
  std::vector<int> valences_near(std::uint32_t vertex) const {
    // On a grid lines end up to a cell short of the surface.
    const double reach = (kMergeCells + 1) * cells_.size_at(vertex);
    std::vector<std::pair<double, int>> ends;
    for (const SingularityGraph::Node& node : graph_.nodes) {
      const double distance = norm(node.place - surface_.vertices[vertex]);
      if (!node.on_boundary || distance > reach) continue;
      for (const std::uint32_t a : node.arcs)
        if (const double index = graph_.arcs[a].index; index != 0)
          ends.push_back({distance, 4 - static_cast<int>(std::lround(4 * index))});
    }
    std::ranges::sort(ends);
    std::vector<int> valences;
    for (std::size_t k = 0; k < std::min(ends.size(), kMostArcs); ++k) valences.push_back(ends[k].second);
    return valences;
  }

  /// Whether there is a link; none if it has too many hexahedra to say. Corners of a part are much alike, and
  /// a search takes up to a second.
  std::optional<bool> has_link(const std::vector<int>& valences, const std::vector<int>& creases) {
    const auto [known, is_new] = links_.try_emplace({valences, creases}, std::nullopt);
    if (is_new) known->second = has_surface_link(valences, creases);
    return known->second;
  }

  /// The first selection of arcs, none before some, with which a link exists.
  std::optional<std::vector<int>> first_link(const std::vector<int>& creases,
                                             const std::vector<int>& valences) {
    std::vector<int> bent;
    for (const int k : creases)
      if (k != kFlat) bent.push_back(k);
    for (std::size_t selection = 0; selection < std::size_t{1} << valences.size(); ++selection) {
      std::vector<int> selected;
      for (std::size_t k = 0; k < valences.size(); ++k)
        if (selection >> k & 1) selected.push_back(valences[k]);
      if (has_link(selected, bent).value_or(false)) return selected;
    }
    return std::nullopt;
  }

  /// Undecided if other roundings of its creases have a link, here or as a whole, or a crease is too short
  /// for the cells. A crease that ends alone fades out: the normal is the same all around its end.
  Verdict verdict_without_link(const SolidCorner& corner, const std::vector<int>& valences) {
    if (corner.creases.size() == 1) return Verdict::kUndecided;
    if (has_too_many(corner)) return Verdict::kUndecided;
    for (const std::uint32_t c : corner.creases)
      if (!judged_[c].is_resolved) return Verdict::kUndecided;
    return has_link_when_rounded(corner, 0, {}, valences) ? Verdict::kUndecided : Verdict::kNotMeshable;
  }

  bool has_too_many(const SolidCorner& corner) const {
    std::vector<int> own;
    for (const std::uint32_t c : corner.creases) own.push_back(judged_[c].hexahedra);
    return hexahedra_at_surface_vertex({}, own) > kMostLinkTriangles;
  }

  /// The numbers of a crease, and those of its angle at one of its ends: it may fade out there.
  std::vector<int> numbers_at(std::uint32_t vertex, std::uint32_t crease) const {
    std::vector<int> numbers = judged_[crease].numbers;
    const auto& edges = creases_.creases[crease].edges;
    for (const SolidCrease::Edge* edge : {&edges.front(), &edges.back()}) {
      if (edge->ends[0] != vertex && edge->ends[1] != vertex) continue;
      for (const int k : numbers_near(edge->angle_deg))
        if (std::ranges::find(numbers, k) == numbers.end()) numbers.push_back(k);
    }
    return numbers;
  }

  bool has_link_when_rounded(const SolidCorner& corner, std::size_t at, std::vector<int> numbers,
                             const std::vector<int>& valences) {
    if (at == corner.creases.size()) return first_link(numbers, valences).has_value();
    for (const int k : numbers_at(corner.vertex, corner.creases[at])) {
      numbers.push_back(k);
      if (has_link_when_rounded(corner, at + 1, numbers, valences)) return true;
      numbers.pop_back();
    }
    return false;
  }

  const SolidSurface& surface_;
  const SolidCreases& creases_;
  const SurfaceCells& cells_;
  const SingularityGraph& graph_;
  const SurfaceFans fans_;
  std::vector<JudgedCrease> judged_;
  std::map<std::pair<std::vector<int>, std::vector<int>>, std::optional<bool>> links_;
};

}  // namespace

int quarter_turns(std::span<const Quaternion> way, const std::array<Vector3, 2>& normals,
                  const Vector3& along, double angle_deg) {
  const CubeGroup& group = CubeGroup::instance();
  SignedAxis carried = nearest_axis(way.front(), normals[0]);
  for (std::size_t k = 1; k < way.size(); ++k)
    carried = group.image(group.number_of(matching(way[k - 1], way[k])), carried);
  const SignedAxis arrives = nearest_axis(way.back(), normals[1]);
  if (carried == arrives) return 2;
  if (carried == opposite(arrives)) return angle_deg < 180 ? 0 : 4;
  return dot(axis_in_space(way.back(), cross_of(carried, arrives)), along) > 0 ? 3 : 1;
}

void add_surface(const SolidSurface& surface, const SolidCreases& creases, const VotesAlong& votes_along,
                 const SurfaceCells& cells, const SingularityGraph& graph,
                 SolveReport::Singularity& summary) {
  SurfaceJudge(surface, creases, cells, graph).judge(votes_along, summary);
}

}  // namespace crossgrain
