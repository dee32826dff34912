// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/gmsh_files.hpp"

namespace crossgrain {
namespace {

const std::string kFormat2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string kNodes2 = "$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n9 2 2 2\n$EndNodes\n";
const std::string kFormat4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
const std::string kNodes4 = "$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n";

MadeFile text(const std::string& content) {
  return {"Gmsh text", ".msh", content};
}

std::string elements_2(const std::vector<std::string>& rows) {
  std::string out = fmt::format("$Elements\n{}\n", rows.size());
  for (const std::string& row : rows) out += row + "\n";
  return out + "$EndElements\n";
}

TEST(GmshReader, TakesThePhysicalTagAndElseTheEntity) {
  const TetMesh mesh = read_made(text(kFormat2 + kNodes2 +
                                      elements_2({"1 4 2 7 1 1 2 3 4", "2 4 2 0 5 1 2 3 9", "3 4 0 1 2 4 9",
                                                  "4 1 2 -3 1 1 2", "5 1 2 0 8 1 3"})));
  EXPECT_EQ(mesh.regions, (std::vector<std::int32_t>{7, 5, 0}));
  EXPECT_EQ(mesh.tets[1], (std::array<std::uint32_t, 4>{0, 1, 2, 4}));
  EXPECT_EQ(mesh.feature_edges[0].tag, 3);
  EXPECT_TRUE(mesh.feature_edges[0].is_stated);
  EXPECT_EQ(mesh.feature_edges[1].tag, 8);
  EXPECT_FALSE(mesh.feature_edges[1].is_stated);
}

TEST(GmshReader, TakesTheCornersOfCurvedTetsAndWarns) {
  const TetMesh mesh =
      read_made(text(kFormat2 + kNodes2 + elements_2({"1 11 2 0 1 1 2 3 4 9 9 9 9 9 9", "2 8 2 0 1 1 2 9"})));
  EXPECT_EQ(mesh.tets, (std::vector<std::array<std::uint32_t, 4>>{{0, 1, 2, 3}}));
  EXPECT_EQ(mesh.feature_edges.size(), 1u);
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_NE(mesh.warnings[0].text.find("tets of higher order: 1;"), std::string::npos);
}

TEST(GmshReader, PassesOverSectionsThatItHasNoUseFor) {
  const TetMesh mesh =
      read_made(text(kFormat4 + "$PartitionedEntities\nanything $Nodes\n$EndPartitionedEntities\n" + kNodes4 +
                     "$Periodic\n0\n$EndPeriodic\n$Elements\n1 1 1 1\n3 6 4 1\n" +
                     "1 1 2 3 4\n$EndElements\n$NodeData\n1\n$EndNodeData"));
  EXPECT_EQ(mesh.regions, std::vector<std::int32_t>{6});
}

TEST(GmshReader, RefusesOtherSolidElements) {
  expect_tet_error(text(kFormat2 + kNodes2 +
                        elements_2({"1 4 2 0 1 1 2 3 4", "2 6 2 0 1 1 2 3 4 9 9", "3 7 2 0 1 1 2 3 4 9",
                                    "4 6 2 0 1 1 2 3 4 9 9"})),
                   "15: prisms (2) and pyramids (1), but only tets can be used; cut the solid into tets");
}

TEST(GmshReader, SaysWhatItMissesInASurfaceMesh) {
  expect_tet_error(text(kFormat2 + kNodes2 + elements_2({"1 2 2 0 1 1 2 3"})), "1 triangle but no tets");
  expect_tet_error(text(kFormat2 + kNodes2 + elements_2({})), "no tets");
}

TEST(GmshReader, SaysHowToSaveOtherVersionsAgain) {
  for (const char* version : {"4.0", "4", "1", "3", "5.2"})
    expect_tet_error(
        text(fmt::format("$MeshFormat\n{} 0 8\n$EndMeshFormat\n", version)),
        fmt::format("2: MSH '{}' has no reader, only 2.2 and 4.1 (to convert: gmsh -save -format msh41 ",
                    version));
  expect_tet_error(text("$NOD\n1\n1 0 0 0\n$ENDNOD\n"), "MSH '1'");
}

TEST(GmshReader, NamesTheLineOfANodeThatIsMissing) {
  for (const char* node : {"5", "0", "-1", "99999999999"})
    expect_tet_error(
        text(kFormat2 + kNodes2 + elements_2({"1 4 2 0 1 1 2 3 4", fmt::format("2 4 2 0 1 1 2 3 {}", node)})),
        fmt::format("15: refers to node {}, which the file does not have", node));
}

TEST(GmshReader, NamesTheElementOfABinaryFile) {
  TetMesh mesh = made_tet_mesh(4, 2);
  mesh.tets[1][3] = 4;
  // A point, three edges and four triangles come before the tets.
  for (const MadeFile& file :
       {gmsh_2(mesh, {.binary = true}), gmsh_4(mesh, {.binary = true, .swapped = true})})
    expect_tet_error(file, "element 9: refers to node 5, which the file does not have");
}

TEST(GmshReader, RefusesTwoNodesOfOneNumber) {
  expect_tet_error(text(kFormat2 + "$Nodes\n2\n7 0 0 0\n7 1 0 0\n$EndNodes\n"),
                   "two nodes have the number 7");
}

TEST(GmshReader, RefusesWrongCounts) {
  for (const char* count : {"6", "1000000", "9223372036854775807", "-1", "x"})
    expect_tet_error(text(kFormat2 + "$Nodes\n" + count + "\n1 0 0 0\n2 1 0 0\n$EndNodes\n"), ": ");
  expect_tet_error(text(kFormat2 + "$Nodes\n1\n1 0 0 0\n2 1 0 0\n$EndNodes\n"), "'2' instead of '$EndNodes'");
  expect_tet_error(
      text(kFormat4 + "$Nodes\n1 5 1 5\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n"),
      "nodes: 5 announced and 4 here");
  expect_tet_error(text(kFormat4 + kNodes4 + "$Elements\n1 2 1 1\n3 6 4 1\n1 1 2 3 4\n$EndElements\n"),
                   "elements: 2 announced and 1 here");
  expect_tet_error(
      text(kFormat4 + kNodes4 + "$Elements\n1 1 1 1\n3 6 4 1000000000000\n1 1 2 3 4\n$EndElements\n"),
      "the number of elements of an entity is 1000000000000, but the rest");
}

TEST(GmshReader, RefusesWhatIsCutShortBetweenSections) {
  expect_tet_error(text(kFormat4), "the section $Nodes is missing");
  expect_tet_error(text(kFormat4 + kNodes4), "the section $Elements is missing");
  expect_tet_error(text(kFormat4 + kNodes4 + "$NodeData\n1\n"), "'$NodeData' has no '$EndNodeData'");
}

TEST(GmshReader, ShowsNamesOfSectionsAsOnePrintableLine) {
  expect_tet_error(text(kFormat4 + "$\x1b[2J\n"), "'$?[2J' has no '$End?[2J'");
  expect_tet_error(text(kFormat4 + "$" + std::string(1000, 'a') + "\n"),
                   "'$" + std::string(31, 'a') + "...'");
}

TEST(GmshReader, TakesAnyNumberOf64BitsForAPhysicalGroup) {
  expect_tet_error(
      text(kFormat2 + kNodes2 + "$Elements\n1\n1 4 2 -9223372036854775808 1 1 2 3 4\n$EndElements\n"),
      "the tag -9223372036854775808 does not fit into 32 bits");
}

TEST(GmshReader, RefusesElementsOfUnknownTypes) {
  expect_tet_error(text(kFormat2 + kNodes2 + elements_2({"1 77 2 0 1 1 2 3 4"})),
                   "elements of unknown type 77");
}

}  // namespace
}  // namespace crossgrain
