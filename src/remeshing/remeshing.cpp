// SPDX-License-Identifier: Apache-2.0
#include "remeshing/remeshing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/elementary.hpp"
#include "base/vector3.hpp"
#include "remeshing/given_shape.hpp"
#include "remeshing/patch_mesh.hpp"

namespace crossgrain {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// Edges are split above, and collapsed below, these multiples of the size: halves of the former are above
/// the latter, so that the two do not undo each other.
constexpr double kLong = 4.0 / 3, kShort = 4.0 / 5;

/// A flip must better the worse of two triangles by this factor, so that flips end.
constexpr double kBetter = 1.02;

/// Triangles of less quality are improved even where their edges have the wanted size.
constexpr double kPoor = 0.3;

/// The least quality, relative to kPoor, that the collapse of a very short edge may leave.
constexpr double kPoorest = 0.2;

/// A vertex may move if the worst triangle beside it keeps this share of its quality, or is as good as
/// kGood.
constexpr double kKeptShare = 0.98, kGood = 0.6;

/// What flips strive for. Where triangles are not Delaunay, a flat tet fits beneath two of them.
enum class Aim { kQuality, kDelaunay };

/// 180 degrees and a little, so that flips of four points on a circle end.
constexpr double kDelaunayAngles = std::numbers::pi * (1 + 1e-6);

/// Largest distance of an edge from the given surface, relative to the size there, and largest angle between
/// a triangle and the given surface beneath it (docs/notes/tets.md).
constexpr double kDistanceShare = 0.1, kTurnDeg = 35;

/// Rounds of splitting, collapsing and flipping edges, and of smoothing.
constexpr int kRounds = 5;

constexpr int kMostSplitPasses = 40, kMostFlipPasses = 6, kSmoothingsPerRound = 3;

class Remesher {
 public:
  Remesher(const PatchedSurface& given, const Remeshing& options, const Monitor& monitor)
      : given_(given),
        options_(options),
        monitor_(monitor),
        shape_(given, options),
        mesh_(given, shape_.sizes_of_vertices()),
        least_cosine_(std::cos(kTurnDeg * std::numbers::pi / 180)) {}

  PatchedSurface run() {
    for (int round = 0; round < kRounds; ++round) {
      // No flips in between: they would turn the slivers of CAD programs into flat triangles that stay.
      for (int pass = 0; pass < kMostSplitPasses && split_long(); ++pass) continue;
      flip_all();
      collapse_short();
      flip_all();
      for (int k = 0; k < kSmoothingsPerRound; ++k) smooth();
    }
    improve_poor();
    flip_all();
    smooth();
    flip_all(Aim::kDelaunay);
    return mesh_.result(given_);
  }

 private:
  double length(std::uint32_t a, std::uint32_t b) const {
    return norm(mesh_.vertices[b].position - mesh_.vertices[a].position);
  }
  double size_at(std::uint32_t a, std::uint32_t b) const {
    return (mesh_.vertices[a].size + mesh_.vertices[b].size) / 2;
  }
  double ratio(std::uint32_t a, std::uint32_t b) const { return length(a, b) / size_at(a, b); }

  /// Returns the edges for which counts(ratio of length to size), in the order of this ratio: the largest
  /// first, or the smallest.
  template <class Counts>
  std::vector<std::array<std::uint32_t, 2>> edges_where(const Counts& counts, bool largest_first) const {
    std::vector<std::pair<double, std::array<std::uint32_t, 2>>> found;
    for (const auto& edge : mesh_.edges()) {
      const double r = ratio(edge[0], edge[1]);
      if (counts(r)) found.emplace_back(largest_first ? -r : r, edge);
    }
    std::sort(found.begin(), found.end());
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (const auto& [unused, edge] : found) edges.push_back(edge);
    return edges;
  }

