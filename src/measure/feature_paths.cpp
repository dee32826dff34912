// SPDX-License-Identifier: Apache-2.0
#include "measure/feature_paths.hpp"

#include <algorithm>
#include <cmath>

#include "base/ascending.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "measure/near_points.hpp"

namespace crossgrain {
namespace {

using VertexPair = std::array<std::uint32_t, 2>;

/// Places along an edge, and along its stretch of a curve, that are measured.
constexpr int kPlacesOfEdge = 8;

/// An edge that follows a curve covers at least this share of its length.
constexpr double kLeastProgress = 0.5;

/// How a stretch of a curve and an edge lie to each other.
struct StretchFit {
  double farthest = 0;  ///< beyond what the edge cuts off
  Vector3 place{0, 0, 0};
};

StretchFit fit_of(const MeasuredCurve& line, double from, double to, const Vector3& a, const Vector3& b) {
  const double cut_off = std::abs(line.turn_rad(from, to)) * norm(b - a) / 8;
  StretchFit fit;
  const auto add = [&](double distance, const Vector3& place) {
    if (distance - cut_off <= fit.farthest) return;
    fit = {distance - cut_off, place};
  };
  for (int k = 0; k <= kPlacesOfEdge; ++k) {
    const double share = static_cast<double>(k) / kPlacesOfEdge;
    const Vector3 on_curve = line.at(from + share * (to - from)), on_edge = a + share * (b - a);
    add(distance_to_segment(on_curve, a, b), on_curve);
    add(line.nearest_between(on_edge, from, to).distance, on_edge);
  }
  return fit;
}

/// Places of the vertices of a path on a curve, which do not decrease.
std::vector<double> places_along(const MeasuredCurve& line, std::span<const Vector3> path) {
  std::vector<double> places{line.is_closed() ? line.nearest(path.front()).place : 0};
  const double begin = places[0], end = begin + line.length();
  for (std::size_t k = 1; k + 1 < path.size(); ++k) {
    const double reach = 3 * norm(path[k] - path[k - 1]);
    const double from = places.back(), to = std::min(end, from + reach);
    places.push_back(to > from ? line.nearest_between(path[k], from, to).place : from);
  }
  places.push_back(end);
  return places;
}

CurveShare share_along(const MeasuredCurve& line, std::span<const Vector3> path,
                       const std::vector<std::uint8_t>& is_edge, double tolerance) {
  const std::vector<double> places = places_along(line, path);
  CurveShare share{0, true, 0, line.at(places[0])};
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    const StretchFit fit = fit_of(line, places[k], places[k + 1], path[k], path[k + 1]);
    if (fit.farthest > share.farthest) {
      share.farthest = fit.farthest;
      share.place = fit.place;
    }
    if (is_edge[k] && fit.farthest <= tolerance) {
      share.kept += places[k + 1] - places[k];
      continue;
    }
    if (share.is_whole && !is_edge[k]) share.place = line.at(places[k]);
    share.is_whole = false;
  }
  return share;
}

/// A vertex near a curve.
struct OnCurve {
  std::uint32_t vertex;
  double place, distance;
};

/// An edge that follows a curve onward.
struct Onward {
  std::uint32_t from, to;  ///< indices of vertices near the curve
  double place, progress;
};

/// Vertices and edges of a mesh that follow a curve, and the path that they make.
class CurveTracer {
 public:
  CurveTracer(const MeasuredCurve& line, const std::vector<Vector3>& vertices, double tolerance)
      : line_(line), vertices_(vertices), tolerance_(tolerance) {}

  void find(std::span<const std::uint32_t> near, std::span<const VertexPair> edges) {
    for (const std::uint32_t v : near) {
      const MeasuredCurve::Nearest nearest = line_.nearest(vertices_[v], tolerance_);
      if (nearest.distance <= tolerance_) near_.push_back({v, nearest.place, nearest.distance});
    }
    const auto index_of = [&](std::uint32_t v) {
      const auto found = std::ranges::lower_bound(near_, v, {}, &OnCurve::vertex);
      return found != near_.end() && found->vertex == v ? static_cast<std::uint32_t>(found - near_.begin())
                                                        : FeatureComplex::kNone;
    };
    for (std::uint32_t k = 0; k < near_.size(); ++k) {
      for (auto edge = std::ranges::lower_bound(edges, VertexPair{near_[k].vertex, 0});
           edge != edges.end() && (*edge)[0] == near_[k].vertex; ++edge) {
        const std::uint32_t other = index_of((*edge)[1]);
        if (other != FeatureComplex::kNone) add_edge(k, other);
      }
    }
  }

