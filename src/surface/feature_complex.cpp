// SPDX-License-Identifier: Apache-2.0
#include "surface/feature_complex.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

#include "base/degree.hpp"
#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "surface/feature_edges.hpp"
#include "surface/feature_fans.hpp"
#include "surface/feature_surface.hpp"
#include "surface/feature_turns.hpp"
#include "surface/model_faces.hpp"

namespace crossgrain {
namespace {

constexpr std::uint32_t kNone = FeatureComplex::kNone;

/// A feature edge seen from one of its vertices.
struct FeatureSpoke {
  std::uint32_t vertex, edge;

  friend auto operator<=>(const FeatureSpoke&, const FeatureSpoke&) = default;
};

/// A curve as a row of edges.
struct EdgeRow {
  std::vector<std::uint32_t> vertices, edges;
};

/// Increases from 0 to 4 with the angle of a vector in the plane; exact, unlike an angle.
double place_around(double x, double y) {
  const double sum = std::abs(x) + std::abs(y);
  const double share = sum > 0 ? y / sum : 0;
  if (x < 0) return 2 - share;
  return y < 0 ? 4 + share : share;
}

class FeatureFinder {
 public:
  FeatureFinder(const Surface& given, const FeatureOptions& options)
      : parts_(feature_surface(given, options.unite_solids)),
        surface_(parts_.surface),
        mesh_(surface_.mesh),
        uses_(sorted_edge_uses(mesh_.triangles)),
        edges_(feature_edges(parts_, uses_, options.angles)),
        fans_(parts_, uses_, edges_) {
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
      for (const std::uint32_t v : edges_[e].vertices) spokes_.push_back({v, e});
    std::sort(spokes_.begin(), spokes_.end());
  }

  FeatureComplex find(const Surface& given, const FeatureOptions& options) {
    find_faces();
    number_faces(face_numbers(given, options.angles));
    find_corners();
    find_curves();
    find_ends();
    find_sectors();
    count_cells();
    result_.vertices = mesh_.vertices;
    result_.triangles = mesh_.triangles;
    result_.corner_normals = mesh_.corner_normals;
    result_.source_of = std::move(parts_.source_of);
    return std::move(result_);
  }

 private:
  using Fan = FeatureFans::Fan;

  void find_faces() {
    DisjointSets joined(surface_.size());
    for (std::uint32_t h = 0; h < 3 * surface_.size(); ++h)
      if (fans_.opposite(h) != kNone) joined.join(h / 3, fans_.opposite(h) / 3);
    result_.face_of.resize(surface_.size());
    for (std::uint32_t t = 0; t < surface_.size(); ++t) {
      const std::uint32_t root = joined.root(t);
      if (root == t) {
        result_.face_of[t] = static_cast<std::uint32_t>(result_.faces.size());
        result_.faces.push_back({0, parts_.solids[t][0], parts_.solids[t][1], {}, 0, 0, 0});
      }
      result_.face_of[t] = result_.face_of[root];
      FeatureComplex::Face& face = result_.faces[result_.face_of[t]];
      face.triangles.push_back(t);
      face.area += surface_.areas[t];
    }
  }

  void number_faces(const std::vector<std::int32_t>& numbers) {
    for (FeatureComplex::Face& face : result_.faces)
      face.number = numbers[parts_.source_of[face.triangles.front()]];
  }

  std::span<const FeatureSpoke> spokes_at(std::uint32_t vertex) const {
    const auto [begin, end] = std::ranges::equal_range(spokes_, vertex, {}, &FeatureSpoke::vertex);
    return {begin, end};
  }

  const Vector3& direction_of(const FeatureSpoke& spoke) const {
    return edges_[spoke.edge].directions[edges_[spoke.edge].vertices[1] == spoke.vertex];
  }

  std::uint32_t far_end(const FeatureSpoke& spoke) const {
    const auto& [a, b] = edges_[spoke.edge].vertices;
    return a == spoke.vertex ? b : a;
  }

  /// Whether two edges are one curve: they are of one kind, nearly straight, and all triangles here lie
  /// between them.
  bool continue_each_other(const FeatureSpoke& a, const FeatureSpoke& b, std::span<const Fan> fans) const {
    if (edges_[a.edge].kind() != edges_[b.edge].kind()) return false;
    if (!(-dot(direction_of(a), direction_of(b)) > straight_)) return false;
    return std::ranges::all_of(fans, [&](const Fan& fan) {
      return !fan.is_closed && fans_.edge_of(fan.first) != fans_.edge_of(fan.last);
    });
  }