  /// Cosine between a triangle and the given surface beneath its middle; -1 if it is too far from there.
  double fit(const std::array<Vector3, 3>& corners, std::uint32_t patch, double size) const {
    const Vector3 middle = (1.0 / 3) * (corners[0] + corners[1] + corners[2]);
    const PlaceOnShape place = shape_.on_patch(patch, middle);
    if (norm(place.point - middle) > kDistanceShare * size) return -1;
    return dot(shape_of(corners).normal, place.normal);
  }

  double fit(const Corners& triangle, std::uint32_t patch) const {
    const auto& [a, b, c] = triangle;
    const double size = (mesh_.vertices[a].size + mesh_.vertices[b].size + mesh_.vertices[c].size) / 3;
    return fit(mesh_.corners(triangle), patch, size);
  }

  bool split_long() {
    monitor_.check_stop();
    bool any = false;
    for (const auto& [a, b] : edges_where([](double r) { return r > kLong; }, true)) {
      PatchEdge edge;
      if (!mesh_.find(a, b, edge)) continue;
      mesh_.split(edge, middle_of(edge));
      any = true;
    }
    return any;
  }

  /// The vertex that splits an edge: on the given surface, unless a triangle there would not fit.
  PatchMesh::Vertex middle_of(const PatchEdge& edge) const {
    const PatchMesh::Vertex &a = mesh_.vertices[edge.a], &b = mesh_.vertices[edge.b];
    const Vector3 middle = 0.5 * (a.position + b.position);
    const std::uint32_t curve = mesh_.curve_of(edge.a, edge.b), patch = mesh_.patch_of(edge.triangles[0]);
    const bool on_curve = curve != kNoCurve;
    const PlaceOnShape place = on_curve ? shape_.on_curve(curve, middle) : shape_.on_patch(patch, middle);
    const double grown = std::min(a.size, b.size) + kGradation * norm(b.position - a.position) / 2;
    PatchMesh::Vertex vertex{place.point, std::min(grown, place.size), on_curve ? Hold::kCurve : Hold::kPatch,
                             on_curve ? curve : patch};
    if (!halves_fit(edge, vertex.position)) vertex.position = middle;
    return vertex;
  }

  bool halves_fit(const PatchEdge& edge, const Vector3& middle) const {
    const auto at = [&](std::uint32_t vertex) { return mesh_.vertices[vertex].position; };
    const std::array<std::array<Vector3, 3>, 4> halves{{{at(edge.a), middle, at(edge.left)},
                                                        {middle, at(edge.b), at(edge.left)},
                                                        {middle, at(edge.a), at(edge.right)},
                                                        {at(edge.b), middle, at(edge.right)}}};
    const double size = size_at(edge.a, edge.b);
    for (std::size_t k = 0; k < halves.size(); ++k)
      if (fit(halves[k], mesh_.patch_of(edge.triangles[k / 2]), size) < least_cosine_) return false;
    return true;
  }

  void collapse_short() {
    monitor_.check_stop();
    for (const auto& [a, b] : edges_where([](double r) { return r < kShort; }, false)) {
      PatchEdge edge;
      if (!mesh_.find(a, b, edge) || ratio(a, b) >= kShort) continue;
      if (try_collapse(edge)) continue;
      if (mesh_.find(b, a, edge)) try_collapse(edge);
    }
  }

  bool try_collapse(const PatchEdge& edge) {
    if (!mesh_.may_collapse(edge) || !may_pull(edge)) return false;
    const PatchMesh::Vertex& gone = mesh_.vertices[edge.a];
    double& size = mesh_.vertices[edge.b].size;
    size = std::min(size, gone.size + kGradation * length(edge.a, edge.b));
    mesh_.collapse(edge);
    return true;
  }

