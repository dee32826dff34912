// SPDX-License-Identifier: Apache-2.0
#include "support/shapes.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

#include "support/extrusion.hpp"

namespace crossgrain {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

std::uint32_t add_vertex(TriangleMesh& mesh, const Vector3& p) {
  mesh.vertices.push_back(p);
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

void add_quad(TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

Loop2 rectangle(double width, double depth) {
  const double x = width / 2, y = depth / 2;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

TriangleMesh icosahedron() {
  const double g = std::numbers::phi;
  TriangleMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  return mesh;
}

/// Each triangle into four, new vertices in the middle of the edges.
TriangleMesh subdivide(const TriangleMesh& coarse) {
  TriangleMesh fine{coarse.vertices, {}};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [entry, is_new] = middles.try_emplace(std::minmax(a, b), 0u);
    if (is_new) entry->second = add_vertex(fine, 0.5 * (fine.vertices[a] + fine.vertices[b]));
    return entry->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const auto& t :
         {std::array{a, ab, ca}, std::array{b, bc, ab}, std::array{c, ca, bc}, std::array{ab, bc, ca}})
      fine.triangles.push_back(t);
  }
  return fine;
}

}  // namespace

TriangleMesh make_box(const Vector3& size) {
  return extrude(rectangle(size[0], size[1]), {}, -size[2] / 2, {size[2] / 2});
}

TriangleMesh make_sphere(double radius, int subdivisions) {
  TriangleMesh mesh = icosahedron();
  for (int i = 0; i < subdivisions; ++i) {
    mesh = subdivide(mesh);
    for (Vector3& p : mesh.vertices) p = normalised(p);
  }
  for (Vector3& p : mesh.vertices) p = radius * normalised(p);
  return mesh;
}

TriangleMesh make_cylinder(double radius, double half_height, int segments, int rings) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(segments), levels = static_cast<std::uint32_t>(rings);
  for (std::uint32_t level = 0; level <= levels; ++level) {
    const double z = half_height * (2.0 * level / levels - 1);
    for (std::uint32_t i = 0; i < n; ++i)
      add_vertex(mesh, {radius * std::cos(kTurn * i / n), radius * std::sin(kTurn * i / n), z});
  }
  const std::uint32_t bottom = add_vertex(mesh, {0, 0, -half_height});
  const std::uint32_t top = add_vertex(mesh, {0, 0, half_height});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n, last = levels * n;
    for (std::uint32_t row = 0; row < last; row += n)
      add_quad(mesh, row + i, row + next, row + n + next, row + n + i);
    mesh.triangles.push_back({bottom, next, i});
    mesh.triangles.push_back({top, last + i, last + next});
  }
  return mesh;
}

TriangleMesh make_thin_cylinder() {
  return make_cylinder(0.01, 0.6, 48);
}

TriangleMesh make_torus(double major_radius, double minor_radius, int major_segments, int minor_segments) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(major_segments), m = static_cast<std::uint32_t>(minor_segments);
  for (std::uint32_t i = 0; i < n; ++i) {
    const double along_rad = kTurn * i / n;
    for (std::uint32_t j = 0; j < m; ++j) {
      const double around_rad = kTurn * j / m, r = major_radius + minor_radius * std::cos(around_rad);
      add_vertex(mesh,
                 {r * std::cos(along_rad), r * std::sin(along_rad), minor_radius * std::sin(around_rad)});
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < m; ++j) {
      const std::uint32_t here = i * m, there = (i + 1) % n * m, next = (j + 1) % m;
      add_quad(mesh, here + j, there + j, there + next, here + next);
    }
  }
  return mesh;
}

TriangleMesh make_box_with_hole(int segments, double hole_radius) {
  return extrude(rectangle(1.4, 1.2), {round_hole({0.2, 0.1}, hole_radius, segments)}, -0.3, {0.3});
}

TriangleMesh make_plates(double gap, double thickness) {
  const Loop2 square = rectangle(1, 1);
  return join_meshes(extrude(square, {}, -gap / 2 - thickness, {-gap / 2}),
                     extrude(square, {}, gap / 2, {gap / 2 + thickness}));
}

TriangleMesh make_wall(double thickness) {
  return make_box({1, 1, thickness});
}

TriangleMesh make_bracket(int segments) {
  Loop2 outer{{-0.6, -0.5}, {0.7, -0.5}, {0.7, -0.1}};
  const double pi = std::numbers::pi;
  for (const Point2& p : arc({-0.05, 0.1}, 0.2, -pi / 2, -pi, std::max(1, segments / 4))) outer.push_back(p);
  for (const Point2& p : Loop2{{-0.25, 0.5}, {-0.4, 0.5}, {-0.6, 0.3}}) outer.push_back(p);
  return extrude(outer, {round_hole({0.4, -0.3}, 0.12, segments)}, -0.25, {0.2, {0.15, -0.1}});
}

TriangleMesh rotate_mesh(TriangleMesh mesh, const Quaternion& rotation) {
  for (Vector3& p : mesh.vertices) p = rotate(rotation, p);
  return mesh;
}

TriangleMesh translate_mesh(TriangleMesh mesh, const Vector3& offset) {
  for (Vector3& p : mesh.vertices) p += offset;
  return mesh;
}

TriangleMesh scale_mesh(TriangleMesh mesh, double factor) {
  for (Vector3& p : mesh.vertices) p = factor * p;
  return mesh;
}

TriangleMesh flip_mesh(TriangleMesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

TriangleMesh join_meshes(TriangleMesh first, const TriangleMesh& second) {
  const auto offset = static_cast<std::uint32_t>(first.vertices.size());
  first.vertices.insert(first.vertices.end(), second.vertices.begin(), second.vertices.end());
  for (const auto& [a, b, c] : second.triangles)
    first.triangles.push_back({offset + a, offset + b, offset + c});
  return first;
}

TriangleMesh to_soup(const TriangleMesh& mesh) {
  TriangleMesh soup;
  for (const auto& triangle : mesh.triangles) {
    const auto base = static_cast<std::uint32_t>(soup.vertices.size());
    for (const std::uint32_t v : triangle) soup.vertices.push_back(mesh.vertices[v]);
    soup.triangles.push_back({base, base + 1, base + 2});
  }
  return soup;
}

}  // namespace crossgrain
