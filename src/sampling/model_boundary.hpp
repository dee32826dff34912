// SPDX-License-Identifier: Apache-2.0
// The surface of a model: tests whether points are inside, and finds where segments meet it.
#pragma once

#include <memory>
#include <utility>

#include "surface/searchable_surface.hpp"

namespace crossgrain {

/// The outer boundary of all solids together: faces between two solids are not part of it. Cheap to copy.
/// Queries are safe from any number of threads.
class ModelBoundary {
 public:
  /// Prepares a surface. Throws Error(kInput) for a mesh that is invalid or encloses nothing.
  explicit ModelBoundary(const TriangleMesh& mesh);

  explicit ModelBoundary(std::shared_ptr<const SearchableSurface> surface) : surface_(std::move(surface)) {}

  const Surface& surface() const { return surface_->surface(); }
  const Box& box() const { return surface().box; }
  bool inside(const Vector3& point) const { return surface_->winding().inside(point); }

  /// Share of the segment from one point to another at which it first meets the surface; 1 if it does not. No
  /// segment slips through between two triangles (TriangleBvh::first_hit).
  double share_to(const Vector3& from, const Vector3& to) const;

 private:
  std::shared_ptr<const SearchableSurface> surface_;
};

}  // namespace crossgrain
