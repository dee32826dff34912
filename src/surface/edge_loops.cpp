// SPDX-License-Identifier: Apache-2.0
#include "surface/edge_loops.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

/// Half the sum of the cross products of what follows in a loop: normal to it, of the length of its area.
Vector3 area_of(const EdgeLoop& loop, const std::vector<Vector3>& vertices, const Vector3& middle) {
  Vector3 area{};
  for (std::size_t k = 0; k < loop.vertices.size(); ++k) {
    const Vector3 &a = vertices[loop.vertices[k]],
                  &b = vertices[loop.vertices[(k + 1) % loop.vertices.size()]];
    area += 0.5 * cross(a - middle, b - middle);
  }
  return area;
}

using Flat = std::array<double, 2>;

double side_of(const Flat& a, const Flat& b, const Flat& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

/// A plane, seen from the side that its normal looks to.
class LoopPlane {
 public:
  LoopPlane(const Vector3& normal, const Vector3& origin) : normal_(normal), origin_(origin) {
    const std::size_t least = std::abs(normal_[0]) < 0.6 ? 0 : 1;
    Vector3 other{};
    other[least] = 1;
    const Vector3 along = cross(normal_, other);
    x_ = (1 / norm(along)) * along;
    y_ = cross(normal_, x_);
  }

  Flat at(const Vector3& p) const { return {dot(p - origin_, x_), dot(p - origin_, y_)}; }
  double height(const Vector3& p) const { return dot(p - origin_, normal_); }

 private:
  Vector3 normal_, origin_, x_{}, y_{};
};

class LoopJoining {
 public:
  LoopJoining(const std::vector<EdgeLoop>& loops, const std::vector<Vector3>& vertices)
      : loops_(loops), vertices_(vertices) {
    for (const EdgeLoop& loop : loops) {
      Vector3 middle{};
      for (const std::uint32_t v : loop.vertices)
        middle += (1 / static_cast<double>(loop.vertices.size())) * vertices[v];
      const Vector3 area = area_of(loop, vertices, middle);
      const double size = norm(area);
      sizes_.push_back(size);
      planes_.push_back(size > 0 ? std::optional(LoopPlane((1 / size) * area, middle)) : std::nullopt);
      normals_.push_back(size > 0 ? (1 / size) * area : Vector3{});
    }
  }

  std::vector<JoinedLoop> joined() const {
    std::vector<std::size_t> order(loops_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t k) { return sizes_[k]; });
    std::vector<std::vector<std::size_t>> within(loops_.size());
    std::vector<std::uint8_t> is_within(loops_.size(), 0);
    for (std::size_t k = 0; k < order.size(); ++k)
      if (const auto outer = loop_around(order, k); outer && !is_within[*outer]) {
        within[*outer].push_back(order[k]);
        is_within[order[k]] = 1;
      }
    std::vector<JoinedLoop> result;
    for (std::size_t k = 0; k < loops_.size(); ++k) {
      if (is_within[k]) continue;
      JoinedLoop one{loops_[k], {k}};
      one.of.insert(one.of.end(), within[k].begin(), within[k].end());
      if (!within[k].empty()) one.loop = joined(k, within[k]);
      result.push_back(std::move(one));
    }
    return result;
  }

 private:
  bool is_in_plane_of(std::size_t loop, std::size_t of) const {
    return std::ranges::all_of(loops_[loop].vertices, [&](std::uint32_t v) {
      return std::abs(planes_[of]->height(vertices_[v])) <=
             kInPlane * std::sqrt(std::min(sizes_[of], sizes_[loop]));
    });
  }

  /// The smallest loop in whose plane another lies, within it, and the other way round.
  std::optional<std::size_t> loop_around(const std::vector<std::size_t>& order, std::size_t place) const {
    const std::size_t inner = order[place];
    if (!planes_[inner]) return std::nullopt;
    for (std::size_t k = place; k-- > 0;) {
      const std::size_t outer = order[k];
      if (!(sizes_[outer] > sizes_[inner]) || dot(normals_[outer], normals_[inner]) > kInPlane - 1) continue;
      if (!is_in_plane_of(outer, outer) || !is_in_plane_of(inner, outer)) continue;
      if (is_inside(vertices_[loops_[inner].vertices[0]], outer)) return outer;
    }
    return std::nullopt;
  }

  bool is_inside(const Vector3& p, std::size_t loop) const {
    const LoopPlane& plane = *planes_[loop];
    const Flat at = plane.at(p);
    bool inside = false;
    for (std::size_t k = 0; k < loops_[loop].vertices.size(); ++k) {
      const Flat a = plane.at(vertex(loops_[loop], k)), b = plane.at(vertex(loops_[loop], k + 1));
      if ((a[1] > at[1]) != (b[1] > at[1]) && (side_of(a, b, at) > 0) == (b[1] > a[1])) inside = !inside;
    }
    return inside;
  }

  /// Vertex k of a loop, or the first after the last.
  const Vector3& vertex(const EdgeLoop& loop, std::size_t k) const {
    return vertices_[loop.vertices[k % loop.vertices.size()]];
  }

  /// The shortest way so far from an outer loop to an inner one.
  struct Way {
    double length = HUGE_VAL;
    std::uint32_t from = 0;  ///< vertex of the outer loop
    std::size_t to = 0;      ///< place in the inner loop

    friend bool operator<(const Way& a, const Way& b) { return a.length < b.length; }
  };

  void shorten(Way& way, const std::vector<std::uint32_t>& outer, const EdgeLoop& inner) const {
    for (const std::uint32_t v : outer)
      for (std::size_t k = 0; k < inner.vertices.size(); ++k) {
        const double length = norm(vertices_[v] - vertex(inner, k));
        if (length < way.length) way = {length, v, k};
      }
  }

  /// A loop with those within it, to each of which the shortest way goes that crosses none.
  EdgeLoop joined(std::size_t outer, const std::vector<std::size_t>& within) const {
    const LoopPlane& plane = *planes_[outer];
    EdgeLoop loop = loops_[outer];
    std::vector<EdgeLoop> inner;
    for (const std::size_t k : within) inner.push_back(loops_[k]);
    std::vector<Way> ways(inner.size());
    for (std::size_t k = 0; k < inner.size(); ++k) shorten(ways[k], loop.vertices, inner[k]);
    while (!inner.empty()) {
      check_watched();
      const auto shortest = std::ranges::min_element(ways, std::less()) - ways.begin();
      auto which = static_cast<std::size_t>(shortest);
      std::size_t from = place_towards(loop, ways[which].from, vertex(inner[which], ways[which].to), plane);
      std::size_t to = ways[which].to;
      if (!is_free(loop, inner, plane, from, vertex(inner[which], to)))
        std::tie(which, from, to) = free_way(loop, inner, plane);
      const EdgeLoop other = std::move(inner[which]);
      inner.erase(inner.begin() + static_cast<std::ptrdiff_t>(which));
      ways.erase(ways.begin() + static_cast<std::ptrdiff_t>(which));
      insert(loop, from, other, to);
      for (std::size_t k = 0; k < inner.size(); ++k) shorten(ways[k], other.vertices, inner[k]);
    }
    return loop;
  }

  /// Puts a loop, from a place on, between a vertex of another and the same vertex again.
  void insert(EdgeLoop& loop, std::size_t from, EdgeLoop other, std::size_t to) const {
    std::ranges::rotate(other.vertices, other.vertices.begin() + static_cast<std::ptrdiff_t>(to));
    std::ranges::rotate(other.across, other.across.begin() + static_cast<std::ptrdiff_t>(to));
    other.vertices.push_back(other.vertices.front());
    other.vertices.push_back(loop.vertices[from]);
    other.across.push_back({});
    other.across.push_back(loop.across[from]);
    loop.across[from] = {};
    const auto after = static_cast<std::ptrdiff_t>(from) + 1;
    loop.vertices.insert(loop.vertices.begin() + after, other.vertices.begin(), other.vertices.end());
    loop.across.insert(loop.across.begin() + after, other.across.begin(), other.across.end());
  }

  /// Whether a point is in the angle of a loop at a place of it, seen from there.
  bool is_in_angle(const EdgeLoop& loop, std::size_t k, const Vector3& point, const LoopPlane& plane) const {
    const std::size_t count = loop.vertices.size();
    const Flat before = plane.at(vertex(loop, k + count - 1)), at = plane.at(vertex(loop, k)),
               after = plane.at(vertex(loop, k + 1)), p = plane.at(point);
    const bool is_left_of_first = side_of(before, at, p) >= 0, is_left_of_second = side_of(at, after, p) >= 0;
    return side_of(before, at, after) >= 0 ? is_left_of_first && is_left_of_second
                                           : is_left_of_first || is_left_of_second;
  }

  /// The place of a vertex, which may have several, in whose angle a point is; the first if in none.
  std::size_t place_towards(const EdgeLoop& loop, std::uint32_t v, const Vector3& point,
                            const LoopPlane& plane) const {
    const auto first = static_cast<std::size_t>(std::ranges::find(loop.vertices, v) - loop.vertices.begin());
    for (std::size_t k = first; k < loop.vertices.size(); ++k)
      if (loop.vertices[k] == v && is_in_angle(loop, k, point, plane)) return k;
    return first;
  }

  bool is_free(const EdgeLoop& outer, const std::vector<EdgeLoop>& inner, const LoopPlane& plane,
               std::size_t from, const Vector3& to) const {
    const Flat a = plane.at(vertex(outer, from)), b = plane.at(to);
    return is_in_angle(outer, from, to, plane) && !crosses(outer, plane, a, b) &&
           std::ranges::none_of(inner, [&](const EdgeLoop& loop) { return crosses(loop, plane, a, b); });
  }

  /// The inner loop, and the places in the outer and in this one, of the shortest way that crosses none: by
  /// trying all, where edges are long beside the way.
  std::tuple<std::size_t, std::size_t, std::size_t> free_way(const EdgeLoop& outer,
                                                             const std::vector<EdgeLoop>& inner,
                                                             const LoopPlane& plane) const {
    double least = HUGE_VAL;
    std::tuple<std::size_t, std::size_t, std::size_t> best{0, 0, 0};
    for (std::size_t k = 0; k < inner.size(); ++k)
      for (std::size_t i = 0; i < outer.vertices.size(); ++i) {
        check_watched();
        for (std::size_t j = 0; j < inner[k].vertices.size(); ++j) {
          const double length = norm(vertex(outer, i) - vertex(inner[k], j));
          if (length >= least || !is_free(outer, inner, plane, i, vertex(inner[k], j))) continue;
          least = length;
          best = {k, i, j};
        }
      }
    return best;
  }

  bool crosses(const EdgeLoop& loop, const LoopPlane& plane, const Flat& a, const Flat& b) const {
    for (std::size_t k = 0; k < loop.vertices.size(); ++k) {
      const Flat c = plane.at(vertex(loop, k)), d = plane.at(vertex(loop, k + 1));
      if (side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0) return true;
    }
    return false;
  }

  const std::vector<EdgeLoop>& loops_;
  const std::vector<Vector3>& vertices_;
  std::vector<double> sizes_;  ///< areas
  std::vector<Vector3> normals_;
  std::vector<std::optional<LoopPlane>> planes_;
};

}  // namespace

