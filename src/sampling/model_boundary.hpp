// SPDX-License-Identifier: Apache-2.0
// The surface of a model: tests whether points are inside, and finds where segments meet it.
#pragma once

#include <optional>

#include "surface/bvh.hpp"
#include "surface/mending.hpp"
#include "surface/winding_number.hpp"

namespace crossgrain {

/// The outer boundary of all solids together: faces between two solids are not part of it. Refers to itself,
/// so it can be neither copied nor moved. Queries are safe from any number of threads.
class ModelBoundary {
 public:
  /// Prepares a surface. Throws Error(kInput) for a mesh that is invalid or encloses nothing.
  explicit ModelBoundary(const TriangleMesh& mesh);
  ModelBoundary(const ModelBoundary&) = delete;
  ModelBoundary& operator=(const ModelBoundary&) = delete;

  const Surface& surface() const { return mended_.surface; }
  const Box& box() const { return mended_.surface.box; }
  bool inside(const Vector3& point) const { return winding_.inside(point); }

  /// Share of the segment from one point to another at which it first meets the surface; 1 if it does not. No
  /// segment slips through between two triangles (TriangleBvh::first_hit).
  double share_to(const Vector3& from, const Vector3& to) const;

 private:
  MendedSurface mended_;
  TriangleBvh bvh_;
  WindingNumber winding_;
};

}  // namespace crossgrain
