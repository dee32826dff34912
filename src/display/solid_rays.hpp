// SPDX-License-Identifier: Apache-2.0
// Distances to the drawn surface along rays.
#pragma once

#include <optional>

#include "base/vector3.hpp"
#include "field/solved_surface.hpp"
#include "surface/bvh.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// The surface of a solid, which may be open. Refers to itself, so it can be neither copied nor moved.
/// Queries are safe from any number of threads.
class SolidRays {
 public:
  /// Copies the triangles. Throws Error(kInput) if none has an area.
  explicit SolidRays(const SolvedSurface& surface);
  SolidRays(const SolidRays&) = delete;
  SolidRays& operator=(const SolidRays&) = delete;

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

  /// Length of the chord of the solid through a point along a unit vector; kNoWall outside the solid and
  /// where the surface is open.
  double chord(const Vector3& point, const Vector3& direction) const;

 private:
  Surface surface_;
  TriangleBvh bvh_;
};

}  // namespace crossgrain
