// SPDX-License-Identifier: Apache-2.0
#include "surface/open_edges.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "surface/bvh.hpp"
#include "surface/surface.hpp"

namespace crossgrain {
namespace {

/// Two edges are parallel if their directions differ by less than 20 degrees.
constexpr double kAlong = 0.94;

/// Tolerance relative to the length of an edge: a point this far beyond its ends still counts as beside it.
constexpr double kBeyond = 1e-6;

/// Gaps below this, relative to the edge, are rounding: corners on an edge.
constexpr double kNoGap = 1e-12;

/// Maximum number of edges that one edge is compared with. A partner is missed only if more edges crowd
/// within the gap.
constexpr std::size_t kMostCompared = 1000;

struct Segment {
  Vector3 from, to;
};

Segment segment_of(const std::vector<Vector3>& vertices, const EdgeUse& use) {
  return {vertices[use.low()], vertices[use.high()]};
}

Vector3 middle_of(const Segment& s) {
  return 0.5 * (s.from + s.to);
}

/// Returns the distance of the middle of `edge` from `other`, if both run along each other there.
std::optional<double> gap_beside(const Segment& edge, const Segment& other) {
  const Vector3 along = edge.to - edge.from, other_along = other.to - other.from;
  const double length = norm(along), other_length = norm(other_along);
  if (length == 0 || other_length == 0) return std::nullopt;
  if (std::abs(dot(along, other_along)) < kAlong * length * other_length) return std::nullopt;
  const Vector3 from_start = middle_of(edge) - other.from;
  const double t = dot(from_start, other_along) / (other_length * other_length);
  if (t < -kBeyond || t > 1 + kBeyond) return std::nullopt;
  return norm(from_start - t * other_along);
}

/// Returns the edges as triangles without area, in the order of the edges, to build a tree over them.
Surface edges_as_surface(const std::vector<Vector3>& vertices, const std::vector<EdgeUse>& edges) {
  Surface surface;
  surface.mesh.vertices = vertices;
  for (const EdgeUse& use : edges) surface.mesh.triangles.push_back({use.low(), use.high(), use.high()});
  return surface;
}

class CrackFinder {
 public:
  CrackFinder(const std::vector<Vector3>& vertices, const std::vector<EdgeUse>& edges, double widest)
      : vertices_(vertices),
        edges_(edges),
        widest_(widest),
        surface_(edges_as_surface(vertices, edges)),
        tree_(surface_) {}

  std::optional<CrackSide> beside(std::size_t e) const {
    const Segment edge = segment_of(vertices_, edges_[e]);
    // Limits the gap of a short edge to a fraction of its length.
    const double reach = std::min(widest_, 0.25 * norm(edge.to - edge.from));
    const Vector3 middle = middle_of(edge), margin{reach, reach, reach};
    std::optional<std::size_t> best;
    double best_gap = reach;
    std::size_t compared = 0;
    for_each_triangle_near(tree_, {middle - margin, middle + margin}, [&](std::uint32_t other) {
      if (other == e || edges_[other].edge == edges_[e].edge) return true;
      const std::optional<double> gap = gap_beside(edge, segment_of(vertices_, edges_[other]));
      if (gap && (*gap < best_gap || (*gap == best_gap && (!best || other < *best)))) {
        best = other;
        best_gap = *gap;
      }
      return ++compared < kMostCompared;
    });
    if (!best) return std::nullopt;
    const EdgeUse &a = edges_[e], &b = edges_[*best];
    const Segment other = segment_of(vertices_, b);
    const bool same = (dot(edge.to - edge.from, other.to - other.from) > 0) == (a.forward == b.forward);
    if (best_gap < kNoGap * norm(edge.to - edge.from)) best_gap = 0;
    return CrackSide{a, b, best_gap, same};
  }

 private:
  const std::vector<Vector3>& vertices_;
  const std::vector<EdgeUse>& edges_;
  double widest_;
  Surface surface_;
  TriangleBvh tree_;
};

std::vector<std::uint32_t> loop_of_edges(std::size_t vertices, const std::vector<EdgeUse>& edges) {
  DisjointSets sets(vertices);
  for (const EdgeUse& use : edges) sets.join(use.low(), use.high());
  std::vector<std::uint32_t> loop_of;
  for (const EdgeUse& use : edges) loop_of.push_back(sets.root(use.low()));
  return loop_of;
}

}  // namespace

OpenEdges find_open_edges(const std::vector<Vector3>& vertices, std::span<const EdgeUse> uses, double size) {
  OpenEdges open;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 1) open.edges.push_back(edge[0]);
  });
  if (open.edges.size() < 2) return open;
  const CrackFinder finder(vertices, open.edges, kCrackGap * size);
  std::vector<std::optional<CrackSide>> sides(open.edges.size());
  parallel_for(sides.size(), [&](std::size_t e) { sides[e] = finder.beside(e); });
  for (const auto& side : sides)
    if (side) open.cracks.push_back(*side);
  return open;
}

std::vector<OpenLoop> open_loops(const std::vector<Vector3>& vertices, const OpenEdges& open) {
  const std::vector<std::uint32_t> loop_of = loop_of_edges(vertices.size(), open.edges);
  std::vector<std::uint32_t> roots = loop_of;
  std::sort(roots.begin(), roots.end());
  roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
  std::vector<OpenLoop> loops(roots.size());
  auto crack = open.cracks.begin();
  for (std::size_t e = 0; e < open.edges.size(); ++e) {
    const auto at = std::lower_bound(roots.begin(), roots.end(), loop_of[e]) - roots.begin();
    OpenLoop& loop = loops[static_cast<std::size_t>(at)];
    const Segment edge = segment_of(vertices, open.edges[e]);
    loop.length += norm(edge.to - edge.from);
    loop.middle += middle_of(edge);
    ++loop.edges;
    if (crack == open.cracks.end() || crack->edge.edge != open.edges[e].edge) continue;
    ++loop.cracks;
    ++crack;
  }
  for (OpenLoop& loop : loops) loop.middle = 1.0 / static_cast<double>(loop.edges) * loop.middle;
  return loops;
}

void report_open_edges(const std::vector<Vector3>& vertices, const OpenEdges& open,
                       SurfaceFindings& findings) {
  const std::vector<OpenLoop> loops = open_loops(vertices, open);
  const OpenLoop* longest = nullptr;
  std::size_t holes = 0;
  for (const OpenLoop& loop : loops) {
    if (!loop.is_hole()) continue;
    ++holes;
    if (longest == nullptr || loop.length > longest->length) longest = &loop;
  }
  if (holes > 0) findings.push_back({FindingKind::kHole, holes, longest->middle, longest->length});
  if (open.cracks.empty()) return;
  const auto widest = std::max_element(open.cracks.begin(), open.cracks.end(),
                                       [](const CrackSide& a, const CrackSide& b) { return a.gap < b.gap; });
  findings.push_back(
      {FindingKind::kCrack, open.cracks.size(), middle_of(segment_of(vertices, widest->edge)), widest->gap});
}

}  // namespace crossgrain
