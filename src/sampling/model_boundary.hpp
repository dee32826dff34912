// SPDX-License-Identifier: Apache-2.0
// The surface of a model, to be asked of whether points are inside and where straight ways meet it.
#pragma once

#include <optional>

#include "surface/bvh.hpp"
#include "surface/mending.hpp"
#include "surface/winding_number.hpp"

namespace crossgrain {

/// The outside of all solids together: faces between two are no boundary. Refers to itself, so that it is
/// neither copied nor moved. Queries are safe from any number of threads.
class ModelBoundary {
 public:
  /// Throws Error(kInput) for a mesh that makes no sense or encloses nothing.
  explicit ModelBoundary(const TriangleMesh& mesh);
  ModelBoundary(const ModelBoundary&) = delete;
  ModelBoundary& operator=(const ModelBoundary&) = delete;

  const Box& box() const { return mended_.surface.box; }
  bool inside(const Vector3& point) const { return winding_.inside(point); }

  /// The share of the straight way from one point to another after which it first meets the surface; 1 where
  /// it does not. No way slips through between two triangles (TriangleBvh::first_hit).
  double share_to(const Vector3& from, const Vector3& to) const;

 private:
  MendedSurface mended_;
  TriangleBvh bvh_;
  WindingNumber winding_;
};

}  // namespace crossgrain
