// SPDX-License-Identifier: Apache-2.0
#include "surface/faded_creases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "base/degree.hpp"
#include "base/vector3.hpp"
#include "crossgrain/place.hpp"
#include "surface/crease_gaps.hpp"
#include "surface/sharp_edges.hpp"

namespace crossgrain {
namespace {

/// Shortest path that is told, in longest sides of the model.
constexpr double kShortestFaded = 0.05;

/// Steps and end of the angles that are tried.
constexpr double kTriedStepDeg = 5, kLeastTriedDeg = 10;

/// Of a surface with more paths that fade out, long and short, nothing is told: it is rough. Coarse parts
/// have up to 51.
constexpr std::size_t kMostOpen = 1000;

/// No angle is tried that makes more edges sharp, in numbers of sharp edges: they are those of rough or
/// coarse surfaces, on which trials are long and follow no crease alone.
constexpr std::size_t kMostSharp = 4;

using VertexEdge = std::array<std::uint32_t, 2>;

struct FadedCrease {
  std::vector<VertexEdge> edges;  ///< the first is at the end
  std::uint32_t end;
};

/// What an angle makes of creases that fade out.
struct Followed {
  double angle_deg = 0;
  std::size_t count = 0;  ///< of them that end elsewhere
  std::uint32_t end = 0;  ///< of the first
  double least_rad = 0;   ///< of the edges that follow there
};

std::vector<FadedCrease> faded_creases(const Surface& surface, AngledEdges found,
                                       const CreaseAngles& angles) {
  const std::vector<Vector3>& at = surface.mesh.vertices;
  const std::vector<SharpEdge> edges = with_closed_gaps(std::move(found.edges), at, found.holding, angles);
  const double shortest = kShortestFaded * longest_side(surface.box);
  std::vector<FadedCrease> faded;
  const std::vector<OpenStrand> open = open_strands(edges, found.holding);
  if (open.size() > kMostOpen) return {};
  for (const OpenStrand& strand : open) {
    FadedCrease crease{{}, strand.end};
    double length = 0, radii = 0, turn_rad = 0;
    for (const std::uint32_t e : strand.edges) {
      crease.edges.push_back(edges[e].vertices);
      length += norm(at[edges[e].vertices[1]] - at[edges[e].vertices[0]]);
      radii += edges[e].radii;
      turn_rad = std::max(turn_rad, edges[e].turn_rad);
    }
    const bool is_sure = radii >= angles.gaps.least_radii || turn_rad >= angles.fading.sure_deg * kDegree;
    if (length >= shortest && is_sure) faded.push_back(std::move(crease));
  }
  return faded;
}

/// The edges of creases by a smaller angle.
class Trial {
 public:
  Trial(const AngledEdges& all, const std::vector<Vector3>& vertices, const CreaseAngles& angles)
      : least_rad_(angles.least_deg * kDegree) {
    AngledEdges found{{}, all.holding};
    for (const SharpEdge& edge : all.edges)
      if (edge.turn_rad > least_turn_in_gaps(angles)) found.edges.push_back(edge);
    edges_ = edges_of_creases(std::move(found), vertices, angles);
    is_open_.resize(edges_.size());
    for (const OpenStrand& strand : open_strands(edges_, all.holding))
      for (const std::uint32_t e : strand.edges) is_open_[e] = 1;
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
      for (const std::uint32_t v : edges_[e].vertices) spokes_.push_back({v, e});
    std::sort(spokes_.begin(), spokes_.end());
  }

  Followed followed(const std::vector<FadedCrease>& faded, double sharp_rad) const {
    Followed result{.angle_deg = least_rad_ / kDegree};
    std::size_t own = 0;
    for (const FadedCrease& crease : faded) {
      if (!is_whole(crease)) continue;
      double least_rad = std::numbers::pi;
      const std::size_t added = follow(crease, sharp_rad, least_rad);
      if (added == 0 || least_rad <= least_rad_) continue;
      if (result.count++ == 0) result.end = crease.end, result.least_rad = least_rad;
      own += crease.edges.size() + added;
    }
    const auto less_sharp = static_cast<std::size_t>(
        std::ranges::count_if(edges_, [&](const SharpEdge& edge) { return edge.turn_rad <= sharp_rad; }));
    if (less_sharp > 2 * own) result.count = 0;
    return result;
  }

