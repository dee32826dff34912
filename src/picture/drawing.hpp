// SPDX-License-Identifier: Apache-2.0
// What is to be drawn, as shapes with colours that know nothing of fields.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "base/vector3.hpp"
#include "picture/colour.hpp"

namespace crossgrain {

/// A point of a mesh that a ray meets, model units.
struct MeshPoint {
  Vector3 place;
  Vector3 normal;  ///< of the triangle, by the right-hand rule, unit
  std::uint32_t triangle;
};

/// Triangles of one look. More opaque where they are seen at a grazing angle, as glass is: so the outline of
/// a translucent part shows, and what is behind its faces too.
struct DrawnMesh {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// Unit normals at the corners of each triangle, for shading; empty for flat triangles.
  std::vector<std::array<std::array<float, 3>, 3>> corner_normals = {};

  Colour colour = {0.7f, 0.7f, 0.7f};

  /// Instead of `colour`, where it is set. Called from several threads at once.
  std::function<Colour(const MeshPoint&)> colour_at = {};

  float opacity = 1;          ///< seen along its normal
  float grazing_opacity = 1;  ///< seen from the side

  /// Sides that look away are not there.
  bool has_front_only = false;

  /// A section leaves it whole.
  bool is_whole = false;

  /// Makes of the mesh a boundary of the solid that a section shows (Drawing::section): closed, looking out.
  bool bounds_solid = false;
};

/// A rod with round ends between two points; polylines are as many.
struct Rod {
  Vector3 from, to;
  double radius;  ///< model units
  Colour colour;
};

struct Ball {
  Vector3 centre;
  double radius;  ///< model units
  Colour colour;
};

enum class RodLook {
  kSolid,  ///< round, with a dark rim, and seen through everything: never dimmed by much
  kInk     ///< of its own colour all over: a line
};

/// Rods and balls of one look.
struct DrawnRods {
  RodLook look = RodLook::kSolid;
  std::vector<Rod> rods;
  std::vector<Ball> balls;

  /// A section leaves them whole.
  bool is_whole = false;
};

/// A plane across the picture, which takes away what is in front of it, and what it cuts open.
struct Section {
  Vector3 normal;  ///< unit; towards what is taken away, on the side of the viewer
  double offset;   ///< normal . x = offset on the plane

  /// The colour at a point of the plane, and whether the meshes that bound the solid enclose it; none where
  /// there is nothing to show. Called from several threads at once.
  std::function<std::optional<Colour>(const Vector3& point, bool is_enclosed)> colour_at;

  /// Rods of which what the section takes away is still drawn, of this opacity.
  std::vector<Rod> ghosts = {};
  float ghost_opacity = 0.25f;
};

struct Drawing {
  std::vector<DrawnMesh> meshes;
  std::vector<DrawnRods> rods;
  std::optional<Section> section;
};

}  // namespace crossgrain
