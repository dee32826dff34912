// SPDX-License-Identifier: Apache-2.0
// The colour at a point of a picture: the layers along one ray, composited.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "picture/camera.hpp"
#include "picture/drawing.hpp"
#include "picture/ray_scene.hpp"
#include "picture/renderer.hpp"
#include "picture/shading.hpp"

namespace crossgrain {

/// Casts rays at a drawing, which it refers to. Safe to use from any number of threads, each with its own
/// Scratch.
class RayTracing {
 public:
  /// Lists that a thread reuses from ray to ray.
  struct Scratch {
    std::vector<ShapeHit> cut_hits, whole_hits;
  };

  struct Seen {
    Pixel pixel;

    /// Hash of the kinds of layers: an edge runs between two rays with different ones.
    std::uint32_t signature = 0;
  };

  RayTracing(const Drawing& drawing, const Camera& camera, const RenderOptions& options);

  /// The colour at a point of the picture, in pixels.
  Seen at(double x, double y, Scratch& scratch) const;

 private:
  /// The layers along one ray.
  class Layers;

  /// The meshes, rods and balls that a section cuts, or those that it leaves whole.
  struct Shapes {
    Shapes(const RayDevice& device, const RaySpace& space) : meshes(device, space), rods(device, space) {}
    void add(const DrawnMesh& mesh);
    void add(const DrawnRods& rods);

    RayScene meshes, rods;
    std::vector<const DrawnMesh*> drawn_meshes;  ///< one shape each
    std::vector<const DrawnRods*> drawn_rods;    ///< kShapesOfRods shapes each: rods, balls, facets
  };

  struct RodHit {
    ShapeHit hit;
    const DrawnRods* rods;
  };

  static constexpr std::uint32_t kShapesOfRods = 3;

  Ray ray_at(double x, double y) const;
  void add_ghost(const Ray& ray, double distance, Layers& layers) const;
  std::optional<RodHit> nearest_rod(const Ray& cut, const Ray& whole) const;
  bool is_enclosed(const std::vector<ShapeHit>& hits, const Ray& ray) const;
  Pixel mesh_pixel(const DrawnMesh& mesh, const ShapeHit& hit, const Ray& ray) const;
  Colour rod_colour(const RodHit& rod) const;
  Vector3 place_of(const ShapeHit& hit, const Ray& ray) const;
  SeenNormal seen_normal(const std::array<float, 3>& normal) const;
  float depth_share(float distance) const;

  const Drawing& drawing_;
  const Camera& camera_;
  RenderOptions options_;
  RaySpace space_;
  RayDevice device_;
  Shapes cut_, whole_;
  RayScene ghosts_;
  double first_depth_, last_depth_;  ///< distances along a ray of the model's nearest and farthest point
};

}  // namespace crossgrain
