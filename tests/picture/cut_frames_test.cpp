// SPDX-License-Identifier: Apache-2.0
#include "picture/cut_frames.hpp"

#include <gtest/gtest.h>

#include "display/axis_colours.hpp"
#include "display/smooth_corners.hpp"
#include "picture/cut_outline.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

TEST(CutOutline, EnclosesWhatIsInsideABoxAndNothingElse) {
  const TriangleMesh box = make_box({2, 1, 1.5});
  Vector3 middle{0, 0, 0};
  for (const Vector3& vertex : box.vertices) middle += 1.0 / 8 * vertex;
  const CutOutline outline(box.vertices, box.triangles, 1, middle[1]);
  EXPECT_TRUE(outline.encloses(middle));
  EXPECT_TRUE(outline.encloses(middle + Vector3{0.95, 0, 0.7}));
  EXPECT_FALSE(outline.encloses(middle + Vector3{1.05, 0, 0}));
  EXPECT_FALSE(outline.encloses(middle + Vector3{-1.05, 0, 0.1}));
  EXPECT_FALSE(outline.encloses(middle + Vector3{0, 0, 0.8}));
  EXPECT_NEAR(outline.distance_to(middle), 0.75, 1e-12);
  EXPECT_NEAR(outline.distance_to(middle + Vector3{0.9, 0, 0}), 0.1, 1e-12);
}

TEST(PlacesOnPlane, AreApartAndFillThinWallsToo) {
  const Box box{{0, 0, 0}, {10, 1, 10}};
  // A frame of walls 0.3 thick, between the rows of the coarse grid.
  const auto is_wall = [](const Vector3& p) {
    return std::min({p[0], p[2], 10 - p[0], 10 - p[2]}) > 0.2 &&
           std::max(std::abs(p[0] - 5), std::abs(p[2] - 5)) > 4.5;
  };
  const auto places = places_on_plane(box, 1, 0.5, 1.0, is_wall);
  EXPECT_GT(places.size(), 24u);
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_EQ(places[i][1], 0.5);
    for (std::size_t j = 0; j < i; ++j) ASSERT_GT(norm(places[i] - places[j]), 0.99);
  }
}

TEST(FrameBoxes, StandOnThePlaneWithTheirSidesInTheColoursOfTheAxes) {
  const Quaternion frame = from_rotation_vector({0.3, -0.2, 0.5});
  const Vector3 place{1, 2, 3}, normal{0, -1, 0};
  const AxisNames names{1, 2, 0};
  const auto meshes = frame_boxes({{place, frame, names}}, 0.5, normal);
  ASSERT_EQ(meshes.size(), 3u);
  const auto axes = axes_of(frame);
  double lowest = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const DrawnMesh& mesh = meshes[names[k]];
    EXPECT_EQ(mesh.colour, colour_of(kAxisColours[names[k]]));
    ASSERT_EQ(mesh.triangles.size(), 4u);
    Vector3 middle{0, 0, 0};
    for (const Vector3& vertex : mesh.vertices) middle += 1.0 / 8 * vertex;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vector3 out = cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
      EXPECT_GT(dot(out, mesh.vertices[a] - middle), 0);
      EXPECT_NEAR(std::abs(dot(normalised(out), axes[k])), 1, 1e-12);
    }
    for (const Vector3& vertex : mesh.vertices) lowest = std::min(lowest, dot(vertex - place, normal));
  }
  EXPECT_NEAR(lowest, 0, 1e-12);
}

TEST(FrameCrosses, StandOnThePlane) {
  const Quaternion frame = from_rotation_vector({0.3, -0.2, 0.5});
  const DrawnRods crosses = frame_crosses({{{1, 2, 3}, frame, {0, 1, 2}}}, 0.5, {0, 0, 1});
  ASSERT_EQ(crosses.rods.size(), 3u);
  double lowest = 4;
  for (const Rod& rod : crosses.rods) lowest = std::min({lowest, rod.from[2], rod.to[2]});
  EXPECT_NEAR(lowest, 3, 1e-12);
}

TEST(CornerNormals, AreTheFacesOwnAtRightAngles) {
  const TriangleMesh box = make_box({2, 1, 1.5});
  const auto normals = corner_normals(SmoothCorners(box.vertices, box.triangles), box.triangles.size());
  for (std::size_t t = 0; t < box.triangles.size(); ++t) {
    const auto& [a, b, c] = box.triangles[t];
    const Vector3 own =
        normalised(cross(box.vertices[b] - box.vertices[a], box.vertices[c] - box.vertices[a]));
    for (const auto& normal : normals[t])
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(static_cast<double>(normal[k]), own[k], 1e-6);
  }
}

}  // namespace
}  // namespace crossgrain
