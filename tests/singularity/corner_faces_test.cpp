// SPDX-License-Identifier: Apache-2.0
#include "singularity/corner_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "singularity/solids.hpp"

namespace crossgrain {
namespace {

/// A number for each plane of a prism (`prism`): 1 below, 2 above, then the sides from 3 on.
std::vector<std::int32_t> faces_of_prism(std::size_t corners) {
  std::vector<std::int32_t> faces;
  for (std::size_t k = 1; k + 1 < corners; ++k) faces.insert(faces.end(), {1, 2});
  for (std::size_t k = 0; k < corners; ++k) faces.insert(faces.end(), 2, static_cast<std::int32_t>(3 + k));
  return faces;
}

std::vector<std::int32_t> sorted(std::vector<std::int32_t> faces) {
  std::ranges::sort(faces);
  return faces;
}

TEST(CornerFaces, OfACornerBeginWithTheNarrowest) {
  const MadeSolid solid = wedge(20);  // sides 3, 4 and 5; the edge of 20 degrees is that of 5 and 3
  const std::vector<std::int32_t> faces = faces_of_prism(3);
  const SurfaceFans fans({solid.vertices, solid.triangles, faces});
  const CornerFaces below = fans.at(0);
  EXPECT_NEAR(below.narrowest_deg, 20, 1e-9);
  EXPECT_EQ(below.faces.front(), 1);
  EXPECT_EQ(sorted(below.faces), (std::vector{1, 3, 5}));
}

TEST(CornerFaces, AreEmptyWithoutNumbers) {
  const MadeSolid solid = wedge(20);
  const CornerFaces below = SurfaceFans(solid.surface()).at(0);
  EXPECT_NEAR(below.narrowest_deg, 20, 1e-9);
  EXPECT_TRUE(below.faces.empty());
}

TEST(CornerFaces, BesideAnEdgeAreTwo) {
  const MadeSolid solid = wedge(20);
  const std::vector<std::int32_t> faces = faces_of_prism(3);
  const SolidSurface surface{solid.vertices, solid.triangles, faces};
  const SurfaceFans fans(surface);
  for (const SolidCrease& crease : solid_creases(surface).creases)
    if (crease.mean_angle_deg < 45) {
      EXPECT_EQ(sorted(fans.beside(crease.edges[crease.sharpest])), (std::vector{3, 5}));
    }
}

}  // namespace
}  // namespace crossgrain
