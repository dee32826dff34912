// SPDX-License-Identifier: Apache-2.0
#include "tets/boundary_vertices.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

/// On how many faces of the box a point lies.
int faces_of_box(const Vector3& p, const TetBox& box) {
  int faces = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) faces += p[axis] == 0 || p[axis] == box.cells[axis];
  return faces;
}

class BoundaryOfABox : public ::testing::Test {
 protected:
  const TetBox box{{3, 4, 5}};
  const TetSolid solid = solid_of(box.mesh(0.1));
  const BoundaryVertices boundary = classify_boundary_vertices(solid);

  const Vector3& position(std::size_t k) const { return solid.mesh.vertices[boundary.vertices[k]]; }
};

TEST_F(BoundaryOfABox, ListsItsVerticesAscending) {
  EXPECT_EQ(boundary.size(), 4u * 5 * 6 - 2 * 3 * 4);
  for (std::size_t k = 1; k < boundary.size(); ++k) EXPECT_LT(boundary.vertices[k - 1], boundary.vertices[k]);
}

TEST_F(BoundaryOfABox, IsSmoothOnFacesCreasedOnEdgesAndHasCorners) {
  constexpr std::array kClasses = {BoundaryClass::kSmooth, BoundaryClass::kCrease, BoundaryClass::kCorner};
  for (std::size_t k = 0; k < boundary.size(); ++k)
    EXPECT_EQ(boundary.classes[k], kClasses.at(static_cast<std::size_t>(faces_of_box(position(k), box) - 1)));
}

TEST_F(BoundaryOfABox, HasOutwardNormals) {
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = position(k)[axis], n = boundary.normals[k][axis];
      const int side = x == 0 ? -1 : x == box.cells[axis] ? 1 : 0;
      EXPECT_EQ(n > 1e-15, side > 0);
      EXPECT_EQ(n < -1e-15, side < 0);
    }
    EXPECT_NEAR(norm(boundary.normals[k]), 1, 1e-15);
  }
}

TEST_F(BoundaryOfABox, SpreadsByTheAngleBetweenFacesAndTheirMean) {
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    if (boundary.classes[k] == BoundaryClass::kCorner) continue;
    // Along an edge of the box three triangles lie on either side. An arc cosine of 1 less one rounding is
    // 1e-6 degrees.
    EXPECT_NEAR(boundary.spread_deg[k], boundary.classes[k] == BoundaryClass::kSmooth ? 0 : 45, 2e-6);
  }
}

TEST_F(BoundaryOfABox, HasTangentsAlongItsEdges) {
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    const Vector3& tangent = boundary.tangents[k];
    if (boundary.classes[k] != BoundaryClass::kCrease) {
      EXPECT_EQ(tangent, (Vector3{0, 0, 0}));
      continue;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = position(k)[axis];
      EXPECT_EQ(std::abs(tangent[axis]), x == 0 || x == box.cells[axis] ? 0 : 1);
    }
  }
}

TEST_F(BoundaryOfABox, SharesOutTheWholeArea) {
  double area = 0;
  for (const FaceAtVertex& face : boundary.faces) area += face.area_third;
  EXPECT_NEAR(area, 2 * (3 * 4 + 4 * 5 + 5 * 3), 1e-12);
}

TEST_F(BoundaryOfABox, GivesEachVertexItsOwnFaces) {
  std::vector<std::size_t> faces(solid.mesh.vertices.size(), 0);
  for (const auto& face : solid.boundary)
    for (const std::uint32_t v : face) ++faces[v];
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    EXPECT_EQ(boundary.faces_at(k).size(), faces[boundary.vertices[k]]);
    for (const FaceAtVertex& face : boundary.faces_at(k)) {
      // The plane of the face passes through the vertex.
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (face.normal[axis] == 0) continue;
        EXPECT_EQ(position(k)[axis], face.normal[axis] > 0 ? box.cells[axis] : 0);
      }
    }
  }
}

