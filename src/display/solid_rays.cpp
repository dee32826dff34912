// SPDX-License-Identifier: Apache-2.0
#include "display/solid_rays.hpp"

#include <cmath>
#include <limits>

namespace crossgrain {
namespace {

/// Largest cosine between the normals of the two faces of a wall: the three faces of a triangular rod, 120
/// degrees apart, make walls, those of a right-angled edge do not.
constexpr double kOpposite = -0.4;

}  // namespace

std::optional<SolidRays::Hit> SolidRays::first_hit(const Vector3& origin, const Vector3& direction,
                                                   double most) const {
  const std::optional<RayHit> hit = surface_->bvh().first_hit(origin, direction, 0, most);
  if (!hit) return std::nullopt;
  const Vector3& normal = surface_->surface().normals[hit->triangle];
  return Hit{hit->t, origin + hit->t * direction, normal, dot(normal, direction) > 0};
}

SolidRays::Hit SolidRays::nearest(const Vector3& point) const {
  const NearestPoint nearest = surface_->bvh().nearest(point);
  const Vector3& normal = surface_->surface().normals[nearest.triangle];
  return {std::sqrt(nearest.squared_distance), nearest.point, normal, dot(normal, nearest.point - point) > 0};
}

double SolidRays::chord(const Vector3& point, const Vector3& direction) const {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  const auto ahead = first_hit(point, direction, kAny), behind = first_hit(point, -direction, kAny);
  if (!ahead || !behind || !ahead->is_exit || !behind->is_exit) return kAny;
  if (dot(ahead->normal, behind->normal) > kOpposite) return kAny;
  return ahead->distance + behind->distance;
}

}  // namespace crossgrain