  bool is_corner(std::span<const FeatureSpoke> spokes, std::span<const Fan> fans) const {
    if (spokes.size() == 2) return !continue_each_other(spokes[0], spokes[1], fans);
    return !spokes.empty() || fans.size() > 1 || is_tip(fans_, fans[0], surface_);
  }

  /// Calls visit(vertex, fans) for every vertex of triangles.
  template <class Visit>
  void for_each_vertex(const Visit& visit) const {
    const std::vector<Fan>& fans = fans_.fans();
    Checkpoint checkpoint;
    for (std::size_t begin = 0, end = 0; begin < fans.size(); begin = end) {
      while (end < fans.size() && fans[end].vertex == fans[begin].vertex) ++end;
      checkpoint.pass();
      visit(fans[begin].vertex, std::span(fans).subspan(begin, end - begin));
    }
  }

  void find_corners() {
    corner_at_.assign(mesh_.vertices.size(), kNone);
    for_each_vertex([&](std::uint32_t vertex, std::span<const Fan> fans) {
      if (!is_corner(spokes_at(vertex), fans)) return;
      corner_at_[vertex] = static_cast<std::uint32_t>(result_.corners.size());
      result_.corners.push_back({vertex, mesh_.vertices[vertex], {}, {}});
    });
  }

  EdgeRow row_from(FeatureSpoke spoke, std::vector<std::uint8_t>& is_used) const {
    EdgeRow row{{spoke.vertex}, {}};
    for (;;) {
      is_used[spoke.edge] = 1;
      row.edges.push_back(spoke.edge);
      const std::uint32_t at = far_end(spoke);
      row.vertices.push_back(at);
      if (at == row.vertices.front() || corner_at_[at] != kNone) return row;
      const auto both = spokes_at(at);
      spoke = both[0].edge == spoke.edge ? both[1] : both[0];
    }
  }

  void find_curves() {
    std::vector<std::uint8_t> is_used(edges_.size(), 0);
    Checkpoint checkpoint;
    for (const bool is_loose : {false, true}) {
      for (const FeatureSpoke& spoke : spokes_) {
        checkpoint.pass();
        const bool is_at_corner = corner_at_[spoke.vertex] != kNone;
        if (!is_used[spoke.edge] && is_at_corner != is_loose) rows_.push_back(row_from(spoke, is_used));
      }
    }
    // Curves that begin and end at one corner are closed.
    std::ranges::stable_partition(
        rows_, [](const EdgeRow& row) { return row.vertices.front() != row.vertices.back(); });
    result_.curves.resize(rows_.size());
    parallel_for(
        rows_.size(), [&](std::size_t c) { result_.curves[c] = curve_of(rows_[c]); }, 16);
  }

  FeatureComplex::Curve curve_of(const EdgeRow& row) const {
    FeatureComplex::Curve curve{row.vertices,
                                {corner_at_[row.vertices.front()], corner_at_[row.vertices.back()]},
                                sides_of(row),
                                false,
                                false,
                                0,
                                0};
    double sharp = 0, turn = 0;
    bool is_forced = false;
    for (const std::uint32_t e : row.edges) {
      const FeatureEdge& edge = edges_[e];
      const double length = norm(mesh_.vertices[edge.vertices[1]] - mesh_.vertices[edge.vertices[0]]);
      curve.length += length;
      if (edge.is_crease) sharp += length;
      if (edge.is_forced)
        is_forced = true;
      else if (!edge.is_of_known_crease)
        turn += length * turn_deg_across(edge, fans_, surface_);
      if (curve.tag == 0) curve.tag = edge.tag;
    }
    curve.is_tagged = !is_forced && sharp < 0.5 * curve.length;
    curve.is_soft = curve.is_tagged && turn < kSoftDeg * curve.length;
    return curve;
  }

  /// The faces around the middle edge.
  std::vector<FeatureComplex::Side> sides_of(const EdgeRow& row) const {
    const std::size_t middle = row.edges.size() / 2;
    const FeatureEdge& edge = edges_[row.edges[middle]];
    const bool is_along = row.vertices[middle] == edge.vertices[0];
    const Vector3& from = mesh_.vertices[row.vertices[middle]];
    const Vector3 along = normalised(mesh_.vertices[row.vertices[middle + 1]] - from);
    const Vector3 x = orthogonal_unit(along), y = cross(along, x);
    struct Placed {
      double place;
      FeatureComplex::Side side;

      auto key() const { return std::tuple(place, side.face, !side.is_left); }
    };
    std::vector<Placed> placed;
    for (const EdgeUse& use : edge.uses) {
      const auto [a, b, c] = surface_.corners(use.triangle);
      // The corner off the edge, since both others are on it.
      const Vector3 off = (a - from) + (b - from) + (c - from);
      placed.push_back(
          {place_around(dot(off, x), dot(off, y)), {result_.face_of[use.triangle], use.forward == is_along}});
    }
    std::ranges::sort(placed, {}, &Placed::key);
    const auto first = std::ranges::min_element(
        placed, {}, [](const Placed& it) { return std::tuple(it.side.face, !it.side.is_left); });
    std::rotate(placed.begin(), first, placed.end());
    std::vector<FeatureComplex::Side> sides;
    for (const Placed& it : placed) sides.push_back(it.side);
    return sides;
  }

