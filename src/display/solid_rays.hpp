// SPDX-License-Identifier: Apache-2.0
// Distances to the drawn surface along rays.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "base/vector3.hpp"
#include "surface/searchable_surface.hpp"

namespace crossgrain {

/// The surface of a solid, which may be open. Queries are safe from any number of threads.
class SolidRays {
 public:
  explicit SolidRays(std::shared_ptr<const SearchableSurface> surface) : surface_(std::move(surface)) {}

  struct Hit {
    double distance;  ///< model units
    Vector3 place;
    Vector3 normal;  ///< outward, unit
    bool is_exit;    ///< whether the ray leaves the solid
  };

  /// The first place where a ray from `origin` along a unit vector meets the surface, up to a distance.
  std::optional<Hit> first_hit(const Vector3& origin, const Vector3& direction, double most) const;

  /// The place of the surface nearest to a point, and the distance.
  Hit nearest(const Vector3& point) const;

  /// Length of the chord of the solid through a point along a unit vector, if its ends are on faces that
  /// turn away from one another; otherwise, outside the solid and where the surface is open, kNoWall.
  double chord(const Vector3& point, const Vector3& direction) const;

 private:
  std::shared_ptr<const SearchableSurface> surface_;
};

}  // namespace crossgrain
