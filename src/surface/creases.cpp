// SPDX-License-Identifier: Apache-2.0
#include "surface/creases.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/degree.hpp"
#include "base/vector3.hpp"
#include "surface/crease_gaps.hpp"
#include "surface/edge_uses.hpp"
#include "surface/sharp_edges.hpp"

namespace crossgrain {
namespace {

/// Returns the sharp edges that count, ascending.
std::vector<std::array<std::uint32_t, 2>> sharp_edges(const Surface& surface,
                                                      std::span<const EdgeUse> all_uses,
                                                      const CreaseAngles& angles,
                                                      std::span<const std::array<std::uint32_t, 2>> tagged) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const SharpEdge& edge :
       edges_of_creases(angled_edges(surface, all_uses, least_turn_in_gaps(angles), tagged),
                        surface.mesh.vertices, angles))
    edges.push_back(edge.vertices);
  return edges;
}

/// A sharp edge seen from one of its ends.
struct Spoke {
  std::uint32_t from, to;

  friend bool operator<(const Spoke& a, const Spoke& b) {
    return std::pair(a.from, a.to) < std::pair(b.from, b.to);
  }
};

/// Both spokes of every sharp edge, sorted.
class SharpEdges {
 public:
  SharpEdges(const Surface& surface, std::span<const EdgeUse> all_uses, const CreaseAngles& angles,
             std::span<const std::array<std::uint32_t, 2>> tagged)
      : vertices_(surface.mesh.vertices), straight_(std::cos(kCornerDeg * kDegree)) {
    for (const auto& [a, b] : sharp_edges(surface, all_uses, angles, tagged)) add(a, b);
    std::sort(spokes_.begin(), spokes_.end());
    const std::size_t sharp = spokes_.size();
    for (const auto& [a, b] : tagged) {
      const bool is_sharp_too = std::binary_search(
          spokes_.begin(), spokes_.begin() + static_cast<std::ptrdiff_t>(sharp), Spoke{a, b});
      if (vertices_[a] == vertices_[b] || is_sharp_too) continue;
      add(a, b);
      only_tagged_.push_back(std::minmax(a, b));
    }
    std::sort(only_tagged_.begin(), only_tagged_.end());
    std::sort(spokes_.begin(), spokes_.end());
    const auto same = [](const Spoke& a, const Spoke& b) { return a.from == b.from && a.to == b.to; };
    spokes_.erase(std::unique(spokes_.begin(), spokes_.end(), same), spokes_.end());
    used_.assign(spokes_.size(), false);
  }

  /// Returns the open curves, which begin where no curve passes through, then the closed ones.
  std::vector<std::vector<std::uint32_t>> chains() {
    std::vector<std::vector<std::uint32_t>> result;
    for (const bool closed : {false, true}) {
      for (std::size_t s = 0; s < spokes_.size(); ++s) {
        if (used_[s] || (!closed && passes_through(spokes_[s].from))) continue;
        result.push_back(chain_from(s));
      }
    }
    return result;
  }

  /// Tagged and not sharp.
  bool is_only_tagged(std::uint32_t a, std::uint32_t b) const {
    const std::pair<std::uint32_t, std::uint32_t> edge = std::minmax(a, b);
    return std::binary_search(only_tagged_.begin(), only_tagged_.end(), edge);
  }

  bool passes_through(std::uint32_t vertex) const {
    const auto at = spokes_at(vertex);
    return at.size() == 2 && -dot(direction(at[0]), direction(at[1])) > straight_;
  }

 private:
  void add(std::uint32_t a, std::uint32_t b) {
    spokes_.push_back({a, b});
    spokes_.push_back({b, a});
  }

  std::span<const Spoke> spokes_at(std::uint32_t vertex) const {
    const auto begin = std::lower_bound(spokes_.begin(), spokes_.end(), Spoke{vertex, 0});
    auto end = begin;
    while (end != spokes_.end() && end->from == vertex) ++end;
    return {begin, end};
  }

  Vector3 direction(const Spoke& spoke) const {
    return normalised(vertices_[spoke.to] - vertices_[spoke.from]);
  }

  void use(const Spoke& spoke) {
    const auto at = std::lower_bound(spokes_.begin(), spokes_.end(), spoke);
    used_[static_cast<std::size_t>(at - spokes_.begin())] = true;
  }

  std::vector<std::uint32_t> chain_from(std::size_t s) {
    Spoke spoke = spokes_[s];
    std::vector<std::uint32_t> chain{spoke.from};
    for (;;) {
      use(spoke);
      use({spoke.to, spoke.from});
      chain.push_back(spoke.to);
      if (spoke.to == chain.front() || !passes_through(spoke.to)) return chain;
      const auto at = spokes_at(spoke.to);
      spoke = at[0].to == spoke.from ? at[1] : at[0];
    }
  }

  const std::vector<Vector3>& vertices_;
  double straight_;
  std::vector<Spoke> spokes_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> only_tagged_;  ///< sorted
  std::vector<bool> used_;
};

/// Returns the tangent at point k of a polyline: halfway between the directions before and after.
Vector3 tangent_at(const std::vector<Vector3>& points, std::size_t k, bool smoothly_closed) {
  const std::size_t last = points.size() - 1;
  const auto direction_from = [&](std::size_t p) { return normalised(points[p + 1] - points[p]); };
  const bool is_end = k == 0 || k == last;
  if (is_end && !smoothly_closed) return direction_from(k == 0 ? 0 : last - 1);
  const Vector3 before = direction_from(is_end ? last - 1 : k - 1), after = direction_from(is_end ? 0 : k);
  return normalised(before + after);
}

