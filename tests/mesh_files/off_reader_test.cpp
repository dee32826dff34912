// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/surface_files.hpp"

namespace crossgrain {
namespace {

const std::string kVertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string kFaces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

TEST(OffReader, ReadsTriangles) {
  expect_tetrahedron(read_as("a.off", "OFF\n4 4 6\n" + kVertices + kFaces));
}

TEST(OffReader, ReadsCountsOnTheLineOfTheKeyword) {
  expect_tetrahedron(read_as("a.off", "OFF 4 4 6\n" + kVertices + kFaces));
  expect_tetrahedron(read_as("a.off", "  \t OFF4 4 6 # or so\n" + kVertices + kFaces));
}

TEST(OffReader, DoesWithoutTheKeywordAndTheNumberOfEdges) {
  expect_tetrahedron(read_as("a.off", "4 4\n" + kVertices + kFaces));
}

TEST(OffReader, PassesOverCommentsAndEmptyLines) {
  expect_tetrahedron(
      read_as("a.off", "# made by hand\nOFF\n\n# counts\n4 4 6\n\n" + kVertices + "# faces\n\n" + kFaces));
}

TEST(OffReader, PassesOverColoursAndNormals) {
  expect_tetrahedron(read_as("a.off",
                             "COFF\n4 4 6\n0 0 0 255 0 0 255\n1 0 0 0 0 0 0\n0 1 0 1 1 1 1\n0 0 1 9 9 9 9\n"
                             "3 0 2 1  255 0 0\n3 0 1 3 1.0 .5 .5 1\n3 0 3 2\n3 1 2 3 7\n"));
  expect_tetrahedron(
      read_as("a.off", "STCNOFF\n4 4 6\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n0 0 1 0 0 1\n" + kFaces));
}

TEST(OffReader, RefusesCountsThatTheFileCannotHold) {
  for (const char* counts : {"353535235358 4 0", "4 353535235358 0", "99999999999999999999 4 0", "-1 4 0"}) {
    const std::string message =
        input_error_as("a.off", std::string("OFF\n") + counts + "\n" + kVertices + kFaces);
    EXPECT_NE(message.find("a.off: line 2: "), std::string::npos) << message;
  }
}

TEST(OffReader, RefusesACornerCountThatTheFileCannotHold) {
  input_error_as("a.off", "OFF\n4 4 6\n" + kVertices + "353535235358 0 2 1\n");
}

TEST(OffReader, NamesTheLineOfAnIndexOutOfRange) {
  const std::string message = input_error_as("a.off", "OFF\n4 2 6\n" + kVertices + "3 0 2 1\n3 0 1 4\n");
  EXPECT_NE(message.find("a.off: line 8: a face refers to vertex 4"), std::string::npos) << message;
}

TEST(OffReader, RefusesAFileCutShort) {
  const std::string text = "OFF\n4 4 6\n" + kVertices + kFaces;
  input_error_as("a.off", text.substr(0, text.size() - 4));
  input_error_as("a.off", text.substr(0, 20));
  input_error_as("a.off", "OFF\n4");
}

TEST(OffReader, RefusesOtherDimensionsAndBinary) {
  input_error_as("a.off", "4OFF\n4 4 6\n" + kVertices + kFaces);
  input_error_as("a.off", "OFF BINARY\n1234");
}

}  // namespace
}  // namespace crossgrain