  void find_ends() {
    for (std::uint32_t c = 0; c < rows_.size(); ++c) {
      for (const bool is_last : {false, true}) {
        const EdgeRow& row = rows_[c];
        const std::uint32_t vertex = is_last ? row.vertices.back() : row.vertices.front();
        if (corner_at_[vertex] == kNone) continue;
        result_.corners[corner_at_[vertex]].ends.push_back({c, is_last});
        ends_.push_back({{vertex, is_last ? row.edges.back() : row.edges.front()},
                         static_cast<std::uint32_t>(result_.corners[corner_at_[vertex]].ends.size() - 1)});
      }
    }
    std::ranges::sort(ends_, {}, &EndOfSpoke::spoke);
  }

  std::uint32_t end_at(std::uint32_t vertex, std::uint32_t half_edge) const {
    return std::ranges::lower_bound(ends_, FeatureSpoke{vertex, fans_.edge_of(half_edge)}, {},
                                    &EndOfSpoke::spoke)
        ->end;
  }

  void find_sectors() {
    for_each_vertex([&](std::uint32_t vertex, std::span<const Fan> fans) {
      if (corner_at_[vertex] == kNone) return;
      auto& sectors = result_.corners[corner_at_[vertex]].sectors;
      for (const Fan& fan : fans) {
        const std::uint32_t face = result_.face_of[fan.first / 3];
        sectors.push_back({fan.is_closed ? kNone : end_at(vertex, fan.first),
                           fan.is_closed ? kNone : end_at(vertex, fan.last), face, result_.faces[face].below,
                           result_.faces[face].above, angle_rad_of(fans_, fan, surface_)});
      }
      std::ranges::stable_sort(
          sectors, {}, [](const FeatureComplex::Sector& it) { return std::tuple(it.from, it.face, it.to); });
    });
  }

  /// Euler numbers and loops of the faces, cut open along all curves: a fan is a vertex then, and the next
  /// half-edge of a border is that with which the fan begins in which the last one ends.
  void count_cells() {
    std::vector<std::size_t> vertices(result_.faces.size(), 0), border(result_.faces.size(), 0);
    std::vector<std::uint32_t> next(3 * surface_.size(), kNone);
    for (const Fan& fan : fans_.fans()) {
      const std::uint32_t face = result_.face_of[fan.first / 3];
      ++vertices[face];
      if (fan.is_closed) continue;
      ++border[face];
      next[fan.last] = fan.first;
    }
    for (std::uint32_t h = 0; h < next.size(); ++h) {
      if (next[h] == kNone) continue;
      ++result_.faces[result_.face_of[h / 3]].loops;
      for (std::uint32_t at = h; next[at] != kNone;) at = std::exchange(next[at], kNone);
    }
    for (std::size_t f = 0; f < result_.faces.size(); ++f) {
      FeatureComplex::Face& face = result_.faces[f];
      // Triangles have 3 T half-edges, of which two are an edge inside and one is on a border.
      face.euler = static_cast<int>(vertices[f]) - static_cast<int>((face.triangles.size() + border[f]) / 2);
    }
  }

  struct EndOfSpoke {
    FeatureSpoke spoke;
    std::uint32_t end;
  };

  FeatureSurface parts_;
  const Surface& surface_;
  const TriangleMesh& mesh_;
  std::vector<EdgeUse> uses_;
  std::vector<FeatureEdge> edges_;
  FeatureFans fans_;
  std::vector<FeatureSpoke> spokes_;  ///< ascending
  std::vector<std::uint32_t> corner_at_;
  std::vector<EdgeRow> rows_;  ///< of the curves
  std::vector<EndOfSpoke> ends_;
  const double straight_ = std::cos(kCornerDeg * kDegree);
  FeatureComplex result_;
};

}  // namespace

FeatureComplex feature_complex(const Surface& surface, const FeatureOptions& options) {
  return FeatureFinder(surface, options).find(surface, options);
}

}  // namespace crossgrain
