// SPDX-License-Identifier: Apache-2.0
#include "fit/feature_carriers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// A radian of turn takes as much of an edge as this many sizes: a circle gets 4 pi edges at least.
constexpr double kTurnShare = 2;

double squared_distance_to(const Box& box, const Vector3& p) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double outside = std::max({box.low[k] - p[k], p[k] - box.high[k], 0.0});
    sum += outside * outside;
  }
  return sum;
}

/// The value at x of the piecewise linear function with these values at ascending places.
double interpolated(const std::vector<double>& places, const std::vector<double>& values, double x) {
  const auto above = std::upper_bound(places.begin() + 1, places.end() - 1, x);
  const auto k = static_cast<std::size_t>(above - places.begin());
  const double step = places[k] - places[k - 1];
  const double t = step > 0 ? std::clamp((x - places[k - 1]) / step, 0.0, 1.0) : 0;
  return (1 - t) * values[k - 1] + t * values[k];
}

/// The nearest point of a tree where triangles that face elsewhere count as farther.
class FacingSearch {
 public:
  FacingSearch(const TriangleBvh& tree, const Vector3& p, const Vector3& normal, double reach)
      : tree_(tree), p_(p), normal_(normal), square_(reach * reach) {
    visit(0);
  }

  const Vector3& point() const { return point_; }
  std::uint32_t triangle() const { return triangle_; }

 private:
  double bound(std::uint32_t node) const { return squared_distance_to(tree_.nodes()[node].box, p_); }

  void visit(std::uint32_t root) {
    // The builder of trees bounds their depth.
    std::array<std::pair<std::uint32_t, double>, 96> stack;
    std::size_t waiting = 0;
    stack[waiting++] = {root, bound(root)};
    while (waiting > 0) {
      const auto [index, bound_of] = stack[--waiting];
      if (bound_of > best_) continue;
      const TriangleBvh::Node& node = tree_.nodes()[index];
      if (node.skip == index + 1) {
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
          look_at(tree_.triangle_order()[k]);
        continue;
      }
      const std::uint32_t left = index + 1, right = tree_.nodes()[left].skip;
      const std::pair<std::uint32_t, double> a{left, bound(left)}, b{right, bound(right)};
      stack[waiting++] = a.second <= b.second ? b : a;
      stack[waiting++] = a.second <= b.second ? a : b;
    }
  }

  void look_at(std::uint32_t triangle) {
    constexpr double kFacing = 0.7;  // 45 degrees
    const Vector3 point = nearest_on_triangle(tree_.surface().corners(triangle), p_);
    const double off = std::max(0.0, kFacing - dot(normal_, tree_.surface().normals[triangle]));
    const double value = dot(point - p_, point - p_) + square_ * off * off;
    if (value > best_ || (value == best_ && triangle > triangle_)) return;
    best_ = value, triangle_ = triangle, point_ = point;
  }

  const TriangleBvh& tree_;
  const Vector3& p_;
  const Vector3& normal_;
  double square_;
  double best_ = INFINITY;
  std::uint32_t triangle_ = 0;
  Vector3 point_{0, 0, 0};
};

}  // namespace

FeatureCarriers::FeatureCarriers(const FeatureComplex& complex,
                                 const std::vector<std::uint32_t>& group_of_face)
    : complex_(&complex), groups_(complex.faces.size()) {
  std::vector<TriangleMesh> meshes(complex.faces.size());
  for (std::size_t t = 0; t < complex.triangles.size(); ++t) {
    TriangleMesh& mesh = meshes[group_of_face[complex.face_of[t]]];
    mesh.triangles.push_back(complex.triangles[t]);
    if (!complex.corner_normals.empty()) mesh.corner_normals.push_back(complex.corner_normals[t]);
  }
  for (std::size_t g = 0; g < meshes.size(); ++g) {
    if (meshes[g].triangles.empty()) continue;
    std::vector<std::uint32_t> used;
    for (auto& triangle : meshes[g].triangles)
      for (const std::uint32_t v : triangle) used.push_back(v);
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const std::uint32_t v : used) meshes[g].vertices.push_back(complex.vertices[v]);
    for (auto& triangle : meshes[g].triangles)
      for (std::uint32_t& v : triangle)
        v = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
    groups_[g] = std::make_unique<Group>();
    groups_[g]->surface = prepare_surface(CheckedMesh::derived(std::move(meshes[g])));
    groups_[g]->tree.emplace(groups_[g]->surface);
  }
  for (const FeatureComplex::Curve& curve : complex.curves) curves_.push_back(polyline_of(curve));
}