  /// Returns the path between two vertices, or around the curve, that is nearest to it; empty without.
  std::vector<std::uint32_t> path(std::uint32_t first, std::uint32_t last) const {
    if (near_.empty()) return {};
    if (first == FeatureComplex::kNone && line_.is_closed())
      first = last = std::ranges::min_element(near_, {}, &OnCurve::distance)->vertex;
    const auto start = std::ranges::find(near_, first, &OnCurve::vertex);
    const auto stop = std::ranges::find(near_, last, &OnCurve::vertex);
    if (start == near_.end() || stop == near_.end()) return {};
    return cheapest(static_cast<std::uint32_t>(start - near_.begin()),
                    static_cast<std::uint32_t>(stop - near_.begin()));
  }

  /// What edges keep one by one.
  CurveShare share() const {
    std::vector<std::array<double, 2>> stretches;
    for (const Onward& edge : onward_) {
      const double end = edge.place + edge.progress;
      stretches.push_back({edge.place, std::min(end, line_.length())});
      if (end > line_.length()) stretches.push_back({0, end - line_.length()});
    }
    std::sort(stretches.begin(), stretches.end());
    CurveShare share{0, false, 0, line_.at(0)};
    double covered = 0;
    bool is_open = true;  // the first stretch without an edge is still to be found
    for (const auto& [from, to] : stretches) {
      if (is_open && from > covered + tolerance_) {
        share.place = line_.at(0.5 * (covered + from));
        is_open = false;
      }
      if (to > covered) share.kept += to - std::max(from, covered);
      covered = std::max(covered, to);
    }
    if (is_open) share.place = line_.at(0.5 * (covered + line_.length()));
    return share;
  }

 private:
  void add_edge(std::uint32_t a, std::uint32_t b) {
    double progress = near_[b].place - near_[a].place;
    if (line_.is_closed() && progress > line_.length() / 2) progress -= line_.length();
    if (line_.is_closed() && progress < -line_.length() / 2) progress += line_.length();
    if (progress < 0) {
      std::swap(a, b);
      progress = -progress;
    }
    const Vector3 &from = vertices_[near_[a].vertex], &to = vertices_[near_[b].vertex];
    if (!(progress >= kLeastProgress * norm(to - from)) || progress == 0) return;
    const double place = near_[a].place;
    if (fit_of(line_, place, place + progress, from, to).farthest <= tolerance_)
      onward_.push_back({a, b, place, progress});
  }

  std::vector<std::uint32_t> cheapest(std::uint32_t start, std::uint32_t stop) const {
    const bool is_round = line_.is_closed() && start == stop;
    const double zero = near_[start].place;
    const auto place_of = [&](double place) {
      const double rest = place - zero;
      return line_.is_closed() && rest < 0 ? rest + line_.length() : rest;
    };
    std::vector<Onward> edges = onward_;
    for (Onward& edge : edges) edge.place = place_of(edge.place);
    std::ranges::stable_sort(edges, {}, &Onward::place);
    // The last entry is the start again, after a round.
    std::vector<double> cost(near_.size() + 1, INFINITY);
    std::vector<std::uint32_t> before(near_.size() + 1, FeatureComplex::kNone);
    const std::uint32_t goal = is_round ? static_cast<std::uint32_t>(near_.size()) : stop;
    cost[start] = 0;
    for (const Onward& edge : edges) {
      const bool passes_start =
          line_.is_closed() && edge.place + edge.progress > line_.length() * (1 + 1e-12);
      const std::uint32_t to = is_round && edge.to == start ? goal : edge.to;
      if (passes_start && to != goal) continue;
      const double distance = near_[edge.to].distance / tolerance_;
      const double sum = cost[edge.from] + distance * distance + 1e-3;
      if (!(sum < cost[to])) continue;
      cost[to] = sum;
      before[to] = edge.from;
    }
    if (cost[goal] == INFINITY) return {};
    std::vector<std::uint32_t> path{near_[stop].vertex};
    for (std::uint32_t at = before[goal]; at != FeatureComplex::kNone;
         at = at == start ? FeatureComplex::kNone : before[at])
      path.push_back(near_[at].vertex);
    std::ranges::reverse(path);
    return path;
  }

