// SPDX-License-Identifier: Apache-2.0
#include "surface/united_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "surface/bvh.hpp"
#include "surface/edge_loops.hpp"
#include "surface/loop_triangles.hpp"
#include "surface/patch_sides.hpp"
#include "surface/stitching.hpp"
#include "surface/surface.hpp"
#include "surface/topology.hpp"
#include "surface/winding_number.hpp"

namespace crossgrain {
namespace {

/// The corners of a convex piece of a triangle, counter-clockwise about its normal.
using CutPiece = std::vector<Vector3>;

/// How far from a triangle the winding numbers of its sides are taken, in gaps.
constexpr double kBesides = 4;

/// Points are the same if they are nearer than this, in gaps: above the rounding of cuts.
constexpr double kSame = 1e-3;

struct CutPlane {
  Vector3 normal, at;

  double height(const Vector3& p) const { return dot(p - at, normal); }
};

/// A stretch on a line, by two points.
struct Stretch {
  Vector3 from, to;
};

/// Where the border of a polygon passes through a plane, the same to the bit for both polygons of an edge.
Vector3 crossing_point(const Vector3& a, const Vector3& b, const CutPlane& plane) {
  const Vector3 &low = std::min(a, b), &high = std::max(a, b);
  const double from = plane.height(low), to = plane.height(high);
  return low + from / (from - to) * (high - low);
}

/// What is left of a triangle.
struct LeftOfTriangle {
  bool is_whole = false;
  std::vector<Vector3> points = {};  ///< of the triangles of what is left of one that is cut
  std::vector<std::array<std::uint32_t, 3>> triangles = {};
};

/// Joins pieces of a triangle that lie side by side, and cuts what they are into as few triangles as it
/// needs.
class PieceJoining {
 public:
  PieceJoining(const std::vector<CutPiece>& pieces, double gap) : gap_(gap), same_(kSame * gap) {
    for (const CutPiece& piece : pieces) {
      std::vector<std::uint32_t> corners;
      for (const Vector3& p : piece) corners.push_back(index_of(p));
      corners_.push_back(std::move(corners));
    }
  }

  LeftOfTriangle joined() && {
    std::vector<EdgeLoop> loops;
    for (const auto& edges : loops_of(border())) {
      EdgeLoop loop;
      for (const DirectedEdge& edge : edges) loop.vertices.push_back(edge.from);
      leave_out_straight(loop.vertices);
      loop.across.assign(loop.vertices.size(), {});
      if (loop.vertices.size() > 2) loops.push_back(std::move(loop));
    }
    LeftOfTriangle left;
    for (JoinedLoop& loop : joined_loops(loops, points_)) {
      const auto added = loop_triangles(std::move(loop.loop), points_, [](auto, auto) { return false; });
      left.triangles.insert(left.triangles.end(), added.begin(), added.end());
    }
    left.points = std::move(points_);
    return left;
  }

 private:
  std::uint32_t index_of(const Vector3& p) {
    for (std::size_t k = 0; k < points_.size(); ++k)
      if (norm(points_[k] - p) <= same_) return static_cast<std::uint32_t>(k);
    points_.push_back(p);
    return static_cast<std::uint32_t>(points_.size() - 1);
  }

  /// The edges of pieces, cut at points on them, that belong to one piece.
  std::vector<DirectedEdge> border() const {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> count;
    for (const auto& corners : corners_)
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const std::vector<std::uint32_t> along = points_along(corners[k], corners[(k + 1) % corners.size()]);
        for (std::size_t i = 0; i + 1 < along.size(); ++i) ++count[{along[i], along[i + 1]}];
      }
    std::vector<DirectedEdge> edges;
    for (const auto& [edge, times] : count) {
      const auto other = count.find({edge.second, edge.first});
      const std::size_t back = other == count.end() ? 0 : other->second;
      if (times > back) edges.insert(edges.end(), times - back, {edge.first, edge.second});
    }
    return edges;
  }

  std::vector<std::uint32_t> points_along(std::uint32_t from, std::uint32_t to) const {
    if (from == to) return {};
    const Vector3 &a = points_[from], way = points_[to] - a;
    const double length = norm(way);
    std::vector<std::pair<double, std::uint32_t>> on = {{0, from}, {length, to}};
    for (std::uint32_t k = 0; k < points_.size(); ++k) {
      const double along = dot(points_[k] - a, way) / length;
      if (k == from || k == to || along <= 0 || along >= length) continue;
      if (norm(points_[k] - a - (along / length) * way) <= same_) on.emplace_back(along, k);
    }
    std::ranges::sort(on);
    std::vector<std::uint32_t> along;
    for (const auto& [place, k] : on) along.push_back(k);
    return along;
  }

