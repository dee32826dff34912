// SPDX-License-Identifier: Apache-2.0
#include "surface/surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

/// What prepare_surface says against a mesh, "" if it takes it.
std::string complaint(const TriangleMesh& mesh) {
  try {
    prepare_surface(mesh);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    return error.what();
  }
  return "";
}

TriangleMesh one_triangle() {
  return {{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}, {{0, 1, 2}}};
}

TEST(Surface, HasTheNormalAndAreaOfATriangleByTheRightHandRule) {
  const Surface surface = prepare_surface(one_triangle());
  EXPECT_EQ(surface.areas[0], 3);
  EXPECT_EQ(surface.normals[0], (Vector3{0, 0, 1}));
}

TEST(Surface, OfACubeHasTheAreaOfSixSquares) {
  const Surface surface = prepare_surface(make_box({2, 2, 2}));
  EXPECT_DOUBLE_EQ(std::accumulate(surface.areas.begin(), surface.areas.end(), 0.0), 24);
}

TEST(Surface, DropsTrianglesWithoutAreaIntoACount) {
  TriangleMesh mesh = one_triangle();
  mesh.vertices.push_back({1, 0, 0});
  mesh.triangles = {{0, 3, 1}, {0, 1, 2}, {1, 1, 2}};
  const Surface surface = prepare_surface(mesh);
  EXPECT_EQ(surface.degenerate_triangles, 2u);
  ASSERT_EQ(surface.size(), 1u);
  EXPECT_EQ(surface.mesh.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
  EXPECT_EQ(surface.normals.size(), 1u);
}

TEST(Surface, KeepsInStepWhatAFileKnowsOfTriangles) {
  TriangleMesh mesh = one_triangle();
  mesh.vertices.push_back({1, 0, 0});
  mesh.triangles = {{0, 3, 1}, {0, 1, 2}, {1, 1, 2}, {3, 1, 2}};
  mesh.faces = {1, 2, 3, 4};
  mesh.solids = {5, 6, 7, 8};
  for (const double z : {1.0, 2.0, 3.0, 4.0})
    mesh.corner_normals.push_back({Vector3{0, 0, z}, {0, 0, z}, {0, 0, z}});
  mesh.creases = {{{{0, 0, 0}, {2, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}, 9}};
  const Surface surface = prepare_surface(mesh);
  EXPECT_EQ(surface.mesh.faces, (std::vector<std::int32_t>{2, 4}));
  EXPECT_EQ(surface.mesh.solids, (std::vector<std::int32_t>{6, 8}));
  ASSERT_EQ(surface.mesh.corner_normals.size(), 2u);
  EXPECT_EQ(surface.mesh.corner_normals[0][2][2], 2);
  EXPECT_EQ(surface.mesh.corner_normals[1][0][2], 4);
  ASSERT_EQ(surface.mesh.creases.size(), 1u);
  EXPECT_EQ(surface.mesh.creases[0].tag, 9);
}

TEST(Surface, RefusesEntriesThatAreNotOneATriangle) {
  TriangleMesh mesh = one_triangle();
  mesh.faces = {1, 2};
  EXPECT_NE(complaint(mesh).find("faces: has 2 entries for 1 triangles"), std::string::npos);
}

TEST(Surface, KeepsANeedleThatHasADirection) {
  TriangleMesh mesh = one_triangle();
  mesh.vertices[2] = {1, 1e-9, 0};
  EXPECT_EQ(prepare_surface(mesh).normals[0], (Vector3{0, 0, 1}));
}

TEST(Surface, BoxLeavesOutVerticesThatNoTriangleUses) {
  TriangleMesh mesh = one_triangle();
  mesh.vertices.push_back({100, 100, 100});
  EXPECT_EQ(prepare_surface(mesh).box.high, (Vector3{2, 3, 0}));
}

TEST(Surface, NormalsDoNotDependOnTheUnitOfLength) {
  // 1e-60 and 1e60: squares of areas would leave the range of double, areas themselves do not.
  const TriangleMesh bracket = make_bracket(16);
  const Surface surface = prepare_surface(bracket);
  for (const double factor : {0x1p-200, 0x1p200}) {
    const Surface scaled = prepare_surface(scale_mesh(bracket, factor));
    EXPECT_EQ(scaled.normals, surface.normals);
    for (std::size_t t = 0; t < surface.size(); ++t)
      ASSERT_EQ(scaled.areas[t], surface.areas[t] * factor * factor);
  }
}

TEST(Surface, RefusesAMeshWithoutTriangles) {
  EXPECT_NE(complaint({{{0, 0, 0}}, {}}).find("no triangles"), std::string::npos);
}

TEST(Surface, RefusesAMeshWhoseTrianglesHaveNoArea) {
  EXPECT_NE(complaint({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}}).find("none of the 1 triangles"),
            std::string::npos);
}

TEST(Surface, NamesTheVertexThatIsNotFinite) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    TriangleMesh mesh = one_triangle();
    mesh.vertices[2][1] = bad;
    EXPECT_NE(complaint(mesh).find("vertex 2 (counted from 0): coordinate that is not a finite number"),
              std::string::npos);
  }
}

TEST(Surface, RefusesCoordinatesWhoseVolumesWouldOverflow) {
  TriangleMesh mesh = one_triangle();
  mesh.vertices[1][0] = 1e200;
  EXPECT_NE(complaint(mesh).find("vertex 1 (counted from 0): coordinate beyond 1e100"), std::string::npos);
}

TEST(Surface, NamesTheTriangleWhoseIndexIsOutOfRange) {
  TriangleMesh mesh = one_triangle();
  mesh.triangles.push_back({0, 1, 3});
  EXPECT_NE(complaint(mesh).find("triangle 1 (counted from 0): vertex index 3 is out of range, there are 3"),
            std::string::npos);
}

TEST(Surface, NamesTheCreaseThatContradictsItself) {
  TriangleMesh mesh = one_triangle();
  mesh.creases.push_back({{{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}});
  EXPECT_NO_THROW(prepare_surface(mesh));
  mesh.creases.push_back({{{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}}});
  EXPECT_NE(complaint(mesh).find("crease 1 (counted from 0): needs one tangent for each point"),
            std::string::npos);
  mesh.creases[1].tangents.push_back({NAN, 0, 0});
  EXPECT_NE(complaint(mesh).find("crease 1 (counted from 0): has a coordinate that is not finite"),
            std::string::npos);
}

TEST(Surface, RefusesCornerNormalsThatAreNotFinite) {
  TriangleMesh mesh = one_triangle();
  mesh.corner_normals = {{Vector3{0, 0, 1}, Vector3{0, INFINITY, 1}, Vector3{0, 0, 1}}};
  EXPECT_NE(complaint(mesh).find("triangle 0 (counted from 0): has a corner normal"), std::string::npos);
}

}  // namespace
}  // namespace crossgrain
