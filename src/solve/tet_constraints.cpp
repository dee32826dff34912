// SPDX-License-Identifier: Apache-2.0
#include "solve/tet_constraints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "surface/clipping.hpp"
#include "surface/constraint_guides.hpp"
#include "surface/surface.hpp"

namespace crossgrain {
namespace {

constexpr std::uint32_t kNoPoint = std::numeric_limits<std::uint32_t>::max();

/// Smallest barycentric coordinate of a point inside a tet. Points on a common face are inside both tets.
constexpr double kInside = -1e-9;

/// Smallest share of a point that a vertex receives, as on the grid; smaller shares would cost as much as
/// large ones.
constexpr double kSmallestShare = 0.1;

using Shares = std::array<double, 4>;

/// Appends points along a segment. Their number does not matter, because the points at a vertex are averaged,
/// not added.
void add_middles(const GuideSegment& segment, const Box& box, double step, std::vector<GuidePoint>& points) {
  const ClippedSegment part = clip_segment(segment.ends, box);
  if (part.empty()) return;
  const Vector3 along = segment.ends[1] - segment.ends[0];
  const int count = std::max(1, static_cast<int>(std::ceil((part.to - part.from) * norm(along) / step)));
  for (int k = 0; k < count; ++k) {
    const double t = part.from + (k + 0.5) / count * (part.to - part.from);
    points.push_back({segment.ends[0] + t * along, {segment.directions[0]}, {segment.weight, 0, 0}});
  }
}

std::vector<GuidePoint> asked_points(const Constraints& constraints, const Box& box, double step) {
  Constraints of_places = constraints;
  of_places.faces.clear();
  Guides guides;
  add_constraints(of_places, Surface{}, guides);
  for (const GuideSegment& segment : guides.segments) add_middles(segment, box, step, guides.points);
  return std::move(guides.points);
}

Shares barycentric(const TetMesh& mesh, const std::array<std::uint32_t, 4>& tet, const Vector3& p) {
  const auto corner = [&](int k) { return mesh.vertices[tet[static_cast<std::size_t>(k)]]; };
  const Vector3 a = corner(0), ab = corner(1) - a, ac = corner(2) - a, ad = corner(3) - a, ap = p - a;
  const double volume = dot(cross(ab, ac), ad);
  Shares shares{0, dot(cross(ap, ac), ad) / volume, dot(cross(ab, ap), ad) / volume,
                dot(cross(ab, ac), ap) / volume};
  shares[0] = 1 - shares[1] - shares[2] - shares[3];
  return shares;
}

/// Points sorted by their first coordinate, for queries by the box of a tet.
class SortedPoints {
 public:
  explicit SortedPoints(const std::vector<GuidePoint>& points) : points_(points), order_(points.size()) {
    for (std::size_t k = 0; k < order_.size(); ++k) order_[k] = static_cast<std::uint32_t>(k);
    std::ranges::stable_sort(
        order_, [&](std::uint32_t a, std::uint32_t b) { return points[a].place[0] < points[b].place[0]; });
  }

  /// Calls take(point) for each point in a box.
  template <class Take>
  void within(const Box& box, const Take& take) const {
    auto k = std::partition_point(order_.begin(), order_.end(),
                                  [&](std::uint32_t p) { return points_[p].place[0] < box.low[0]; });
    for (; k != order_.end() && points_[*k].place[0] <= box.high[0]; ++k) {
      const Vector3& p = points_[*k].place;
      if (p[1] >= box.low[1] && p[1] <= box.high[1] && p[2] >= box.low[2] && p[2] <= box.high[2]) take(*k);
    }
  }

 private:
  const std::vector<GuidePoint>& points_;
  std::vector<std::uint32_t> order_;
};

/// Returns the first tet that contains each point, or kNoPoint.
std::vector<std::uint32_t> tets_of(const TetMesh& mesh, const std::vector<GuidePoint>& points) {
  const SortedPoints sorted(points);
  const std::size_t run_count = (mesh.tets.size() + kParallelGrain - 1) / kParallelGrain;
  std::vector<std::vector<std::array<std::uint32_t, 2>>> runs(run_count);  // point and tet
  parallel_for_chunks(mesh.tets.size(), kParallelGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto& [a, b, c, d] = mesh.tets[t];
      const Box box = box_of({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], mesh.vertices[d]});
      sorted.within(box, [&](std::uint32_t p) {
        const Shares shares = barycentric(mesh, mesh.tets[t], points[p].place);
        if (*std::ranges::min_element(shares) >= kInside)
          runs[begin / kParallelGrain].push_back({p, static_cast<std::uint32_t>(t)});
      });
    }
  });
  std::vector<std::uint32_t> tets(points.size(), kNoPoint);
  for (const auto& run : runs)
    for (const auto& [point, tet] : run) tets[point] = std::min(tets[point], tet);
  return tets;
}

struct PlacedPoint {
  std::uint32_t vertex, point;
  double share;
};

std::vector<PlacedPoint> placed_points(const TetSolid& solid, const BoundaryVertices& boundary,
                                       const std::vector<GuidePoint>& points) {
  const std::vector<std::uint32_t> tets = tets_of(solid.mesh, points);
  std::vector<PlacedPoint> placed;
  for (std::uint32_t p = 0; p < points.size(); ++p) {
    if (tets[p] == kNoPoint) continue;
    const auto& tet = solid.mesh.tets[tets[p]];
    const Shares shares = barycentric(solid.mesh, tet, points[p].place);
    const double largest = *std::ranges::max_element(shares);
    for (std::size_t k = 0; k < 4; ++k) {
      const bool is_inside = !std::ranges::binary_search(boundary.vertices, tet[k]);
      if (is_inside && shares[k] >= kSmallestShare * largest)
        placed.push_back({tet[k], p, shares[k] / largest});
    }
  }
  std::ranges::stable_sort(placed, {}, &PlacedPoint::vertex);
  return placed;
}

double weight_of(const PlacedPoint& placed, const std::vector<GuidePoint>& points) {
  const auto& weights = points[placed.point].weights;
  return placed.share * *std::ranges::max_element(weights);
}

}  // namespace

std::vector<VertexGuide> vertex_guides(const Constraints& constraints, const TetSolid& solid,
                                       const BoundaryVertices& boundary, double step) {
  const std::vector<GuidePoint> points = asked_points(constraints, box_of(solid.mesh.vertices), step);
  if (points.empty()) return {};
  const std::vector<PlacedPoint> placed = placed_points(solid, boundary, points);
  std::vector<VertexGuide> guides;
  for (std::size_t first = 0, last = 0; first < placed.size(); first = last) {
    double largest = 0, sum = 0;
    for (; last < placed.size() && placed[last].vertex == placed[first].vertex; ++last) {
      const double weight = weight_of(placed[last], points);
      largest = std::max(largest, weight);
      sum += weight;
    }
    for (std::size_t k = first; k < last; ++k) {
      const GuidePoint& point = points[placed[k].point];
      for (int axis = 0; axis < 3; ++axis) {
        if (point.weights[axis] > 0)
          guides.push_back({placed[k].vertex, point.directions[axis],
                            placed[k].share * point.weights[axis] * largest / sum});
      }
    }
  }
  return guides;
}

}  // namespace crossgrain