  /// Leaves out corners at which a loop turns by less than the gap: triangles there would be thinner than it.
  void leave_out_straight(std::vector<std::uint32_t>& loop) const {
    for (std::size_t k = 0; k < loop.size() && loop.size() > 2;) {
      const Vector3 &a = points_[loop[(k + loop.size() - 1) % loop.size()]], &p = points_[loop[k]],
                    &b = points_[loop[(k + 1) % loop.size()]];
      const Vector3 way = b - a;
      const double squared = dot(way, way), along = squared > 0 ? dot(p - a, way) / squared : 0;
      const bool is_straight = along > 0 && along < 1 && norm(p - a - along * way) <= gap_;
      if (is_straight)
        loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(k));
      else
        ++k;
    }
  }

  const double gap_, same_;
  std::vector<Vector3> points_;
  std::vector<std::vector<std::uint32_t>> corners_;
};

class Cutter {
 public:
  explicit Cutter(const SearchableSurface& searchable)
      : surface_(searchable.surface()),
        tree_(searchable.bvh()),
        winding_(searchable.winding()),
        gap_(kUniteGap * longest_side(surface_.box)) {}

  double gap() const { return gap_; }

  LeftOfTriangle left_of(std::uint32_t t) const {
    check_watched();
    const auto corners = surface_.corners(t);
    std::vector<CutPiece> pieces = {{corners[0], corners[1], corners[2]}};
    std::vector<std::uint32_t> in_plane;
    for_each_beside(t, [&](std::uint32_t other) {
      if (is_in_plane(t, other)) {
        cut_by_edges(pieces, t, other);
        in_plane.push_back(other);
      } else if (const auto stretch = stretch_in_plane(t, other)) {
        cut(pieces, {surface_.normals[other], surface_.corners(other)[0]}, *stretch);
      }
    });
    const bool is_cut = pieces.size() > 1;
    std::erase_if(pieces, [&](const CutPiece& piece) { return !is_outer(piece, t, in_plane); });
    if (!is_cut) return {.is_whole = !pieces.empty()};
    return PieceJoining(pieces, gap_).joined();
  }

 private:
  /// Other triangles whose boxes meet that of a triangle, ascending.
  template <class Visit>
  void for_each_beside(std::uint32_t t, const Visit& visit) const {
    const auto corners = surface_.corners(t);
    Box box = empty_box();
    for (const Vector3& p : corners) include(box, p);
    const Vector3 margin{gap_, gap_, gap_};
    std::vector<std::uint32_t> others;
    for_each_triangle_near(tree_, {box.low - margin, box.high + margin}, [&](std::uint32_t other) {
      if (other != t) others.push_back(other);
      return true;
    });
    std::ranges::sort(others);
    for (const std::uint32_t other : others) visit(other);
  }

  CutPlane plane_of(std::uint32_t t) const { return {surface_.normals[t], surface_.corners(t)[0]}; }

  bool is_in_plane(std::uint32_t t, std::uint32_t other) const {
    const CutPlane plane = plane_of(t);
    return std::ranges::all_of(surface_.corners(other),
                               [&](const Vector3& p) { return std::abs(plane.height(p)) <= gap_; });
  }