TEST(BoundaryVertices, ACreaseThatTurnsTooMuchIsACorner) {
  const TetBox box{{2, 2, 2}};
  TetMesh mesh = box.mesh();
  mesh.vertices[box.at(1, 0, 0)] = {1, 0.2,
                                    0};  // two edges from (1, .2, 0) turn by 2 atan(.2) = 22.6 degrees
  const TetSolid solid = solid_of(mesh);
  const auto class_with = [&](double turn_deg) {
    const BoundaryVertices boundary = classify_boundary_vertices(solid, {.crease_turn_deg = turn_deg});
    return boundary.classes[1];
  };
  ASSERT_EQ(box.at(1, 0, 0), 1u);
  EXPECT_EQ(class_with(23), BoundaryClass::kCrease);
  EXPECT_EQ(class_with(22), BoundaryClass::kCorner);
}

TEST(BoundaryVertices, OneTetHasCornersOnly) {
  const BoundaryVertices boundary = classify_boundary_vertices(solid_of(corner_tet()));
  ASSERT_EQ(boundary.size(), 4u);
  for (const BoundaryClass c : boundary.classes) EXPECT_EQ(c, BoundaryClass::kCorner);
  EXPECT_NEAR(boundary.spread_deg[0], std::acos(1 / std::sqrt(3.0)) * 180 / std::numbers::pi, 1e-12);
  EXPECT_NEAR(norm(boundary.normals[0] - normalised({-1, -1, -1})), 0, 1e-15);
}

TEST(BoundaryVertices, TheSpreadOptionDecidesWhatIsSmooth) {
  const BoundaryVertices boundary =
      classify_boundary_vertices(solid_of(corner_tet()), {.smooth_spread_deg = 60});
  EXPECT_EQ(boundary.classes[0], BoundaryClass::kSmooth);
}

TEST(BoundaryVertices, FacesWithoutAreaCountNowhere) {
  // Below the corner tet a flat one whose fourth vertex, 4, divides the edge from 0 to 1.
  TetMesh mesh = corner_tet();
  mesh.vertices.push_back({0.5, 0, 0});
  mesh.tets.push_back({0, 1, 2, 4});
  const TetSolid solid = solid_of(mesh);
  EXPECT_EQ(solid.boundary.size(), 6u);
  const BoundaryVertices boundary = classify_boundary_vertices(solid);
  for (const FaceAtVertex& face : boundary.faces) EXPECT_GT(face.area_third, 0);
  double area = 0;
  for (const FaceAtVertex& face : boundary.faces) area += face.area_third;
  EXPECT_NEAR(area, 1.5 + std::sqrt(3.0) / 2, 1e-14);
}

class BoundaryOfTwoRegions : public ::testing::Test {
 protected:
  const TetBox box{{4, 4, 4}};
  const TetSolid solid =
      solid_of(with_regions(box.mesh(), [](const Vector3& p) { return p[0] < 2 ? 1 : 2; }));
  std::vector<Warning> warnings;
  const std::vector<InnerWall> walls = find_inner_walls(solid, warnings);

  /// The place of a vertex in the lists.
  static std::size_t place(const BoundaryVertices& boundary, std::uint32_t vertex) {
    const auto at = std::find(boundary.vertices.begin(), boundary.vertices.end(), vertex);
    EXPECT_NE(at, boundary.vertices.end());
    return static_cast<std::size_t>(at - boundary.vertices.begin());
  }
};

TEST_F(BoundaryOfTwoRegions, IsSmoothInsideTheFaceBetweenAndCreasedAtItsRim) {
  const BoundaryVertices boundary = classify_boundary_vertices(solid, {}, features_of(solid, walls, false));
  EXPECT_EQ(boundary.size(), 5u * 5 * 5 - 3 * 3 * 3 + 3 * 3);
  for (std::uint32_t y = 1; y < 4; ++y) {
    const std::size_t inside = place(boundary, box.at(2, y, 2)), rim = place(boundary, box.at(2, y, 4));
    EXPECT_EQ(boundary.classes[inside], BoundaryClass::kSmooth);
    EXPECT_NEAR(std::abs(boundary.normals[inside][0]), 1, 1e-15);
    EXPECT_EQ(boundary.classes[rim], BoundaryClass::kCrease);
    EXPECT_NEAR(std::abs(boundary.tangents[rim][1]), 1, 1e-15);
  }
  EXPECT_EQ(boundary.classes[place(boundary, box.at(2, 4, 4))], BoundaryClass::kCorner);
}