FeatureCarriers::Polyline FeatureCarriers::polyline_of(const FeatureComplex::Curve& curve) const {
  Polyline polyline;
  for (const std::uint32_t v : curve.vertices) polyline.points.push_back(complex_->vertices[v]);
  const std::size_t count = polyline.points.size();
  polyline.lengths.assign(1, 0);
  std::vector<Vector3> along;
  for (std::size_t k = 1; k < count; ++k) {
    const Vector3 step = polyline.points[k] - polyline.points[k - 1];
    polyline.lengths.push_back(polyline.lengths.back() + norm(step));
    along.push_back(normalised(step));
  }
  for (std::size_t k = 0; k < count; ++k) {
    const bool is_end = k == 0 || k + 1 == count;
    const Vector3 before = k > 0 ? along[k - 1] : curve.is_closed() ? along.back() : along.front();
    const Vector3 after = k + 1 < count ? along[k] : curve.is_closed() ? along.front() : along.back();
    polyline.tangents.push_back(is_end && !curve.is_closed() ? (k == 0 ? after : before)
                                                             : normalised(before + after));
  }
  return polyline;
}

FeatureCarriers::Place FeatureCarriers::on_group(std::uint32_t group, const Vector3& p, const Vector3& normal,
                                                 double reach) const {
  const Group& faces = *groups_[group];
  const FacingSearch search(*faces.tree, p, normal, reach);
  return {search.point(), faces.surface.normal_at(search.triangle(), search.point())};
}

std::size_t FeatureCarriers::segment_at(const Polyline& polyline, double arc_length) const {
  const auto& lengths = polyline.lengths;
  const auto above = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, arc_length);
  return static_cast<std::size_t>(above - lengths.begin()) - 1;
}

FeatureCarriers::Place FeatureCarriers::on_curve(std::uint32_t curve, double arc_length) const {
  const Polyline& polyline = curves_[curve];
  const double whole = polyline.lengths.back();
  if (is_closed(curve)) arc_length -= whole * std::floor(arc_length / whole);
  arc_length = std::clamp(arc_length, 0.0, whole);
  const std::size_t k = segment_at(polyline, arc_length);
  const double step = polyline.lengths[k + 1] - polyline.lengths[k];
  const double t = step > 0 ? std::clamp((arc_length - polyline.lengths[k]) / step, 0.0, 1.0) : 0;
  return {(1 - t) * polyline.points[k] + t * polyline.points[k + 1],
          normalised((1 - t) * polyline.tangents[k] + t * polyline.tangents[k + 1])};
}

double FeatureCarriers::nearest_on_curve(std::uint32_t curve, const Vector3& p, double low,
                                         double high) const {
  const Polyline& polyline = curves_[curve];
  const double whole = polyline.lengths.back();
  const bool wraps = is_closed(curve);
  if (!wraps) low = std::clamp(low, 0.0, whole), high = std::clamp(high, low, whole);
  if (wraps && high - low > whole) high = low + whole;
  double best = INFINITY, nearest = low;
  double period = wraps ? whole * std::floor(low / whole) : 0;
  std::size_t k = segment_at(polyline, low - period);
  for (;; ++k) {
    if (k + 1 == polyline.points.size()) {
      if (!wraps) break;
      k = 0, period += whole;
    }
    const double from = period + polyline.lengths[k], step = polyline.lengths[k + 1] - polyline.lengths[k];
    if (from > high || (from == high && best < INFINITY)) break;
    if (!(step > 0)) continue;
    const Vector3 along = polyline.points[k + 1] - polyline.points[k];
    const double least = std::clamp((low - from) / step, 0.0, 1.0),
                 most = std::clamp((high - from) / step, least, 1.0);
    const double t = std::clamp(dot(p - polyline.points[k], along) / dot(along, along), least, most);
    const Vector3 off = polyline.points[k] + t * along - p;
    if (dot(off, off) < best) best = dot(off, off), nearest = from + t * step;
  }
  return nearest;
}

std::vector<double> FeatureCarriers::shares(std::uint32_t curve, std::size_t edges, double size,
                                            double first) const {
  const Polyline& polyline = curves_[curve];
  const std::vector<double>& lengths = polyline.lengths;
  const std::size_t segments = polyline.points.size() - 1;
  std::vector<double> sums{0};
  for (std::size_t k = 0; k < segments; ++k) {
    // The chord of a turn is near to its angle.
    const double turn = norm(polyline.tangents[k + 1] - polyline.tangents[k]);
    sums.push_back(sums.back() + (lengths[k + 1] - lengths[k]) / size + kTurnShare * turn);
  }
  const double periods = std::floor(first / lengths.back());
  const double begin = interpolated(lengths, sums, first - periods * lengths.back());
  std::vector<double> result{first};
  for (std::size_t e = 1; e < edges; ++e) {
    double sum = begin + sums.back() * static_cast<double>(e) / static_cast<double>(edges);
    const double around = sum > sums.back() ? 1 : 0;
    sum -= around * sums.back();
    result.push_back((periods + around) * lengths.back() + interpolated(sums, lengths, sum));
  }
  result.push_back(first + lengths.back());
  return result;
}

}  // namespace crossgrain