  /// Where a triangle passes through the plane of another one.
  std::optional<Stretch> stretch_in_plane(std::uint32_t t, std::uint32_t other) const {
    const CutPlane plane = plane_of(t);
    const auto corners = surface_.corners(other);
    std::vector<Vector3> points;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 &a = corners[k], &b = corners[(k + 1) % 3];
      const double from = plane.height(a), to = plane.height(b);
      if (std::abs(from) <= gap_) points.push_back(a);
      if (std::min(from, to) < -gap_ && std::max(from, to) > gap_)
        points.push_back(crossing_point(a, b, plane));
    }
    if (points.size() < 2) return std::nullopt;
    return Stretch{points[0], points[1]};
  }

  /// Cuts pieces by the planes through the edges of a triangle in their plane.
  void cut_by_edges(std::vector<CutPiece>& pieces, std::uint32_t t, std::uint32_t other) const {
    const auto corners = surface_.corners(other);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 &a = corners[k], &b = corners[(k + 1) % 3];
      const Vector3 across = cross(b - a, surface_.normals[t]);
      const double length = norm(across);
      if (length > 0) cut(pieces, {(1 / length) * across, a}, {a, b});
    }
  }

  /// Cuts those pieces by a plane through which a stretch in it passes.
  void cut(std::vector<CutPiece>& pieces, const CutPlane& plane, const Stretch& stretch) const {
    const std::size_t count = pieces.size();
    for (std::size_t k = 0; k < count; ++k) {
      auto halves = halves_of(pieces[k], plane, stretch);
      if (!halves) continue;
      pieces[k] = std::move(halves->first);
      pieces.push_back(std::move(halves->second));
    }
  }

  std::optional<std::pair<CutPiece, CutPiece>> halves_of(const CutPiece& piece, const CutPlane& plane,
                                                         const Stretch& stretch) const {
    std::vector<double> heights;
    for (const Vector3& p : piece) heights.push_back(plane.height(p));
    const auto [low, high] = std::ranges::minmax(heights);
    if (low >= -gap_ || high <= gap_) return std::nullopt;
    std::pair<CutPiece, CutPiece> halves;
    std::vector<Vector3> on;
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const std::size_t next = (k + 1) % piece.size();
      const bool is_on = std::abs(heights[k]) <= gap_;
      if (is_on || heights[k] < 0) halves.first.push_back(piece[k]);
      if (is_on || heights[k] > 0) halves.second.push_back(piece[k]);
      if (is_on) on.push_back(piece[k]);
      if (std::min(heights[k], heights[next]) >= -gap_ || std::max(heights[k], heights[next]) <= gap_)
        continue;
      on.push_back(crossing_point(piece[k], piece[next], plane));
      halves.first.push_back(on.back());
      halves.second.push_back(on.back());
    }
    if (on.size() < 2 || !overlap(on, stretch)) return std::nullopt;
    return halves;
  }

  /// Whether points on a line, and a stretch of it, have more than a gap in common.
  bool overlap(const std::vector<Vector3>& on, const Stretch& stretch) const {
    const Vector3 along = stretch.to - stretch.from;
    const double length = norm(along);
    if (length <= gap_) return false;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Vector3& p : on) {
      const double place = dot(p - stretch.from, along) / length;
      low = std::min(low, place);
      high = std::max(high, place);
    }
    return std::min(high, length) - std::max(low, 0.0) > gap_;
  }

  /// Whether a piece of a triangle has outside before it and inside behind it, and is the first there.
  bool is_outer(const CutPiece& piece, std::uint32_t t, const std::vector<std::uint32_t>& in_plane) const {
    Vector3 middle{};
    for (const Vector3& p : piece) middle += (1 / static_cast<double>(piece.size())) * p;
    for (const std::uint32_t other : in_plane)
      if (other < t && dot(surface_.normals[other], surface_.normals[t]) > 0 && is_within(middle, other))
        return false;
    const double outward = winding_.flipped() ? -1 : 1;
    const Vector3 besides = outward * kBesides * gap_ * surface_.normals[t];
    return winding_.at(middle + besides) < 0.5 && winding_.at(middle - besides) > 0.5;
  }

  /// Whether a point in the plane of a triangle is in it.
  bool is_within(const Vector3& p, std::uint32_t t) const {
    const auto corners = surface_.corners(t);
    for (std::size_t k = 0; k < 3; ++k)
      if (dot(cross(corners[(k + 1) % 3] - corners[k], p - corners[k]), surface_.normals[t]) < 0)
        return false;
    return true;
  }

  const Surface& surface_;
  const TriangleBvh& tree_;
  const WindingNumber& winding_;
  const double gap_;
};

}  // namespace

TriangleMesh united_triangles(const SearchableSurface& searchable) {
  const Surface& surface = searchable.surface();
  const Cutter cutter(searchable);
  std::vector<LeftOfTriangle> left(surface.size());
  // A triangle that many others cross takes long.
  constexpr std::size_t kGrain = 8;
  parallel_for(
      left.size(), [&](std::size_t t) { left[t] = cutter.left_of(static_cast<std::uint32_t>(t)); }, kGrain);
  std::vector<std::uint32_t> sources;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Vector3> vertices = surface.mesh.vertices;
  for (std::uint32_t t = 0; t < left.size(); ++t) {
    if (left[t].is_whole) left[t].triangles.push_back(surface.mesh.triangles[t]);
    const auto first = static_cast<std::uint32_t>(left[t].is_whole ? 0 : vertices.size());
    for (const auto& [a, b, c] : left[t].triangles) {
      triangles.push_back({first + a, first + b, first + c});
      sources.push_back(t);
    }
    vertices.insert(vertices.end(), left[t].points.begin(), left[t].points.end());
  }
  TriangleMesh mesh = selected_triangles(surface.mesh, sources);
  mesh.triangles = std::move(triangles);
  mesh.vertices = std::move(vertices);
  mesh.corner_normals.clear();  // of whole triangles
  mesh = weld(std::move(mesh));
  // Exact cuts first, so that the few that are not move no others.
  for (const double gap : {kSame * cutter.gap(), cutter.gap()})
    mesh = divided_at_open_vertices(stitched(std::move(mesh), gap, StitchedVertices::kAll).mesh, gap);
  mesh = stitched(std::move(mesh), cutter.gap(), StitchedVertices::kAll).mesh;
  return mesh;
}

}  // namespace crossgrain