TEST_F(BoundaryOfTwoRegions, UnitedIsThatOfOne) {
  const BoundaryVertices united = classify_boundary_vertices(solid, {}, features_of(solid, walls, true));
  const BoundaryVertices plain = classify_boundary_vertices(solid_of(box.mesh()));
  EXPECT_EQ(united.vertices, plain.vertices);
  EXPECT_EQ(united.classes, plain.classes);
  EXPECT_EQ(united.normals, plain.normals);
}

TEST_F(BoundaryOfTwoRegions, UnitedLosesEdgesTaggedAlongTheFaceBetweenOnly) {
  TetSolid tagged = solid;
  tagged.mesh.feature_edges = {{{box.at(2, 1, 2), box.at(2, 2, 2)}, 1},
                               {{box.at(1, 1, 1), box.at(1, 2, 1)}, 2}};
  EXPECT_EQ(features_of(tagged, walls, false).edges.size(), 2u);
  const InnerFeatures united = features_of(tagged, walls, true);
  ASSERT_EQ(united.edges.size(), 1u);
  EXPECT_EQ(united.edges[0], tagged.mesh.feature_edges[1].vertices);
}

TEST_F(BoundaryOfTwoRegions, HasTangentsOfTaggedEdgesInsideAndOnFaces) {
  InnerFeatures features;
  features.edges = {{box.at(1, 1, 1), box.at(1, 2, 1)},
                    {box.at(1, 2, 1), box.at(1, 3, 1)},
                    {box.at(1, 1, 4), box.at(2, 2, 4)}};
  const BoundaryVertices boundary = classify_boundary_vertices(solid, {}, features);
  const std::size_t middle = place(boundary, box.at(1, 2, 1)), end = place(boundary, box.at(1, 3, 1)),
                    on_face = place(boundary, box.at(1, 1, 4));
  for (const std::size_t k : {middle, end}) {
    EXPECT_EQ(boundary.classes[k], BoundaryClass::kCrease);
    EXPECT_TRUE(boundary.faces_at(k).empty());
    EXPECT_NEAR(std::abs(boundary.tangents[k][1]), 1, 1e-15);
  }
  EXPECT_EQ(boundary.classes[on_face], BoundaryClass::kSmooth);
  EXPECT_NEAR(std::abs(dot(boundary.tangents[on_face], normalised(Vector3{1, 1, 0}))), 1, 1e-15);
}

TEST(BoundaryVertices, OfACreaseThatFadesOutHaveATangentOnlyIfItCounts) {
  // A ridge on the top of a box, with 50 degrees between its sides at x = 0 and none from x = 6 on.
  const TetBox box{{8, 8, 4}};
  TetMesh mesh = box.mesh();
  for (Vector3& p : mesh.vertices)
    p[2] *= 1 - std::tan(25 * std::numbers::pi / 180) * std::max(0.0, 1 - p[0] / 6) * std::abs(p[1] - 4) / 4;
  const TetSolid solid = solid_of(mesh);
  BoundaryVertexOptions every_edge;
  every_edge.fading.least_radii = 0;
  for (const bool counts : {true, false}) {
    const BoundaryVertices boundary =
        classify_boundary_vertices(solid, counts ? every_edge : BoundaryVertexOptions{});
    for (const std::uint32_t x : {1u, 2u}) {
      const auto at = std::lower_bound(boundary.vertices.begin(), boundary.vertices.end(), box.at(x, 4, 4));
      const auto k = static_cast<std::size_t>(at - boundary.vertices.begin());
      EXPECT_EQ(boundary.classes[k], counts ? BoundaryClass::kCrease : BoundaryClass::kCorner);
      EXPECT_NEAR(norm(boundary.tangents[k]), counts ? 1 : 0, 1e-15);
    }
  }
}

}  // namespace
}  // namespace crossgrain