 private:
  bool is_whole(const FadedCrease& crease) const {
    return std::ranges::all_of(crease.edges, [&](const VertexEdge& vertices) {
      const auto found = std::ranges::lower_bound(edges_, vertices, {}, &SharpEdge::vertices);
      return found != edges_.end() && found->vertices == vertices &&
             !is_open_[static_cast<std::size_t>(found - edges_.begin())];
    });
  }

  /// Returns the number of edges from the end of a crease to the next sharp one, or where others meet; sets
  /// their least angle.
  std::size_t follow(const FadedCrease& crease, double sharp_rad, double& least_rad) const {
    VertexEdge before = crease.edges.front();
    std::uint32_t vertex = crease.end;
    for (std::size_t count = 0; count <= edges_.size(); ++count) {
      const auto begin = std::lower_bound(spokes_.begin(), spokes_.end(), Spoke{vertex, 0});
      const auto end = std::upper_bound(begin, spokes_.end(), Spoke{vertex, UINT32_MAX});
      if (end - begin != 2) return count;
      const SharpEdge& first = edges_[begin->second];
      const SharpEdge& next = first.vertices == before ? edges_[(end - 1)->second] : first;
      if (next.turn_rad > sharp_rad) return count;
      least_rad = std::min(least_rad, next.turn_rad);
      before = next.vertices;
      vertex = before[0] == vertex ? before[1] : before[0];
    }
    return 0;
  }

  using Spoke = std::pair<std::uint32_t, std::uint32_t>;  ///< vertex, edge
  double least_rad_;
  std::vector<SharpEdge> edges_;  ///< ascending by vertices
  std::vector<std::uint8_t> is_open_;
  std::vector<Spoke> spokes_;  ///< sorted
};

}  // namespace

std::optional<Warning> faded_crease_warning(const Surface& surface, std::span<const EdgeUse> all_uses,
                                            const CreaseAngles& angles) {
  if (angles.least_deg <= kLeastTriedDeg || angles.least_deg >= 180) return std::nullopt;
  const std::vector<FadedCrease> faded =
      faded_creases(surface, angled_edges(surface, all_uses, least_turn_in_gaps(angles)), angles);
  if (faded.empty()) return std::nullopt;
  CreaseAngles smaller = angles;
  smaller.least_deg = kLeastTriedDeg;
  const AngledEdges all = angled_edges(surface, all_uses, least_turn_in_gaps(smaller));
  const auto sharper_than = [&](double deg) {
    return static_cast<std::size_t>(std::ranges::count_if(
        all.edges, [&](const SharpEdge& edge) { return edge.turn_rad > deg * kDegree; }));
  };
  const std::size_t most = kMostSharp * sharper_than(angles.least_deg);
  Followed best;
  for (double deg = kTriedStepDeg * (std::ceil(angles.least_deg / kTriedStepDeg) - 1); deg >= kLeastTriedDeg;
       deg -= kTriedStepDeg) {
    if (sharper_than(deg) > most) break;
    smaller.least_deg = deg;
    const Followed tried =
        Trial(all, surface.mesh.vertices, smaller).followed(faded, angles.least_deg * kDegree);
    if (tried.count > best.count) best = tried;
  }
  if (best.count == 0) return std::nullopt;
  Warning warning(WarningKind::kFadedCreases,
                  fmt::format("{} {}, where its angle falls to {:.0f} degrees",
                              best.count == 1 ? "a crease fades out at"
                                              : counted(best.count, "crease") + " fade out, the first at",
                              words_of_place(surface.mesh.vertices[best.end], longest_side(surface.box)),
                              best.least_rad / kDegree),
                  Remedy::kUseCreaseAngle);
  warning.remedy_number = best.angle_deg;
  return warning;
}

}  // namespace crossgrain
