// SPDX-License-Identifier: Apache-2.0
#include "surface/surface.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

/// Smallest length of the cross product of two edges that are scaled to at most 1 per component. It is
/// accurate to a few units in the last place, so a shorter one has no direction.
constexpr double kSmallestCross = 8 * std::numeric_limits<double>::epsilon();

double largest_component(const Vector3& a, const Vector3& b) {
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) largest = std::max({largest, std::abs(a[axis]), std::abs(b[axis])});
  return largest;
}

/// Throws unless a member with one entry per triangle is empty or complete.
template <class T>
void check_count(const std::vector<T>& entries, std::size_t triangles, const char* name) {
  if (entries.empty() || entries.size() == triangles) return;
  throw Error(ErrorKind::kInput,
              {"", name,
               "has " + std::to_string(entries.size()) + " entries for " + std::to_string(triangles) +
                   " triangles, where there must be one for each or none"});
}

/// Moves the entry of triangle `from` to `to`, if there are entries.
template <class T>
void move_entry(std::vector<T>& entries, std::size_t from, std::size_t to) {
  if (!entries.empty()) entries[to] = entries[from];
}

template <class T>
void shorten(std::vector<T>& entries, std::size_t size) {
  if (!entries.empty()) entries.resize(size);
}

/// The box of the triangles for which counts(corners) holds.
template <class Counts>
Box box_of_those(const TriangleMesh& mesh, const Counts& counts) {
  constexpr std::size_t kGrain = std::size_t{1} << 16;
  std::vector<Box> boxes((mesh.triangles.size() + kGrain - 1) / kGrain, empty_box());
  parallel_for_chunks(mesh.triangles.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    Box& box = boxes[begin / kGrain];
    for (std::size_t t = begin; t < end; ++t) {
      const std::array<Vector3, 3> corners = corners_of(mesh.triangles[t], mesh.vertices);
      if (!counts(corners)) continue;
      for (const Vector3& corner : corners) include(box, corner);
    }
  });
  Box all = empty_box();
  for (const Box& box : boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      all.low[axis] = std::min(all.low[axis], box.low[axis]);
      all.high[axis] = std::max(all.high[axis], box.high[axis]);
    }
  }
  return all;
}

}  // namespace

std::string counted_from_0(const char* what, std::size_t index) {
  return std::string(what) + " " + std::to_string(index) + " (counted from 0)";
}

void fail_index(const std::string& place, std::uint32_t vertex, std::size_t vertices) {
  throw Error(ErrorKind::kInput, {"", place,
                                  "vertex index " + std::to_string(vertex) + " is out of range, there " +
                                      is_or_are(vertices) + " " + counted(vertices, "vertex", "vertices"),
                                  Remedy::kRemoveElement});
}

void check_vertices(const std::vector<Vector3>& vertices) {
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    for (const double coordinate : vertices[v]) {
      if (std::abs(coordinate) < kSurfaceReach) continue;  // false for NaN
      throw Error(ErrorKind::kInput,
                  {"", counted_from_0("vertex", v),
                   std::string("coordinate ") +
                       (std::isfinite(coordinate) ? "beyond 1e100" : "that is not a finite number"),
                   Remedy::kRemoveElement});
    }
  }
}

namespace {

bool is_finite(const Vector3& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

void check_creases(const std::vector<CreaseCurve>& creases) {
  for (std::size_t k = 0; k < creases.size(); ++k) {
    const auto fail = [&](const char* text) {
      throw Error(ErrorKind::kInput, {"", counted_from_0("crease", k), text});
    };
    const auto& [points, tangents, tag, is_tagged] = creases[k];
    if (points.size() != tangents.size()) fail("needs one tangent for each point");
    if (!std::all_of(points.begin(), points.end(), is_finite) ||
        !std::all_of(tangents.begin(), tangents.end(), is_finite))
      fail("has a coordinate that is not finite");
  }
}

void check_mesh(const TriangleMesh& mesh) {
  check_vertices(mesh.vertices);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t vertex : mesh.triangles[t]) {
      if (vertex < mesh.vertices.size()) continue;
      fail_index(counted_from_0("triangle", t), vertex, mesh.vertices.size());
    }
  }
  for (std::size_t t = 0; t < mesh.inner_faces.size(); ++t) {
    for (const std::uint32_t vertex : mesh.inner_faces[t]) {
      if (vertex < mesh.vertices.size()) continue;
      fail_index(counted_from_0("inner face", t), vertex, mesh.vertices.size());
    }
  }
  check_count(mesh.faces, mesh.triangles.size(), "faces");
  check_count(mesh.solids, mesh.triangles.size(), "solids");
  check_count(mesh.corner_normals, mesh.triangles.size(), "corner_normals");
  for (std::size_t t = 0; t < mesh.corner_normals.size(); ++t) {
    const auto& normals = mesh.corner_normals[t];
    if (!std::all_of(normals.begin(), normals.end(), is_finite))
      throw Error(ErrorKind::kInput,
                  {"", counted_from_0("triangle", t), "has a corner normal that is not finite"});
  }
  check_creases(mesh.creases);
}

}  // namespace

