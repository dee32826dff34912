// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/surface_files.hpp"

namespace crossgrain {
namespace {

const std::string kVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

TEST(ObjReader, ReadsTriangles) {
  expect_tetrahedron(read_as("a.obj", kVertices + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"));
}

TEST(ObjReader, ReadsEveryFormOfACorner) {
  expect_tetrahedron(read_as("a.obj", kVertices + "vt 0 0\nvn 0 0 1\nf 1/1 3/1 2/1\nf 1//1 2//1 4//1\n"
                                                  "f 1/1/1 4/1/1 3/1/1\nf 2 3/1 4//1\n"));
}

TEST(ObjReader, CountsNegativeIndicesBackFromTheFace) {
  expect_tetrahedron(read_as("a.obj",
                             "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -1 -2\nv 0 0 1\n"
                             "f -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n"));
}

TEST(ObjReader, TakesFacesBeforeTheirVertices) {
  expect_tetrahedron(read_as("a.obj", "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n" + kVertices));
}

TEST(ObjReader, JoinsLinesThatEndInABackslash) {
  expect_tetrahedron(
      read_as("a.obj", kVertices + "f 1 \\\n 3 2\nf 1 2\\\r\n 4\nf \\\n1 \\\n4 \\\n3\nf 2 3 4\\"));
}

TEST(ObjReader, PassesOverColoursGroupsMaterialsAndComments) {
  expect_tetrahedron(read_as("a.obj",
                             "# f 9 9 9\nmtllib a.mtl\no part\ng side\ns off\nv 0 0 0 1 .5 .5 .5\n"
                             "v 1 0 0 # v 7 7 7\nv\t0 1 0 1.0\n  v 0 0 1\nl 1 2\np 1\nusemtl f\n\n"
                             "f 1 3 2\r\nf 1 2 4   \nf 1 4 3 # back\nf 2 3 4"));
}

TEST(ObjReader, ReadsNumbersAsOtherProgramsWriteThem) {
  const TriangleMesh mesh =
      read_as("a.obj", "v +1.5 -.5 1.E2\nv 1e-400 2. 3E+00\nv 0.1 007 1e-310\nf 1 2 3\n");
  ASSERT_EQ(mesh.vertices.size(), 3u);
  EXPECT_EQ(mesh.vertices[0], (Vector3{1.5, -0.5, 100}));
  EXPECT_EQ(mesh.vertices[1], (Vector3{0, 2, 3}));
  EXPECT_EQ(mesh.vertices[2], (Vector3{0.1, 7, 1e-310}));
}

TEST(ObjReader, CutsPolygons) {
  const TriangleMesh mesh = read_as("a.obj",
                                    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                                    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_DOUBLE_EQ(volume_of(mesh), 1);
}

TEST(ObjReader, NamesTheLineOfAnIndexOutOfRange) {
  for (const char* index : {"5", "-5", "99999999999", "-9223372036854775808", "9223372036854775807"}) {
    const std::string message = input_error_as("a.obj", kVertices + "f 1 2 3\nf 1 2 " + index + "\n");
    EXPECT_NE(message.find("a.obj: line 6: a face refers to vertex "), std::string::npos) << message;
    EXPECT_NE(message.find("numbered 1 to 4"), std::string::npos) << message;
  }
}

TEST(ObjReader, RefusesIndexZero) {
  const std::string message = input_error_as("a.obj", kVertices + "f 0 1 2\n");
  EXPECT_NE(message.find("a.obj: line 5: a face refers to vertex 0"), std::string::npos) << message;
}

TEST(ObjReader, RefusesAVertexOfTwoCoordinates) {
  const std::string message = input_error_as("a.obj", "v 0 0\nv 1 0 0\n");
  EXPECT_NE(message.find("a.obj: line 1: a coordinate is missing"), std::string::npos) << message;
}

TEST(ObjReader, RefusesPointsWithoutFaces) {
  const std::string message = input_error_as("a.obj", kVertices);
  EXPECT_NE(message.find("no triangles"), std::string::npos) << message;
}

TEST(ObjReader, KeepsATriangleWithoutArea) {
  EXPECT_EQ(read_as("a.obj", kVertices + "f 1 2 2\nf 1 2 3\n").triangles.size(), 2u);
}

}  // namespace
}  // namespace crossgrain
