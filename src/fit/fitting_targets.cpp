// SPDX-License-Identifier: Apache-2.0
#include "fit/fitting_targets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "base/parallel.hpp"
#include "base/vector3.hpp"

namespace crossgrain {
namespace {

using Kind = HexCarrier::Kind;

/// Of the distance to the next vertex of the curve, which a vertex may slide.
constexpr double kSlide = 0.35;

/// In sizes: how much farther faces count that look elsewhere.
constexpr double kFacingReach = 0.5;

Lists<std::uint32_t> neighbours_on(const HexCarriers& carriers) {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (const HexCarriers::Quad& quad : carriers.quads)
    for (std::size_t k = 0; k < 4; ++k) {
      pairs.push_back({quad.vertices[k], quad.vertices[(k + 1) % 4]});
      pairs.push_back({quad.vertices[(k + 1) % 4], quad.vertices[k]});
    }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return Lists<std::uint32_t>(carriers.of_vertex.size(), [&](const auto& add) {
    for (const auto& [from, to] : pairs) add(from, to);
  });
}

}  // namespace

FittingTargets::FittingTargets(const FeatureComplex& complex, const HexCarriers& carriers, double size)
    : carriers_(carriers),
      size_(size),
      features_(complex, carriers.group_of_face),
      neighbours_(neighbours_on(carriers)),
      evenly_(carriers.of_vertex.size(), Vector3{0, 0, 0}),
      windows_(carriers.of_vertex.size()) {
  for (std::uint32_t v = 0; v < evenly_.size(); ++v)
    if (carriers.of_vertex[v].kind == Kind::kCorner)
      evenly_[v] = features_.corner(carriers.of_vertex[v].index);
}

std::vector<Vector3> FittingTargets::normals_of(const HexMesh& mesh) const {
  std::vector<Vector3> normals(mesh.vertices.size(), Vector3{0, 0, 0});
  for (const HexCarriers::Quad& quad : carriers_.quads) {
    const auto& [a, b, c, d] = quad.vertices;
    const Vector3 normal =
        normalised(cross(mesh.vertices[c] - mesh.vertices[a], mesh.vertices[d] - mesh.vertices[b]));
    for (const std::uint32_t v : quad.vertices) normals[v] += normal;
  }
  for (Vector3& normal : normals) normal = normalised(normal);
  return normals;
}

FeatureCarriers::Place FittingTargets::nearest(std::uint32_t vertex, const Vector3& p,
                                               const Vector3& normal) const {
  const HexCarrier& carrier = carriers_.of_vertex[vertex];
  switch (carrier.kind) {
    case Kind::kFace:
      return features_.on_group(carrier.index, p, normal, kFacingReach * size_);
    case Kind::kCurve: {
      const auto& [low, high] = windows_[vertex];
      return features_.on_curve(carrier.index, features_.nearest_on_curve(carrier.index, p, low, high));
    }
    default:
      return {features_.corner(carrier.index), {0, 0, 0}};
  }
}

void FittingTargets::spread(const HexMesh& mesh) {
  spread_curves(mesh);
  spread_faces(mesh);
}

/// Of a closed curve, the start for which vertices are least far from their shares.
double FittingTargets::first_share(std::uint32_t curve, const std::vector<std::uint32_t>& path,
                                   const HexMesh& mesh) const {
  if (!features_.is_closed(curve) || carriers_.of_vertex[path[0]].kind == Kind::kCorner) return 0;
  const std::size_t edges = path.size() - 1;
  const double whole = features_.length(curve);
  const std::vector<double> plain = features_.shares(curve, edges, size_, 0);
  double best = INFINITY, first = 0;
  constexpr std::size_t kMostStarts = 24;
  const std::size_t step = (edges + kMostStarts - 1) / kMostStarts;
  for (std::size_t k = 0; k < edges; k += step) {
    double start = features_.nearest_on_curve(curve, mesh.vertices[path[k]], 0, whole) - plain[k];
    start -= whole * std::floor(start / whole);
    const std::vector<double> shares = features_.shares(curve, edges, size_, start);
    double sum = 0;
    for (std::size_t e = 0; e < edges; ++e) {
      const Vector3 off = features_.on_curve(curve, shares[e]).point - mesh.vertices[path[e]];
      sum += dot(off, off);
    }
    if (sum < best) best = sum, first = start;
  }
  return first;
}

void FittingTargets::spread_curves(const HexMesh& mesh) {
  for (std::uint32_t c = 0; c < carriers_.path_of_curve.size(); ++c) {
    const std::vector<std::uint32_t>& path = carriers_.path_of_curve[c];
    if (path.size() < 2) continue;
    const std::vector<double> shares =
        features_.shares(c, path.size() - 1, size_, first_share(c, path, mesh));
    set_windows(c, shares);
    for (std::size_t k = 0; k + 1 < path.size(); ++k)
      if (is_on_curve(path[k], c)) evenly_[path[k]] = features_.on_curve(c, shares[k]).point;
  }
}

bool FittingTargets::is_on_curve(std::uint32_t vertex, std::uint32_t curve) const {
  return carriers_.of_vertex[vertex] == HexCarrier{Kind::kCurve, curve};
}

/// `shares`: of the path's vertices, ascending.
void FittingTargets::set_windows(std::uint32_t curve, const std::vector<double>& shares) {
  const std::vector<std::uint32_t>& path = carriers_.path_of_curve[curve];
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    if (!is_on_curve(path[k], curve)) continue;
    const double after = shares[k + 1] - shares[k];
    const double before =
        k > 0 ? shares[k] - shares[k - 1] : shares[path.size() - 1] - shares[path.size() - 2];
    const double slide = kSlide * std::min(before, after);
    windows_[path[k]] = {shares[k] - slide, shares[k] + slide};
  }
}