  /// Whether the triangles at `edge.a` may be pulled to `edge.b`: they fit, no edge becomes long, and none is
  /// poorer than the worst before. Edges that are much too short go even so; flips better what is left.
  bool may_pull(const PatchEdge& edge) const {
    double worst = kPoor * std::clamp(ratio(edge.a, edge.b) / kShort, kPoorest, 1.0), worst_pulled = 1;
    for (const std::uint32_t t : mesh_.triangles_at(edge.a)) {
      Corners triangle = mesh_.triangle(t);
      worst = std::min(worst, quality_of(mesh_.corners(triangle)));
      if (t == edge.triangles[0] || t == edge.triangles[1]) continue;
      std::replace(triangle.begin(), triangle.end(), edge.a, edge.b);
      worst_pulled = std::min(worst_pulled, quality_of(mesh_.corners(triangle)));
      if (fit(triangle, mesh_.patch_of(t)) < least_cosine_) return false;
    }
    if (worst_pulled < worst) return false;
    for (const std::uint32_t other : mesh_.neighbours(edge.a)) {
      if (other == edge.b) continue;
      if (ratio(edge.b, other) > std::max(kLong, ratio(edge.a, other))) return false;
      if (mesh_.curve_of(edge.a, other) != kNoCurve && !may_bend(edge, other)) return false;
    }
    return true;
  }

  /// Whether a curve stays close if it goes straight from `other` to `edge.b`.
  bool may_bend(const PatchEdge& edge, std::uint32_t other) const {
    const Vector3 middle = 0.5 * (mesh_.vertices[edge.b].position + mesh_.vertices[other].position);
    const Vector3 place = shape_.on_curve(mesh_.curve_of(edge.a, other), middle).point;
    return norm(place - middle) <= kDistanceShare * size_at(edge.b, other);
  }

  void flip_all(Aim aim = Aim::kQuality) {
    // After the first pass only edges beside flipped ones.
    std::vector<std::uint8_t> is_changed(mesh_.vertices.size(), 1), will_be(is_changed.size(), 0);
    for (int pass = 0; pass < kMostFlipPasses; ++pass) {
      monitor_.check_stop();
      for (const auto& [a, b] : mesh_.edges()) {
        PatchEdge edge;
        if (is_changed[a] == 0 && is_changed[b] == 0) continue;
        if (!mesh_.find(a, b, edge) || !try_flip(edge, aim)) continue;
        for (const std::uint32_t v : {edge.a, edge.b, edge.left, edge.right}) will_be[v] = 1;
      }
      std::swap(is_changed, will_be);
      std::fill(will_be.begin(), will_be.end(), 0);
    }
  }

  /// Whether the angles opposite an edge add up to more than 180 degrees.
  bool is_delaunay(const PatchEdge& edge) const {
    double angles = 0;
    for (const std::uint32_t opposite : {edge.left, edge.right}) {
      const Vector3 to_a = mesh_.vertices[edge.a].position - mesh_.vertices[opposite].position;
      const Vector3 to_b = mesh_.vertices[edge.b].position - mesh_.vertices[opposite].position;
      angles += arc_tangent(norm(cross(to_a, to_b)), dot(to_a, to_b));
    }
    return angles <= kDelaunayAngles;
  }

  bool try_flip(const PatchEdge& edge, Aim aim) {
    const std::uint32_t patch = mesh_.patch_of(edge.triangles[0]);
    if (mesh_.patch_of(edge.triangles[1]) != patch) return false;
    const Corners first{edge.a, edge.right, edge.left}, second{edge.b, edge.left, edge.right};
    const double before = std::min(quality_of(mesh_.corners(mesh_.triangle(edge.triangles[0]))),
                                   quality_of(mesh_.corners(mesh_.triangle(edge.triangles[1]))));
    const double after = std::min(quality_of(mesh_.corners(first)), quality_of(mesh_.corners(second)));
    const bool is_worth_it = aim == Aim::kQuality ? after > kBetter * before : !is_delaunay(edge);
    if (!is_worth_it || after < std::min(before, kPoor) || !mesh_.may_flip(edge)) return false;
    if (fit(first, patch) < least_cosine_ || fit(second, patch) < least_cosine_) return false;
    const Vector3 middle = 0.5 * (mesh_.vertices[edge.left].position + mesh_.vertices[edge.right].position);
    const double away = norm(shape_.on_patch(patch, middle).point - middle);
    if (away > kDistanceShare * size_at(edge.left, edge.right)) return false;
    mesh_.flip(edge);
    return true;
  }

