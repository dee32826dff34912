// SPDX-License-Identifier: Apache-2.0
// The shapes of a drawing, prepared for casting rays at them.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "picture/drawing.hpp"

struct RTCDeviceTy;

namespace crossgrain {

/// The space of shapes in single precision: moved and scaled so that all are within about 1 of the origin.
struct RaySpace {
  Vector3 centre{};
  double size = 1;  ///< number of model units per unit

  Vector3 from_model(const Vector3& point) const { return (1 / size) * (point - centre); }
  Vector3 to_model(const Vector3& point) const { return centre + size * point; }
};

struct Ray {
  Vector3 origin, direction;  ///< in ray space; the direction is a unit vector
  double nearest = 0;         ///< start of the ray
  double farthest = 1e30;
};

/// A point at which a ray meets a shape.
struct ShapeHit {
  float distance;
  std::uint32_t shape;          ///< index of the shape, in the order of adding
  std::uint32_t primitive;      ///< index within the shape: triangle, rod or ball
  float u, v;                   ///< barycentric coordinates of a triangle's second and third corner
  std::array<float, 3> normal;  ///< not of unit length
};

/// Embree's device, shared by the scenes of a picture.
class RayDevice {
 public:
  RayDevice();

 private:
  friend class RayScene;
  std::unique_ptr<RTCDeviceTy, void (*)(RTCDeviceTy*)> device_;
};

/// Shapes of one kind in ray space. Embree casts the rays, with the instruction set that every x86 processor
/// has and a tree built by one thread, so that every machine finds the same hits.
class RayScene {
 public:
  /// The device must outlive the scene.
  RayScene(const RayDevice& device, const RaySpace& space);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// Add one shape each, numbered in the order of adding, even without content.
  void add_triangles(const std::vector<Vector3>& vertices,
                     const std::vector<std::array<std::uint32_t, 3>>& triangles);
  void add_rods(const std::vector<Rod>& rods);
  void add_balls(const std::vector<Ball>& balls);
  void add_facets(const std::vector<Facet>& facets);

  /// Prepares the scene. Call once, after the last shape; then the queries below are safe from any number of
  /// threads.
  void commit();

  /// Returns whether the ray meets anything, and sets `hit` to the nearest.
  bool first_hit(const Ray& ray, ShapeHit& hit) const;

  /// Sets `hits` to all hits by distance; an edge shared by two triangles facing the same side counts once.
  void all_hits(const Ray& ray, std::vector<ShapeHit>& hits) const;

 private:
  struct Embree;
  RaySpace space_;
  std::unique_ptr<Embree> embree_;
};

}  // namespace crossgrain