std::vector<std::vector<DirectedEdge>> loops_of(std::vector<DirectedEdge> edges) {
  std::ranges::stable_sort(edges, {}, [](const DirectedEdge& edge) { return std::pair(edge.from, edge.to); });
  std::vector<std::uint8_t> is_used(edges.size(), 0);
  const auto next_from = [&](std::uint32_t vertex) -> std::optional<std::size_t> {
    const auto first = std::ranges::lower_bound(edges, vertex, {}, &DirectedEdge::from);
    for (auto e = static_cast<std::size_t>(first - edges.begin());
         e < edges.size() && edges[e].from == vertex; ++e)
      if (!is_used[e]) return e;
    return std::nullopt;
  };
  std::vector<std::vector<DirectedEdge>> loops;
  std::unordered_map<std::uint32_t, std::size_t> place_of;  // of the vertices of the path
  for (const DirectedEdge& start : edges) {
    std::vector<DirectedEdge> path;
    place_of.clear();
    for (auto next = next_from(start.from); next;
         next = next_from(path.empty() ? start.from : path.back().to)) {
      is_used[*next] = 1;
      place_of[edges[*next].from] = path.size();
      path.push_back(edges[*next]);
      const auto found = place_of.find(path.back().to);
      if (found == place_of.end()) continue;
      const auto loop = path.begin() + static_cast<std::ptrdiff_t>(found->second);
      for (auto edge = loop; edge != path.end(); ++edge) place_of.erase(edge->from);
      loops.emplace_back(loop, path.end());
      path.erase(loop, path.end());
    }
  }
  return loops;
}

std::vector<JoinedLoop> joined_loops(const std::vector<EdgeLoop>& loops,
                                     const std::vector<Vector3>& vertices) {
  return LoopJoining(loops, vertices).joined();
}

}  // namespace crossgrain
