// SPDX-License-Identifier: Apache-2.0
#include "surface/feature_fans.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/degree.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Least tilt of triangles against their mean at a tip: that of a cone with 140 degrees at its tip. A drill
/// leaves 118 degrees.
constexpr double kLeastTiltDeg = 20;

/// Least slope of an edge at a tip over the mean tilt of triangles. Along a ridge edges have none.
constexpr double kLeastShare = 0.5;

/// Tilt of what lies around the triangles at a tip over theirs: 1 of a cone, 2 of a sphere.
constexpr double kLeastAround = 0.7, kMostAround = 1.4;

std::uint32_t half_edge_of(const EdgeUse& use, const std::array<std::uint32_t, 3>& triangle) {
  const std::uint32_t from = use.forward ? use.low() : use.high();
  const auto k = static_cast<std::uint32_t>(std::ranges::find(triangle, from) - triangle.begin());
  return 3 * use.triangle + k;
}

}  // namespace

FeatureFans::FeatureFans(const FeatureSurface& surface, std::span<const EdgeUse> all_uses,
                         const std::vector<FeatureEdge>& edges)
    : opposite_(3 * surface.surface.size(), kNone), edge_of_(3 * surface.surface.size(), kNone) {
  const auto& triangles = surface.surface.mesh.triangles;
  std::uint32_t passed = 0;
  for_each_edge(all_uses, [&](std::span<const EdgeUse> uses) {
    const bool is_feature = passed < edges.size() && edges[passed].uses.data() == uses.data();
    if (is_feature) {
      for (const EdgeUse& use : uses) edge_of_[half_edge_of(use, triangles[use.triangle])] = passed;
      ++passed;
      return;
    }
    const std::uint32_t a = half_edge_of(uses[0], triangles[uses[0].triangle]);
    const std::uint32_t b = half_edge_of(uses[1], triangles[uses[1].triangle]);
    opposite_[a] = b;
    opposite_[b] = a;
  });
  find_fans(surface);
}

void FeatureFans::find_fans(const FeatureSurface& surface) {
  std::vector<std::uint8_t> is_passed(opposite_.size(), 0);
  Checkpoint checkpoint;
  const auto walk = [&](std::uint32_t start) {
    const std::uint32_t vertex = surface.surface.mesh.triangles[start / 3][start % 3];
    Fan fan{vertex, start, kNone, false};
    for (std::uint32_t h = start;; h = opposite_[fan.last]) {
      checkpoint.pass();
      is_passed[h] = 1;
      fan.last = before(h);
      fan.is_closed = opposite_[fan.last] == start;
      if (fan.is_closed || opposite_[fan.last] == kNone) break;
    }
    fans_.push_back(fan);
  };
  for (std::uint32_t h = 0; h < opposite_.size(); ++h)
    if (opposite_[h] == kNone) walk(h);
  for (std::uint32_t h = 0; h < opposite_.size(); ++h)
    if (!is_passed[h]) walk(h);
  std::sort(fans_.begin(), fans_.end(), [](const Fan& a, const Fan& b) {
    return std::tuple(a.vertex, a.is_closed, a.first) < std::tuple(b.vertex, b.is_closed, b.first);
  });
}

double angle_rad_of(const FeatureFans& fans, const FeatureFans::Fan& fan, const Surface& surface) {
  double sum = 0;
  fans.for_each_triangle(fan, [&](std::uint32_t h) {
    const std::array<Vector3, 3> corners = surface.corners(h / 3);
    const Vector3& at = corners[h % 3];
    const Vector3 a = corners[FeatureFans::next(h) % 3] - at, b = corners[FeatureFans::before(h) % 3] - at;
    sum += std::atan2(norm(cross(a, b)), dot(a, b));
  });
  return sum;
}

bool is_tip(const FeatureFans& fans, const FeatureFans::Fan& fan, const Surface& surface) {
  if (!fan.is_closed) return false;
  const TriangleMesh& mesh = surface.mesh;
  Vector3 sum{0, 0, 0};
  fans.for_each_triangle(fan, [&](std::uint32_t h) { sum += surface.normals[h / 3]; });
  const Vector3 mean = normalised(sum), &tip = mesh.vertices[fan.vertex];
  double tilt = 0, around = 0, least = 1, most = -1;
  int count = 0, count_around = 0;
  fans.for_each_triangle(fan, [&](std::uint32_t h) {
    const std::uint32_t far = FeatureFans::next(h), triangle = h / 3;
    const Vector3 &a = mesh.vertices[mesh.triangles[triangle][far % 3]],
                  &b = mesh.vertices[mesh.triangles[triangle][FeatureFans::before(h) % 3]];
    const auto tilt_of = [&](const Vector3& normal, const Vector3& towards) {
      const Vector3 way = towards - tip;
      return dot(normal, normalised(way - dot(way, mean) * mean));
    };
    const Vector3 middle = 0.5 * (a + b);
    tilt += tilt_of(surface.normals[triangle], middle);
    ++count;
    const double slope = -dot(normalised(a - tip), mean);
    least = std::min(least, slope);
    most = std::max(most, slope);
    const std::uint32_t behind = fans.opposite(far);
    if (!mesh.corner_normals.empty())
      around += tilt_of(mesh.corner_normals[triangle][far % 3], a);
    else if (behind != FeatureFans::kNone)
      around += tilt_of(surface.normals[behind / 3], middle);
    else
      return;
    ++count_around;
  });
  tilt /= count;
  if (!(std::abs(tilt) >= std::sin(kLeastTiltDeg * kDegree))) return false;
  if (!((tilt > 0 ? least : -most) >= kLeastShare * std::abs(tilt))) return false;
  if (count_around == 0) return true;
  const double share = around / count_around / tilt;
  return share >= kLeastAround && share <= kMostAround;
}

}  // namespace crossgrain
