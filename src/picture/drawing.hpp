// SPDX-License-Identifier: Apache-2.0
// The content of a picture as coloured shapes, independent of fields.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/vector3.hpp"
#include "picture/colour.hpp"

namespace crossgrain {

/// A point at which a ray meets a mesh, model units.
struct MeshPoint {
  Vector3 place;
  Vector3 normal;  ///< unit normal of the triangle, by the right-hand rule
  std::uint32_t triangle;
  float u, v;  ///< barycentric coordinates of the triangle's second and third corner
};

/// Triangles of one look. They are more opaque at a grazing angle, as glass is, so that a translucent part
/// shows both its outline and what is behind its faces.
struct DrawnMesh {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// Unit normals at the corners of each triangle, for shading; empty for flat triangles.
  std::vector<std::array<std::array<float, 3>, 3>> corner_normals = {};

  Colour colour = {0.7f, 0.7f, 0.7f};

  /// Replaces `colour`, if set. Called from several threads at once.
  std::function<Colour(const MeshPoint&)> colour_at = {};

  float opacity = 1;          ///< opacity seen along the normal
  float grazing_opacity = 1;  ///< opacity seen from the side

  /// How much darker than its colour what faces away from the light is, as a share of what it would be: less
  /// where colours are read off.
  float shading = 1;

  /// Whether sides that face away from the viewer are omitted.
  bool has_front_only = false;

  /// Whether a section leaves it uncut.
  bool is_whole = false;

  /// Whether the mesh bounds the solid that a section shows (Drawing::section): closed and oriented outward.
  bool bounds_solid = false;
};

/// A rod with round ends between two points. Polylines are drawn as several rods.
struct Rod {
  Vector3 from, to;
  double radius;  ///< model units
  Colour colour;
  double end_radius = 0;  ///< at `to`; 0 if it is the same
};

struct Ball {
  Vector3 centre;
  double radius;  ///< model units
  Colour colour;
};

/// A triangle of a small opaque solid, counter-clockwise seen from outside.
struct Facet {
  std::array<Vector3, 3> corners;  ///< model units
  Colour colour;
};

enum class RodLook {
  kSolid,  ///< round, with a dark rim, and visible through everything: never dimmed by much
  kInk     ///< a line in one colour
};

/// Rods, balls and facets of one look.
struct DrawnRods {
  RodLook look = RodLook::kSolid;
  std::vector<Rod> rods;
  std::vector<Ball> balls;

  /// Whether a section leaves them uncut.
  bool is_whole = false;

  std::vector<Facet> facets = {};
};

/// A plane across the picture: removes everything in front of it and shows what it cuts.
struct Section {
  Vector3 normal;  ///< unit; towards the removed part, on the side of the viewer
  double offset;   ///< the plane is normal . x = offset

  /// Colour at a point of the plane; none where nothing is shown. `is_enclosed` tells whether the meshes that
  /// bound the solid enclose the point, which costs as much as a ray. Called from several threads at once.
  std::function<std::optional<Colour>(const Vector3& point, const std::function<bool()>& is_enclosed)>
      colour_at;

  /// Rods whose removed part is still drawn, with `ghost_opacity`.
  std::vector<Rod> ghosts = {};
  float ghost_opacity = 0.25f;
};

/// A short text over all else, centred at a point.
struct Label {
  Vector3 place;  ///< model units
  std::string text;
};

struct Drawing {
  std::vector<DrawnMesh> meshes;
  std::vector<DrawnRods> rods;
  std::optional<Section> section;
  std::vector<Label> labels = {};
};

}  // namespace crossgrain
