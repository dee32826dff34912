// SPDX-License-Identifier: Apache-2.0
// The solids that other tests rely on are what they claim to be.
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/vector3.hpp"
#include "surface/surface.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c])) / 6;
  return sum;
}

double area(const TriangleMesh& mesh) {
  const Surface surface = prepare_surface(mesh);
  double sum = 0;
  for (const double triangle_area : surface.areas) sum += triangle_area;
  return sum;
}

/// The area of a regular polygon inscribed in a circle.
double polygon_area(double radius, int segments) {
  return 0.5 * segments * radius * radius * std::sin(2 * std::numbers::pi / segments);
}

struct NamedShape {
  const char* name;
  TriangleMesh mesh;
  std::size_t components;
  int genus;
};

std::vector<NamedShape> all_shapes() {
  return {{"box", make_box({1, 2, 3}), 1, 0},
          {"sphere", make_sphere(0.8, 3), 1, 0},
          {"cylinder", make_cylinder(0.55, 0.7, 24, 5), 1, 0},
          {"cylinder with one ring", make_cylinder(0.55, 0.7, 3), 1, 0},
          {"thin cylinder", make_thin_cylinder(), 1, 0},
          {"torus", make_torus(0.6, 0.25, 24, 12), 1, 1},
          {"box with a hole", make_box_with_hole(48), 1, 1},
          {"plates", make_plates(0.05), 2, 0},
          {"wall", make_wall(0.02), 1, 0},
          {"coarse bracket", make_bracket(8), 1, 1},
          {"bracket", make_bracket(96), 1, 1}};
}

TEST(Shapes, AreWatertightWithTheirComponentsAndHandles) {
  for (const NamedShape& shape : all_shapes()) {
    const SurfaceTopology topology = analyse_topology(weld(shape.mesh));
    EXPECT_TRUE(topology.watertight) << shape.name;
    EXPECT_EQ(topology.components, shape.components) << shape.name;
    EXPECT_EQ(topology.degenerate_triangles, 0u) << shape.name;
    // Euler: V - E + F = 2 (components - handles), with E = 3 F / 2.
    const auto faces = static_cast<int>(shape.mesh.triangles.size());
    const int euler = static_cast<int>(weld(shape.mesh).vertices.size()) - faces / 2;
    EXPECT_EQ(euler, 2 * (static_cast<int>(shape.components) - shape.genus)) << shape.name;
  }
}

TEST(Shapes, PointOutward) {
  for (const NamedShape& shape : all_shapes()) EXPECT_GT(volume(shape.mesh), 0) << shape.name;
}

TEST(Shapes, HaveTheVolumesOfTheirFormulas) {
  EXPECT_NEAR(volume(make_box({1, 2, 3})), 6, 1e-14);
  EXPECT_NEAR(volume(make_cylinder(0.55, 0.7, 24, 5)), 1.4 * polygon_area(0.55, 24), 1e-14);
  EXPECT_NEAR(volume(make_box_with_hole(48)), 0.6 * (1.4 * 1.2 - polygon_area(0.25, 48)), 1e-14);
  EXPECT_NEAR(volume(make_plates(0.05)), 0.8, 1e-14);
  EXPECT_NEAR(volume(make_wall(0.02)), 0.02, 1e-15);
}

TEST(Shapes, RoundOnesTendToTheVolumesAndAreasOfTheSmoothSolids) {
  // Facets of edge e miss a share of about (e / radius)^2 / 6 of area and / 3 of volume; e / radius < 0.08
  // here.
  const double pi = std::numbers::pi;
  EXPECT_NEAR(volume(make_sphere(0.8, 4)) / (4 * pi * std::pow(0.8, 3) / 3), 1, 3e-3);
  EXPECT_NEAR(area(make_sphere(0.8, 4)) / (4 * pi * 0.8 * 0.8), 1, 3e-3);
  EXPECT_NEAR(volume(make_torus(0.6, 0.25, 120, 80)) / (2 * pi * pi * 0.6 * 0.25 * 0.25), 1, 3e-3);
  EXPECT_NEAR(area(make_torus(0.6, 0.25, 120, 80)) / (4 * pi * pi * 0.6 * 0.25), 1, 3e-3);
}

TEST(Shapes, BracketHasTheVolumeOfItsProfileUnderTheSlantedTop) {
  // Pappus: a prism under a plane has the profile's area times the height over the profile's centroid. Pieces
  // as (area, x, y): long arm, short arm, chamfer, hole; and the fillet, whose facets keep it above its
  // circle.
  const double hole = polygon_area(0.12, 96);
  struct Piece {
    double area, x, y;
  };
  const std::vector<Piece> pieces{{1.3 * 0.4, 0.05, -0.3},
                                  {0.35 * 0.6, -0.425, 0.2},
                                  {-0.5 * 0.2 * 0.2, -0.6 + 0.2 / 3, 0.5 - 0.2 / 3},
                                  {-hole, 0.4, -0.3}};
  double expected = 0;
  for (const Piece& piece : pieces) expected += piece.area * (0.45 + 0.15 * piece.x - 0.1 * piece.y);
  const double fillet = 0.2 * 0.2 * (1 - std::numbers::pi / 4);
  expected += fillet * (0.45 + 0.15 * -0.2 - 0.1 * -0.05);
  // The fillet's centroid is taken as its middle, to 0.03 of its slope; 24 facets on its arc leave 2e-5.
  EXPECT_NEAR(volume(make_bracket(96)), expected, 1e-4);
}

TEST(Shapes, TurnMoveAndScaleAsSolids) {
  const TriangleMesh bracket = make_bracket(16);
  const TriangleMesh turned = rotate_mesh(bracket, from_rotation_vector({0.3, -0.5, 0.7}));
  EXPECT_NEAR(volume(turned), volume(bracket), 1e-14);
  EXPECT_NEAR(volume(translate_mesh(bracket, {1, 2, 3})), volume(bracket), 1e-13);
  EXPECT_NEAR(volume(scale_mesh(bracket, 2)), 8 * volume(bracket), 1e-14);
  EXPECT_NEAR(volume(flip_mesh(bracket)), -volume(bracket), 1e-14);
}

TEST(Shapes, OfASphereHaveTheirCornersOnTheSphere) {
  for (const Vector3& p : make_sphere(0.8, 3).vertices) ASSERT_NEAR(norm(p), 0.8, 1e-15);
}

}  // namespace
}  // namespace crossgrain
