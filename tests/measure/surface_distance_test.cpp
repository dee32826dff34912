// SPDX-License-Identifier: Apache-2.0
#include "measure/surface_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "base/vector3.hpp"
#include "support/shapes.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

/// Of one quad whose corners are on the surface of a body.
double cut_off_by_quad(const TriangleMesh& body, const std::array<Vector3, 4>& corners) {
  const FeatureComplex complex = feature_complex(prepare_surface(weld(body)));
  const FeatureTrees trees(complex);
  HexMesh mesh;
  mesh.vertices.assign(corners.begin(), corners.end());
  const std::vector<SurfaceQuad> quads{{{0, 1, 2, 3}, 1, 0}};
  Vector3 centre{0, 0, 0};
  for (const Vector3& corner : corners) centre += 0.25 * corner;
  const std::vector<std::uint32_t> faces{trees.nearest_face(centre, 1, 0)};
  return cut_off_by_quads(mesh, quads, faces, trees).front();
}

TEST(CutOffByQuads, IsTheDepthOfTheMiddleOnACylinder) {
  const double radius = 2, angle = 0.2;
  const auto corner = [&](double turn, double z) {
    return Vector3{radius * std::cos(turn), radius * std::sin(turn), z};
  };
  const double depth = radius * (1 - std::cos(angle));
  EXPECT_NEAR(cut_off_by_quad(make_cylinder(radius, 3, 512), {corner(-angle, -0.4), corner(angle, -0.4),
                                                              corner(angle, 0.4), corner(-angle, 0.4)}),
              depth, 0.02 * depth);
}

TEST(CutOffByQuads, IsTheDepthOfTheMiddleOnASphere) {
  const double radius = 2, side = 0.4;
  const double height = std::sqrt(radius * radius - 2 * side * side);
  const double depth = radius - height;
  EXPECT_NEAR(
      cut_off_by_quad(
          make_sphere(radius, 5),
          {{{side, -side, height}, {side, side, height}, {-side, side, height}, {-side, -side, height}}}),
      depth, 0.03 * depth);
}

TEST(CutOffByQuads, IsNothingOnAPlane) {
  EXPECT_EQ(cut_off_by_quad(make_box({2, 2, 2}),
                            {{{0.5, -0.5, 1}, {0.5, 0.5, 1}, {-0.5, 0.5, 1}, {-0.5, -0.5, 1}}}),
            0);
}

}  // namespace
}  // namespace crossgrain