  const MeasuredCurve& line_;
  const std::vector<Vector3>& vertices_;
  const double tolerance_;
  std::vector<OnCurve> near_;  ///< ascending by vertex
  std::vector<Onward> onward_;
};

std::vector<std::uint32_t> vertices_of_quads(std::span<const SurfaceQuad> quads) {
  std::vector<std::uint32_t> vertices;
  for (const SurfaceQuad& quad : quads)
    vertices.insert(vertices.end(), quad.vertices.begin(), quad.vertices.end());
  sort_uniquely(vertices);
  return vertices;
}

std::vector<std::uint32_t> vertices_of_corners(const FeatureComplex& complex, const HexMesh& mesh,
                                               std::span<const std::uint32_t> used, double tolerance) {
  std::vector<Vector3> points;
  for (const std::uint32_t v : used) points.push_back(mesh.vertices[v]);
  const NearPoints near(points, tolerance);
  std::vector<std::uint32_t> vertices;
  for (const auto& corner : complex.corners) {
    std::uint32_t nearest = FeatureComplex::kNone;
    double least = INFINITY;
    near.for_each_near(corner.point, [&](std::uint32_t k, double square) {
      if (square > least || (square == least && used[k] > nearest)) return;
      least = square;
      nearest = used[k];
    });
    vertices.push_back(nearest);
  }
  return vertices;
}

bool is_in(const Vector3& point, const Box& box, double margin) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (point[axis] < box.low[axis] - margin || point[axis] > box.high[axis] + margin) return false;
  return true;
}

}  // namespace

std::vector<VertexPair> edges_of_quads(std::span<const SurfaceQuad> quads) {
  std::vector<VertexPair> edges;
  edges.reserve(4 * quads.size());
  for (const SurfaceQuad& quad : quads) {
    for (std::size_t k = 0; k < 4; ++k)
      edges.push_back(ascending(VertexPair{quad.vertices[k], quad.vertices[(k + 1) % 4]}));
  }
  sort_uniquely(edges);
  return edges;
}

CurveShare share_kept(const MeasuredCurve& line, std::span<const std::uint32_t> path,
                      std::span<const VertexPair> edges, const std::vector<Vector3>& vertices,
                      double tolerance) {
  if (path.size() < 2 || line.length() == 0) return {0, false, 0, line.at(line.length() / 2)};
  std::vector<Vector3> points;
  std::vector<std::uint8_t> is_edge;
  for (const std::uint32_t v : path) points.push_back(vertices[v]);
  for (std::size_t k = 0; k + 1 < path.size(); ++k)
    is_edge.push_back(std::ranges::binary_search(edges, ascending(VertexPair{path[k], path[k + 1]})));
  CurveShare share = share_along(line, points, is_edge, tolerance);
  if (share.is_whole || !line.is_closed()) return share;
  std::ranges::reverse(points);
  std::ranges::reverse(is_edge);
  const CurveShare reverse = share_along(line, points, is_edge, tolerance);
  return reverse.kept > share.kept ? reverse : share;
}

FeaturePlaces found_places(const HexMesh& mesh, std::span<const SurfaceQuad> quads,
                           const FeatureComplex& complex, const std::vector<MeasuredCurve>& lines,
                           double tolerance, std::vector<CurveShare>& shares) {
  FeaturePlaces places;
  const std::vector<std::uint32_t> used = vertices_of_quads(quads);
  const std::vector<VertexPair> edges = edges_of_quads(quads);
  places.vertex_of_corner = vertices_of_corners(complex, mesh, used, tolerance);
  places.path_of_curve.resize(lines.size());
  shares.resize(lines.size());
  parallel_for(
      lines.size(),
      [&](std::size_t c) {
        std::vector<std::uint32_t> near;
        for (const std::uint32_t v : used)
          if (is_in(mesh.vertices[v], lines[c].box(), tolerance)) near.push_back(v);
        CurveTracer tracer(lines[c], mesh.vertices, tolerance);
        tracer.find(near, edges);
        const auto& [first, last] = complex.curves[c].corners;
        const auto vertex_of = [&](std::uint32_t corner) {
          return corner == FeatureComplex::kNone ? FeatureComplex::kNone : places.vertex_of_corner[corner];
        };
        const bool has_ends = first == FeatureComplex::kNone || (vertex_of(first) != FeatureComplex::kNone &&
                                                                 vertex_of(last) != FeatureComplex::kNone);
        if (has_ends) places.path_of_curve[c] = tracer.path(vertex_of(first), vertex_of(last));
        shares[c] = tracer.share();
      },
      1);
  return places;
}

}  // namespace crossgrain