  void smooth() {
    monitor_.check_stop();
    for (std::uint32_t v = 0; v < mesh_.vertices.size(); ++v) {
      if (mesh_.vertices[v].hold == Hold::kFixed || mesh_.triangles_at(v).empty()) continue;
      try_move(v, wanted_place(v));
    }
  }

  /// On a patch the mean of the middles of the triangles, by area; on a curve the middle between both
  /// neighbours.
  Vector3 wanted_place(std::uint32_t v) const {
    const PatchMesh::Vertex& vertex = mesh_.vertices[v];
    Vector3 sum{0, 0, 0};
    double weight = 0;
    if (vertex.hold == Hold::kCurve) {
      for (const std::uint32_t other : mesh_.neighbours(v)) {
        if (mesh_.curve_of(v, other) == kNoCurve) continue;
        sum += mesh_.vertices[other].position;
        weight += 1;
      }
      return shape_.on_curve(vertex.home, (1 / weight) * sum).point;
    }
    for (const std::uint32_t t : mesh_.triangles_at(v)) {
      const auto corners = mesh_.corners(mesh_.triangle(t));
      const double area = shape_of(corners).area;
      sum += area / 3 * (corners[0] + corners[1] + corners[2]);
      weight += area;
    }
    return weight > 0 ? shape_.on_patch(vertex.home, (1 / weight) * sum).point : vertex.position;
  }

  double worst_at(std::uint32_t v) const {
    double worst = 1;
    for (const std::uint32_t t : mesh_.triangles_at(v))
      worst = std::min(worst, quality_of(mesh_.corners(mesh_.triangle(t))));
    return worst;
  }

  void try_move(std::uint32_t v, const Vector3& place) {
    const double before = worst_at(v);
    const Vector3 old = std::exchange(mesh_.vertices[v].position, place);
    bool fits = worst_at(v) >= std::min(kGood, kKeptShare * before);
    for (const std::uint32_t t : mesh_.triangles_at(v))
      fits = fits && fit(mesh_.triangle(t), mesh_.patch_of(t)) >= least_cosine_;
    if (!fits) mesh_.vertices[v].position = old;
  }

  /// Collapses the shortest edges of poor triangles, whatever their length.
  void improve_poor() {
    monitor_.check_stop();
    for (const auto& [a, b] : edges_where([](double) { return true; }, false)) {
      PatchEdge edge;
      if (!mesh_.find(a, b, edge)) continue;
      bool is_poor = false;
      for (const std::uint32_t t : edge.triangles)
        is_poor |= quality_of(mesh_.corners(mesh_.triangle(t))) < kPoor;
      if (!is_poor || try_collapse(edge)) continue;
      if (mesh_.find(b, a, edge)) try_collapse(edge);
    }
  }

  const PatchedSurface& given_;
  const Remeshing& options_;
  const Monitor& monitor_;
  GivenShape shape_;
  PatchMesh mesh_;
  double least_cosine_;
};

}  // namespace

double quality_of(const std::array<Vector3, 3>& corners) {
  double squares = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 edge = corners[(k + 1) % 3] - corners[k];
    squares += dot(edge, edge);
  }
  const double twice_area = norm(cross(corners[1] - corners[0], corners[2] - corners[0]));
  return squares > 0 ? 2 * std::numbers::sqrt3 * twice_area / squares : 0;
}

PatchedSurface remeshed(const PatchedSurface& given, const Remeshing& options, const Monitor& monitor) {
  return Remesher(given, options, monitor).run();
}

}  // namespace crossgrain