/// Two ends continue each other if they are straight within 5 degrees: an edge does where a face between two
/// solids meets it, while two edges at the apex of a pyramid are far from it.
constexpr double kStraightOn = -0.9962;

/// End of a curve: its position, and the direction into the curve.
struct CurveEnd {
  Vector3 position, inwards;
};

/// Returns the number of ends, counting two that continue each other as one.
std::size_t directions_of(std::span<const CurveEnd> ends) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const auto before = ends.first(k);
    count += std::none_of(before.begin(), before.end(), [&](const CurveEnd& other) {
      return dot(other.inwards, ends[k].inwards) < kStraightOn;
    });
  }
  return count;
}

}  // namespace

std::vector<CreaseCurve> sharp_curves(const Surface& surface, const CreaseAngles& angles,
                                      std::span<const std::array<std::uint32_t, 2>> tagged) {
  return sharp_curves(surface, sorted_edge_uses(surface.mesh.triangles), angles, tagged);
}

std::vector<CreaseCurve> sharp_curves(const Surface& surface, std::span<const EdgeUse> all_uses,
                                      const CreaseAngles& angles,
                                      std::span<const std::array<std::uint32_t, 2>> tagged) {
  SharpEdges edges(surface, all_uses, angles, tagged);
  std::vector<CreaseCurve> curves;
  for (const std::vector<std::uint32_t>& chain : edges.chains()) {
    CreaseCurve curve;
    for (const std::uint32_t vertex : chain) curve.points.push_back(surface.mesh.vertices[vertex]);
    const bool smoothly_closed = chain.front() == chain.back() && edges.passes_through(chain.front());
    for (std::size_t k = 0; k < chain.size(); ++k)
      curve.tangents.push_back(tangent_at(curve.points, k, smoothly_closed));
    curve.tag = static_cast<std::int32_t>(curves.size());
    for (std::size_t k = 0; k + 1 < chain.size(); ++k)
      curve.is_tagged |= edges.is_only_tagged(chain[k], chain[k + 1]);
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<std::vector<std::uint32_t>> sharp_chains(const Surface& surface,
                                                     std::span<const EdgeUse> all_uses,
                                                     const CreaseAngles& angles,
                                                     std::span<const std::array<std::uint32_t, 2>> tagged) {
  return SharpEdges(surface, all_uses, angles, tagged).chains();
}

std::vector<CreaseCorner> corners_of(std::span<const CreaseCurve> curves) {
  const double straight = std::cos(kCornerDeg * kDegree);
  std::vector<CurveEnd> ends;
  for (const CreaseCurve& curve : curves) {
    if (curve.points.size() < 2) continue;
    ends.push_back({curve.points.front(), curve.tangents.front()});
    ends.push_back({curve.points.back(), -curve.tangents.back()});
  }
  std::stable_sort(ends.begin(), ends.end(),
                   [](const CurveEnd& a, const CurveEnd& b) { return a.position < b.position; });
  std::vector<CreaseCorner> corners;
  for (std::size_t begin = 0, end = 0; begin < ends.size(); begin = end) {
    while (end < ends.size() && ends[end].position == ends[begin].position) ++end;
    const std::size_t count = end - begin;
    const bool goes_on = count == 2 && -dot(ends[begin].inwards, ends[begin + 1].inwards) > straight;
    if (count > 1 && !goes_on)
      corners.push_back({ends[begin].position, count, directions_of({&ends[begin], count})});
  }
  return corners;
}

KnifeEdges knife_edges(const Surface& surface, std::span<const EdgeUse> all_uses, bool inside_out) {
  // The closer the faces, the further apart the normals.
  const double largest_cosine = -std::cos(kKnifeDeg * kDegree);
  const auto& vertices = surface.mesh.vertices;
  KnifeEdges knives;
  for_each_edge(all_uses, [&](std::span<const EdgeUse> uses) {
    if (uses.size() != 2 || uses[0].forward == uses[1].forward) return;
    if (cosine_between(surface, uses[0], uses[1]) >= largest_cosine) return;
    // Where solids touch by other triangles, faces of both lie on each other.
    if (!surface.mesh.solids.empty() &&
        surface.mesh.solids[uses[0].triangle] != surface.mesh.solids[uses[1].triangle])
      return;
    // A slit in the solid looks alike, but its other side is behind the plane of the first.
    const Vector3& on_edge = vertices[uses[0].low()];
    double ahead = 0;
    for (const std::uint32_t v : surface.mesh.triangles[uses[1].triangle])
      ahead += dot(vertices[v] - on_edge, surface.normals[uses[0].triangle]);
    if ((ahead > 0) != inside_out) return;
    if (knives.count++ < KnifeEdges::kMostPlaces)
      knives.places.push_back(0.5 * (on_edge + vertices[uses[0].high()]));
  });
  return knives;
}

Guides guides_along(std::span<const CreaseCurve> curves, std::span<const CreaseCorner> corners, double weight,
                    double tagged_weight) {
  Guides guides;
  for (const CreaseCurve& curve : curves) {
    const double counted = curve.is_tagged ? tagged_weight : weight;
    if (counted <= 0) continue;
    for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
      guides.creases.push_back(
          {{curve.points[k], curve.points[k + 1]}, {curve.tangents[k], curve.tangents[k + 1]}, counted});
    }
  }
  if (guides.creases.empty()) return guides;
  for (const CreaseCorner& corner : corners) guides.corners.push_back(corner.position);
  return guides;
}

}  // namespace crossgrain
