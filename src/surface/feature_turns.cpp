// SPDX-License-Identifier: Apache-2.0
#include "surface/feature_turns.hpp"

#include <algorithm>
#include <cmath>

#include "base/degree.hpp"
#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Number of triangles of a face that tell how it bends beside an edge, about three rows; of these at least
/// so many off the plane of the first, if there are some among the most that are asked.
constexpr std::size_t kEnoughNear = 14, kEnoughBent = 6, kMostNear = 48;

/// Facets of smaller angles are one.
constexpr double kBentDeg = 1;

/// Least spread of their distances from the edge, over the mean distance.
constexpr double kLeastSpread = 0.2;

double angle_between(const Vector3& a, const Vector3& b) {
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

/// Returns triangles of a face, the nearest by steps over edges first.
std::vector<std::uint32_t> triangles_near(std::uint32_t start, const FeatureFans& fans,
                                          const Surface& surface) {
  const double flat = std::cos(kBentDeg * kDegree);
  std::vector<std::uint32_t> near{start};
  std::size_t bent = 0;
  for (std::size_t passed = 0; passed < near.size(); ++passed) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const bool is_enough = near.size() >= kEnoughNear && bent >= kEnoughBent;
      if (is_enough || near.size() >= kMostNear) return near;
      const std::uint32_t behind = fans.opposite(3 * near[passed] + k);
      if (behind == FeatureFans::kNone || std::ranges::find(near, behind / 3) != near.end()) continue;
      near.push_back(behind / 3);
      bent += dot(surface.normals[behind / 3], surface.normals[start]) < flat;
    }
  }
  return near;
}

/// An edge with the angles of normals about it.
struct TurnAxis {
  Vector3 middle, along, zero;

  double angle_of(const Vector3& normal) const {
    return std::atan2(dot(cross(zero, normal), along), dot(zero, normal));
  }
};

/// Returns the angle of the normal that a face has at the edge.
double angle_at_edge(const TurnAxis& axis, const EdgeUse& use, const FeatureFans& fans,
                     const Surface& surface) {
  const double own = axis.angle_of(surface.normals[use.triangle]);
  const Vector3 inwards = cross(surface.normals[use.triangle], use.forward ? axis.along : -axis.along);
  struct Sample {
    double distance, angle, weight;
  };
  std::vector<Sample> samples;
  double weights = 0, mean_distance = 0, mean_angle = 0;
  for (const std::uint32_t t : triangles_near(use.triangle, fans, surface)) {
    const auto [a, b, c] = surface.corners(t);
    const double distance = dot((1.0 / 3) * (a + b + c) - axis.middle, inwards);
    samples.push_back({distance, axis.angle_of(surface.normals[t]), surface.areas[t]});
    weights += samples.back().weight;
    mean_distance += samples.back().weight * distance;
    mean_angle += samples.back().weight * samples.back().angle;
  }
  mean_distance /= weights;
  mean_angle /= weights;
  double spread = 0, common = 0;
  for (const auto& [distance, angle, weight] : samples) {
    spread += weight * (distance - mean_distance) * (distance - mean_distance);
    common += weight * (distance - mean_distance) * (angle - mean_angle);
  }
  if (!(spread > weights * kLeastSpread * kLeastSpread * mean_distance * mean_distance)) return own;
  const double at_edge = mean_angle - common / spread * mean_distance;
  // A face that bends elsewhere tells nothing about its border.
  const auto [least, most] = std::ranges::minmax(samples, {}, &Sample::angle);
  return std::clamp(at_edge, own - (most.angle - least.angle) / 2, own + (most.angle - least.angle) / 2);
}

double exact_turn_deg(const FeatureEdge& edge, const TriangleMesh& mesh) {
  const auto normal_at = [&](const EdgeUse& use, std::uint32_t vertex) {
    const auto& triangle = mesh.triangles[use.triangle];
    const auto k = static_cast<std::size_t>(std::ranges::find(triangle, vertex) - triangle.begin());
    return mesh.corner_normals[use.triangle][k];
  };
  double sum = 0;
  for (const std::uint32_t v : edge.vertices)
    sum += angle_between(normal_at(edge.uses[0], v), normal_at(edge.uses[1], v));
  return sum / 2 / kDegree;
}

}  // namespace

double turn_deg_across(const FeatureEdge& edge, const FeatureFans& fans, const Surface& surface) {
  const TriangleMesh& mesh = surface.mesh;
  if (!mesh.corner_normals.empty()) return exact_turn_deg(edge, mesh);
  const Vector3 &a = surface.normals[edge.uses[0].triangle], &b = surface.normals[edge.uses[1].triangle];
  const Vector3 zero = normalised(a + b);
  // Triangles that lie on each other have no middle.
  if (zero == Vector3{0, 0, 0}) return 180;
  const Vector3 &low = mesh.vertices[edge.vertices[0]], &high = mesh.vertices[edge.vertices[1]];
  const TurnAxis axis{0.5 * (low + high), normalised(high - low), zero};
  return std::abs(angle_at_edge(axis, edge.uses[0], fans, surface) -
                  angle_at_edge(axis, edge.uses[1], fans, surface)) /
         kDegree;
}

}  // namespace crossgrain
