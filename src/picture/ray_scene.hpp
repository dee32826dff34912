// SPDX-License-Identifier: Apache-2.0
// The shapes of a drawing, ready for rays to be cast at them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "picture/drawing.hpp"

struct RTCDeviceTy;

namespace crossgrain {

/// Where shapes are in single precision: moved and scaled so that all are within about 1 of the origin.
struct RaySpace {
  Vector3 centre{};
  double size = 1;  ///< model units that 1 stands for

  Vector3 from_model(const Vector3& point) const { return (1 / size) * (point - centre); }
  Vector3 to_model(const Vector3& point) const { return centre + size * point; }
};

struct Ray {
  Vector3 origin, direction;  ///< in ray space; unit
  double nearest = 0;         ///< where it begins
  double farthest = 1e30;
};

/// Where a ray meets a shape.
struct ShapeHit {
  float distance;
  std::uint32_t shape;          ///< index of what was added to the scene
  std::uint32_t primitive;      ///< of the shape: triangle, rod or ball
  float u, v;                   ///< barycentric coordinates of a triangle's second and third corner
  std::array<float, 3> normal;  ///< not of unit length
};

/// What scenes of one picture share: Embree's device.
class RayDevice {
 public:
  RayDevice();

 private:
  friend class RayScene;
  std::unique_ptr<RTCDeviceTy, void (*)(RTCDeviceTy*)> device_;
};

/// Shapes of one kind in ray space. Embree casts the rays, on the instruction set that every x86 processor
/// has and with a tree built by one thread: so that every machine meets the same shapes at the same places.
class RayScene {
 public:
  /// The device must outlive the scene.
  RayScene(const RayDevice& device, const RaySpace& space);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// Each counts as one shape, in the order in which they are added; without content too.
  void add_triangles(const std::vector<Vector3>& vertices,
                     const std::vector<std::array<std::uint32_t, 3>>& triangles);
  void add_rods(const std::vector<Rod>& rods);
  void add_balls(const std::vector<Ball>& balls);

  /// To be called once, after the last shape. What follows may be called from any number of threads then.
  void commit();

  /// Whether anything is met, and then the nearest.
  bool first_hit(const Ray& ray, ShapeHit& hit) const;

  /// All that is met, by distance; an edge that two triangles of the same side share counts once.
  void all_hits(const Ray& ray, std::vector<ShapeHit>& hits) const;

 private:
  struct Embree;
  RaySpace space_;
  std::unique_ptr<Embree> embree_;
};

}  // namespace crossgrain