CheckedMesh::CheckedMesh(TriangleMesh mesh) : mesh_(std::move(mesh)) {
  check_mesh(mesh_);
}

CheckedMesh CheckedMesh::derived(TriangleMesh mesh) {
  assert((check_mesh(mesh), true));
  CheckedMesh checked;
  checked.mesh_ = std::move(mesh);
  return checked;
}

TriangleShape shape_of(const std::array<Vector3, 3>& corners) {
  const Vector3 ab = corners[1] - corners[0], ac = corners[2] - corners[0];
  const double scale = largest_component(ab, ac);
  if (scale == 0) return {{0, 0, 0}, 0};
  // Divides instead of multiplying by the inverse, so that vectors along an axis stay exact.
  const auto over = [](const Vector3& v, double d) { return Vector3{v[0] / d, v[1] / d, v[2] / d}; };
  const Vector3 normal = cross(over(ab, scale), over(ac, scale));
  const double twice_area = norm(normal);
  const double area = 0.5 * twice_area * scale * scale;
  if (twice_area <= kSmallestCross || area == 0) return {{0, 0, 0}, 0};
  return {over(normal, twice_area), area};
}

Box box_of_solid_triangles(const TriangleMesh& mesh) {
  return box_of_those(mesh,
                      [&](const std::array<Vector3, 3>& corners) { return shape_of(corners).area != 0; });
}

Vector3 Surface::blended_normal(std::size_t triangle, const Vector3& point) const {
  const auto [a, b, c] = corners(triangle);
  // Barycentric coordinates of the projection of the point, clamped to at least zero.
  const auto share = [&](const Vector3& from, const Vector3& to) {
    return std::max(0.0, dot(cross(to - from, point - from), normals[triangle]));
  };
  const auto& at = mesh.corner_normals[triangle];
  const Vector3 blended = share(b, c) * at[0] + share(c, a) * at[1] + share(a, b) * at[2];
  const double length = norm(blended);
  return length > 0 ? (1 / length) * blended : normals[triangle];
}

double enclosed_volume(const Surface& surface) {
  double volume = 0;
  for (std::size_t t = 0; t < surface.size(); ++t)
    volume += surface.areas[t] * dot(surface.normals[t], surface.corners(t)[0] - surface.box.low) / 3;
  return std::abs(volume);
}

Surface prepare_surface(CheckedMesh mesh) {
  const std::size_t count = mesh->triangles.size();
  Surface surface;
  surface.mesh = *std::move(mesh);
  auto normals = sized_vector<Vector3>(count);
  auto areas = sized_vector<double>(count);
  parallel_for(count, [&](std::size_t t) {
    const TriangleShape shape = shape_of(surface.corners(t));
    normals[t] = shape.normal;
    areas[t] = shape.area;
  });

  auto& triangles = surface.mesh.triangles;
  auto& faces = surface.mesh.faces;
  auto& solids = surface.mesh.solids;
  auto& corner_normals = surface.mesh.corner_normals;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < count; ++t) {
    if (areas[t] == 0) continue;
    if (kept < t) {
      move_entry(triangles, t, kept);
      move_entry(faces, t, kept);
      move_entry(solids, t, kept);
      move_entry(corner_normals, t, kept);
      move_entry(normals, t, kept);
      move_entry(areas, t, kept);
    }
    ++kept;
  }
  shorten(triangles, kept);
  shorten(faces, kept);
  shorten(solids, kept);
  shorten(corner_normals, kept);
  shorten(normals, kept);
  shorten(areas, kept);
  surface.normals = std::move(normals);
  surface.areas = std::move(areas);
  surface.degenerate_triangles = count - triangles.size();
  if (triangles.empty()) {
    if (count == 0) throw Error(ErrorKind::kInput, "no triangles, where a surface is needed");
    throw Error(ErrorKind::kInput, "none of the " + std::to_string(count) + " triangles has an area",
                Remedy::kExportAgain);
  }
  surface.box = box_of_those(surface.mesh, [](const std::array<Vector3, 3>&) { return true; });
  return surface;
}

}  // namespace crossgrain
