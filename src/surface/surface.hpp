// SPDX-License-Identifier: Apache-2.0
// A triangle mesh prepared for the grid: validated, without triangles of zero area, with normals and areas.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// Coordinates of a surface are smaller, so that squares, cubes and sums of volumes stay far below the
/// largest double (1.8e308).
inline constexpr double kSurfaceReach = 1e100;

/// Returns the corners of a triangle with these indices.
inline std::array<Vector3, 3> corners_of(const std::array<std::uint32_t, 3>& triangle,
                                         const std::vector<Vector3>& vertices) {
  return {vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]]};
}

/// Triangles of positive area, with unit normals. Immutable after `prepare_surface`, so safe to read from any
/// number of threads.
struct Surface {
  TriangleMesh mesh;                     ///< the triangles of positive area, in the given order
  std::vector<Vector3> normals;          ///< per triangle, by the right-hand rule over its corners
  std::vector<double> areas;             ///< per triangle, in squared model units, > 0
  Box box;                               ///< of the corners of `mesh.triangles`, without unused vertices
  std::size_t degenerate_triangles = 0;  ///< number of triangles removed because they have no area

  std::size_t size() const { return mesh.triangles.size(); }

  std::array<Vector3, 3> corners(std::size_t triangle) const {
    return corners_of(mesh.triangles[triangle], mesh.vertices);
  }

  /// Returns the unit normal of the true surface at about the point of the triangle nearest to `point`:
  /// blended from TriangleMesh::corner_normals if the mesh has them, otherwise the triangle's own.
  Vector3 normal_at(std::size_t triangle, const Vector3& point) const {
    return mesh.corner_normals.empty() ? normals[triangle] : blended_normal(triangle, point);
  }

 private:
  Vector3 blended_normal(std::size_t triangle, const Vector3& point) const;
};

/// Returns a Message::place such as "vertex 7 (counted from 0)".
std::string counted_from_0(const char* what, std::size_t index);

/// Throws Error(kInput) for a vertex index that is not below `vertices`.
[[noreturn]] void fail_index(const std::string& place, std::uint32_t vertex, std::size_t vertices);

/// Throws Error(kInput) unless every coordinate is finite and below kSurfaceReach. The message names the
/// vertex, counted from 0.
void check_vertices(const std::vector<Vector3>& vertices);

/// A mesh with finite coordinates (as `check_vertices` demands), indices in range, and per-triangle arrays of
/// the right length. Functions on triangles take a CheckedMesh, so that a mesh is validated once, where it
/// comes in.
class CheckedMesh {
 public:
  /// Throws Error(kInput) as `check_vertices` does; otherwise the message names the triangle or inner face,
  /// counted from 0.
  CheckedMesh(TriangleMesh mesh);

  /// Wraps a mesh made of vertices and triangles of checked meshes; only an assertion validates it again.
  static CheckedMesh derived(TriangleMesh mesh);

  const TriangleMesh& operator*() const& { return mesh_; }
  TriangleMesh operator*() && { return std::move(mesh_); }
  const TriangleMesh* operator->() const { return &mesh_; }

 private:
  CheckedMesh() = default;
  TriangleMesh mesh_;
};

/// Normal and area of a triangle. Both are 0 if the corners are collinear up to rounding, since the direction
/// of the normal would be noise.
struct TriangleShape {
  Vector3 normal;
  double area;
};
TriangleShape shape_of(const std::array<Vector3, 3>& corners);

/// Returns the bounding box of all triangles with an area; empty if there are none. Indices must be in range.
Box box_of_solid_triangles(const TriangleMesh& mesh);

/// Returns the volume that a closed surface encloses, in cubed model units, for either orientation.
double enclosed_volume(const Surface& surface);

/// Returns the mesh as a Surface. Throws Error(kInput) if no triangle has a positive area.
Surface prepare_surface(CheckedMesh mesh);

}  // namespace crossgrain
