// SPDX-License-Identifier: Apache-2.0
#include "solids.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include "picture/corner_normals.hpp"

namespace crossgrain::figures {
namespace {

constexpr std::uint32_t kAround = 96;

/// A surface over a grid of two parameters in [0, 1], shaded as one smooth face.
DrawnMesh smooth_surface(std::uint32_t across, std::uint32_t along,
                         const std::function<Vector3(double, double)>& place) {
  DrawnMesh mesh;
  for (std::uint32_t j = 0; j <= along; ++j)
    for (std::uint32_t i = 0; i <= across; ++i)
      mesh.vertices.push_back(place(static_cast<double>(i) / across, static_cast<double>(j) / along));
  for (std::uint32_t j = 0; j < along; ++j) {
    for (std::uint32_t i = 0; i < across; ++i) {
      const std::uint32_t a = j * (across + 1) + i, b = a + across + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  }
  mesh.corner_normals = corner_normals(mesh.vertices, mesh.triangles, 60);
  mesh.colour = kSurface;
  return mesh;
}

/// A point of a circle about z, by its share of a turn.
Vector3 on_circle(double radius, double share, double height) {
  const double angle = 2 * std::numbers::pi * share;
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

}  // namespace

DrawnMesh plate(const Vector3& centre, const Vector3& normal, const Vector3& along, double side) {
  const Vector3 u = 0.5 * side * along, v = 0.5 * side * cross(normal, along);
  DrawnMesh mesh;
  mesh.vertices = {centre - u - v, centre + u - v, centre + u + v, centre - u + v};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.colour = kSurface;
  return mesh;
}

DrawnMesh cylinder(double radius, double height) {
  return smooth_surface(
      kAround, 1, [&](double share, double up) { return on_circle(radius, share, (up - 0.5) * height); });
}

DrawnMesh ball(double radius) {
  return smooth_surface(kAround, kAround / 2, [&](double share, double up) {
    const double polar = std::numbers::pi * (1 - up);
    return on_circle(radius * std::sin(polar), share, radius * std::cos(polar));
  });
}

void add_arrow(Drawing& drawing, const Vector3& from, const Vector3& direction, double length) {
  const double head = 0.17, thickness = 0.024;
  const Vector3 tip = from + length * direction, neck = tip - head * direction;
  DrawnRods shaft;
  shaft.rods.push_back({from, neck, thickness, kNormal});
  drawing.rods.push_back(shaft);
  const Vector3 u = orthogonal_unit(direction), v = cross(direction, u);
  DrawnMesh cone = smooth_surface(32, 1, [&](double share, double up) {
    const Vector3 place = on_circle(2.9 * thickness * (1 - up), share, 0);
    return neck + place[0] * u + place[1] * v + up * head * direction;
  });
  cone.colour = kNormal;
  drawing.meshes.push_back(cone);
}

}  // namespace crossgrain::figures