/// The arc length of a vertex on a curve, after that of the vertex before; of one off it within its window.
double FittingTargets::share_of(std::uint32_t vertex, std::uint32_t curve, const Vector3& place, double after,
                                double end) const {
  constexpr double kOnCurve = 1e-9;  // sizes
  const double share = features_.nearest_on_curve(curve, place, after, end);
  if (norm(features_.on_curve(curve, share).point - place) < kOnCurve * size_) return share;
  const auto& [low, high] = windows_[vertex];
  return features_.nearest_on_curve(curve, place, low, high);
}

void FittingTargets::slide_from(const HexMesh& mesh) {
  for (std::uint32_t c = 0; c < carriers_.path_of_curve.size(); ++c) {
    const std::vector<std::uint32_t>& path = carriers_.path_of_curve[c];
    if (path.size() < 2) continue;
    const bool is_free = is_on_curve(path[0], c);  // of a closed curve, which begins anywhere
    const double length = features_.length(c);
    const double low = is_free ? windows_[path[0]].first - 0.5 * length : 0;
    std::vector<double> shares(path.size(), 0);
    if (is_free) shares[0] = share_of(path[0], c, mesh.vertices[path[0]], low, low + length);
    shares.back() = shares[0] + length;
    for (std::size_t k = 1; k + 1 < path.size(); ++k)
      if (is_on_curve(path[k], c))
        shares[k] = share_of(path[k], c, mesh.vertices[path[k]], shares[k - 1], shares.back());
    if (std::ranges::is_sorted(shares, std::ranges::less_equal())) set_windows(c, shares);
  }
}

void FittingTargets::spread_faces(const HexMesh& mesh) {
  constexpr int kSweeps = 40;
  // A full step would swap the two colours of a checkerboard.
  constexpr double kStep = 0.7;
  const std::vector<Vector3> normals = normals_of(mesh);
  std::vector<std::uint32_t> on_faces;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v)
    if (carriers_.of_vertex[v].kind == Kind::kFace) on_faces.push_back(v);
  const auto place_all = [&](const auto& wanted) {
    std::vector<Vector3> places(on_faces.size());
    parallel_for(on_faces.size(), [&](std::size_t k) {
      places[k] = nearest(on_faces[k], wanted(on_faces[k]), normals[on_faces[k]]).point;
    });
    for (std::size_t k = 0; k < on_faces.size(); ++k) evenly_[on_faces[k]] = places[k];
  };
  place_all([&](std::uint32_t v) { return mesh.vertices[v]; });
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    place_all([&](std::uint32_t v) {
      Vector3 sum{0, 0, 0};
      for (const std::uint32_t w : neighbours_[v]) sum += evenly_[w] - mesh.vertices[w];
      const double share = kStep / static_cast<double>(neighbours_[v].size());
      return (1 - kStep) * evenly_[v] + kStep * mesh.vertices[v] + share * sum;
    });
}

}  // namespace crossgrain
