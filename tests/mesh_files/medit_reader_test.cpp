// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>
#include "crossgrain/error.hpp"
#include "crossgrain/reading.hpp"
#include "files/temporary_folder.hpp"

namespace crossgrain {
namespace {

const std::string kHeader = "MeshVersionFormatted 1\nDimension 3\n";
const std::string kVertices = "Vertices\n4\n0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1 1\n";
const std::string kTets = "Tetrahedra\n1\n1 2 3 4 7\n";

TetMesh read_text(std::string_view content) {
  const TemporaryFolder folder;
  return read_tets(folder.write("a.mesh", content));
}

void expect_corner_tet(const TetMesh& mesh) {
  EXPECT_EQ(mesh.vertices, (std::vector<Vector3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(mesh.tets, (std::vector<std::array<std::uint32_t, 4>>{{0, 1, 2, 3}}));
}

void expect_error(std::string_view content, const std::string& part) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.mesh", content);
  try {
    read_tets(path);
    ADD_FAILURE() << "no error about " << part;
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_TRUE(message.starts_with(path.string())) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(MeditReader, ReadsVerticesAndTets) {
  expect_corner_tet(read_text(kHeader + kVertices + kTets + "End\n"));
}

TEST(MeditReader, TakesTheDimensionOnTheNextLine) {
  expect_corner_tet(read_text(" MeshVersionFormatted\n 2\n Dimension\n 3\n" + kVertices + kTets + "End"));
}

TEST(MeditReader, DoesWithoutHeaderAndEnd) {
  expect_corner_tet(read_text(kVertices + kTets));
  expect_corner_tet(read_text(kVertices + kTets.substr(0, kTets.size() - 1)));
}

TEST(MeditReader, TakesTetsBeforeVertices) {
  expect_corner_tet(read_text(kHeader + kTets + kVertices + "End\n"));
}

TEST(MeditReader, PassesOverCommentsAndEmptyLines) {
  expect_corner_tet(
      read_text("# made by hand\n\nMeshVersionFormatted 1 # old\nDimension 3\n\n"
                "Vertices # four of them\n4\n0 0 0 1 # origin\n\n1 0 0 1\n0 1 0 1\n0 0 1 1\n" +
                kTets));
}

TEST(MeditReader, TakesLineEndsOfAllKinds) {
  for (const std::string end : {"\r\n", "\r", " "}) {
    std::string text = kHeader + kVertices + kTets + "End\n";
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size())
      text.replace(at, 1, end);
    expect_corner_tet(read_text(text));
  }
}

TEST(MeditReader, PassesOverOtherSections) {
  expect_corner_tet(read_text(kHeader + "Triangles\n2\n1 2 3 1\n1 2 4 1\n" + kVertices +
                              "Edges 1 1 2 5\nCorners 2 1 2\nNormals 1 0 0 1\nHexahedra 0\n" + kTets +
                              "RequiredVertices\n1\n4\nEnd\n"));
}

TEST(MeditReader, PassesOverSectionsThatItDoesNotKnow) {
  expect_corner_tet(read_text(kHeader + "AngleOfCornerBound 45.5\nGeometry \"part.geom\"\n" + kVertices +
                              "Wobbles\n2\n1 -2.5 3\n4 5 6e7\n" + kTets));
}

TEST(MeditReader, IgnoresWhatFollowsEnd) {
  expect_corner_tet(read_text(kVertices + kTets + "End\n1 2 3 Vertices"));
}

TEST(MeditReader, TakesReferenceNumbersForTags) {
  const TetMesh mesh =
      read_text(kHeader + "Triangles 1 1 2 3 5\nEdges 1 3 4 -6\n" + kVertices + kTets + "End\n");
  EXPECT_EQ(mesh.regions, std::vector<std::int32_t>{7});
  ASSERT_EQ(mesh.feature_edges.size(), 1u);
  EXPECT_EQ(mesh.feature_edges[0].vertices, (std::array<std::uint32_t, 2>{2, 3}));
  EXPECT_EQ(mesh.feature_edges[0].tag, -6);
  EXPECT_FALSE(mesh.feature_edges[0].is_stated);
  ASSERT_EQ(mesh.feature_faces.size(), 1u);
  EXPECT_EQ(mesh.feature_faces[0].vertices, (std::array<std::uint32_t, 3>{0, 1, 2}));
  EXPECT_EQ(mesh.feature_faces[0].tag, 5);
}

TEST(MeditReader, TakesOnlyEdgesThatAreRidges) {
  const std::string edges = kVertices + kTets + "Edges 3\n1 2 5\n2 3 6\n3 4 7\n";
  const TetMesh mesh = read_text("Ridges 2 3 1\n" + edges);
  ASSERT_EQ(mesh.feature_edges.size(), 2u);
  EXPECT_EQ(mesh.feature_edges[0].tag, 7);
  EXPECT_TRUE(mesh.feature_edges[0].is_stated);
  EXPECT_EQ(mesh.feature_edges[1].tag, 5);
  EXPECT_EQ(read_text(edges + "Ridges 0\n").feature_edges.size(), 3u);
  for (const char* number : {"0", "4"})
    expect_error(edges + "Ridges\n1\n" + number + "\n",
                 fmt::format("a.mesh: line 15: Ridges name edge {}", number));
}

TEST(MeditReader, TakesTheCornersOfCurvedTetsAndWarns) {
  const TetMesh mesh = read_text(kVertices + "TetrahedraP2 1\n1 2 3 4 1 1 1 1 1 1 7\n");
  expect_corner_tet(mesh);
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_NE(mesh.warnings[0].text.find("tets of higher order: 1;"), std::string::npos);
}

TEST(MeditReader, RefusesTagsBeyond32Bits) {
  expect_error(kVertices + "Tetrahedra 1\n1 2 3 4 2147483648\n",
               "a.mesh: line 8: the tag 2147483648 does not fit");
}

TEST(MeditReader, RefusesMoreRowsThanTheFileCanHold) {
  for (const char* count : {"353535235358", "99999999999999999999", "9", "-1", "4.5", "many"}) {
    expect_error(fmt::format("Vertices\n{}\n0 0 0 1\n1 0 0 1\n", count), "a.mesh: line 2: ");
    expect_error(fmt::format("{}Tetrahedra\n{}\n1 2 3 4 1\n", kVertices, count), "a.mesh: line 8: ");
    expect_error(fmt::format("{}Hexahedra\n{}\n1 2 3 4 1\n", kVertices, count), "a.mesh: line 8: ");
  }
}

TEST(MeditReader, RefusesAFileCutShortAnywhere) {
  const std::string text = kHeader + kVertices + kTets;
  // The last four characters are the tet's reference number, whose first digit would do, and blanks around
  // it.
  for (std::size_t size = 1; size < text.size() - 2; ++size) expect_error(text.substr(0, size), "a.mesh:");
}

TEST(MeditReader, NamesTheLineOfAVertexOutOfRange) {
  for (const char* number : {"5", "0", "-1", "4294967297", "1.5", "x"}) {
    const std::string tets = fmt::format("Tetrahedra\n2\n1 2 3 4 0\n1 2 3 {} 0\n", number);
    expect_error(kVertices + tets, "a.mesh: line 10: ");
    expect_error(tets + kVertices, "a.mesh: line 4: ");
  }
}

TEST(MeditReader, RefusesTheLeastNumberOf64BitsForAVertex) {
  expect_error(kHeader + kVertices + "Tetrahedra\n1\n1 2 3 -9223372036854775808 7\n",
               "a tet refers to vertex -9223372036854775808, but they are numbered from 1 to 4");
}

TEST(MeditReader, NamesTheLineOfACoordinateThatIsNoNumber) {
  for (const char* bad : {"nan", "inf", "-1e999", "0,5", "1.0D0"})
    expect_error(fmt::format("Vertices 2\n0 0 0 1\n0 {} 0 1\nTetrahedra 1\n1 1 1 1 1\n", bad),
                 "a.mesh: line 3: ");
}

TEST(MeditReader, RefusesRowsOfAnotherLength) {
  expect_error("Vertices\n3\n0 0 0\n0.5 1 0\n0 1 0\n" + kTets,
               "a.mesh: line 4: '0.5' instead of the reference number");
  expect_error("Vertices\n2\n0 0 0 1\n1 0 0 1\n0 1 0 1\n" + kTets, "after the last row of Vertices");
}

TEST(MeditReader, RefusesOtherSolidElements) {
  const std::string hexahedra = "Hexahedra\n1\n1 2 3 4 1 2 3 4 0\n";
  expect_error(kHeader + kVertices + hexahedra + "End\n", "a.mesh: line 10: hexahedra (1), but only tets");
  expect_error(kHeader + kVertices + kTets + hexahedra + "End\n", "hexahedra (1)");
}

TEST(MeditReader, SaysWhatItMissesInASurfaceMesh) {
  expect_error(kHeader + kVertices + "Triangles\n1\n1 2 3 0\nEnd\n", "1 triangle but no tets");
  expect_error(kHeader + kVertices + "End\n", "no tets");
  expect_error(kHeader + kTets + "End\n", "the section Vertices is missing");
}

TEST(MeditReader, RefusesASecondSectionOfTheSameKind) {
  expect_error(kVertices + kVertices + kTets, "a.mesh: line 8: a second section Vertices");
  expect_error(kVertices + kTets + kTets, "a second section Tetrahedra");
}

TEST(MeditReader, RefusesPlaneMeshesAndOtherFiles) {
  expect_error("MeshVersionFormatted 1\nDimension 2\n" + kVertices, "a.mesh: line 2: ");
  expect_error("cube\n", "not a Medit mesh");
  expect_error(std::string_view("\x01\0\0\0\x03\0\0\0", 8),
               "begins like a Medit mesh in binary (.meshb); rename it");
  expect_error(" \n", "not a Medit mesh");
}

}  // namespace
}  // namespace crossgrain
