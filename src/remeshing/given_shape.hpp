// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "remeshing/remeshing_options.hpp"
#include "surface/bvh.hpp"
#include "surface/patched_surface.hpp"

namespace crossgrain {

/// A place on the given surface.
struct PlaceOnShape {
  Vector3 point;
  Vector3 normal;  ///< of the given triangle there; zero on a curve
  double size;     ///< what the curvature there asks for, between smallest and largest size
};

/// The shape that a remeshed surface must keep: nearest places on its patches and curves, and sizes by its
/// curvature. Refers to the surface. Queries are thread-safe.
class GivenShape {
 public:
  GivenShape(const PatchedSurface& given, const Remeshing& options);

  /// `near` must be near the patch: on a flat one the result may lie beyond its border.
  PlaceOnShape on_patch(std::uint32_t patch, const Vector3& near) const;
  PlaceOnShape on_curve(std::uint32_t curve, const Vector3& near) const;

  /// Returns for each vertex the largest size that curvature and short curves allow there and, by the
  /// gradation, around it.
  std::vector<double> sizes_of_vertices() const;

 private:
  struct Patch {
    Surface surface;
    std::unique_ptr<TriangleBvh> tree;
    std::vector<std::uint32_t> triangles;  ///< of the given surface, in the order of `surface`

    /// Whether it lies in the plane through `origin` across `normal`, so that no tree is needed.
    bool is_flat = false;
    Vector3 origin{}, normal{};
  };
  struct Segment {
    Vector3 from, to;
    double size;
  };

  void find_curvature_sizes();
  void make_patches();
  void find_plane(Patch& patch) const;
  void make_curves();
  double clamped(double size) const;

  const PatchedSurface& given_;
  Remeshing options_;
  std::vector<double> triangle_sizes_;
  std::vector<Patch> patches_;
  std::vector<std::vector<Segment>> curves_;
};

}  // namespace crossgrain
