// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/vtk_files.hpp"

namespace crossgrain {
namespace {

const std::string kHeader = "# vtk DataFile Version 3.0\nmade\nASCII\nDATASET UNSTRUCTURED_GRID\n";
const std::string kPoints = "POINTS 5 float\n0 0 0 1 0 0 0 1 0\n0 0 1 2 2 2\n";

MadeFile text(const std::string& content) {
  return {"VTK text", ".vtk", content};
}

const std::string kTwoTets = kHeader + kPoints + "CELLS 2 10\n4 0 1 2 3\n4 0 1 2 4\nCELL_TYPES 2\n10\n10\n";

TEST(VtkReader, LeavesRegionsEmptyWhereThereAreNoTags) {
  const TetMesh mesh = read_made(text(kTwoTets));
  EXPECT_EQ(mesh.tets.size(), 2u);
  EXPECT_TRUE(mesh.regions.empty());
}

TEST(VtkReader, PrefersCertainNamesForTags) {
  const auto regions = [](const std::string& data) {
    return read_made(text(kTwoTets + "CELL_DATA 2\n" + data)).regions;
  };
  const std::string any = "SCALARS any int\nLOOKUP_TABLE default\n1 2\n", late = "SCALARS late int\n3 4\n",
                    region = "SCALARS Region short 1\nLOOKUP_TABLE default\n5 6\n",
                    ids = "FIELD f 1\nCellEntityIds 1 2 vtkIdType\n7 8\n";
  EXPECT_EQ(regions(any + late), (std::vector<std::int32_t>{1, 2}));
  EXPECT_EQ(regions(any + region), (std::vector<std::int32_t>{5, 6}));
  EXPECT_EQ(regions(any + ids + region), (std::vector<std::int32_t>{7, 8}));
  EXPECT_TRUE(regions("SCALARS region float\nLOOKUP_TABLE default\n1 2\n").empty());
  EXPECT_TRUE(regions("SCALARS vtkGhostType int\nLOOKUP_TABLE default\n1 2\n").empty());
}

TEST(VtkReader, TakesNoPointDataForTags) {
  EXPECT_TRUE(
      read_made(text(kTwoTets + "POINT_DATA 5\nSCALARS region int\nLOOKUP_TABLE default\n1 2 3 4 5\n"))
          .regions.empty());
}

TEST(VtkReader, PassesOverAttributesOfAllKinds) {
  const TetMesh mesh = read_made(text(
      kHeader + "FIELD FieldData 1\nTIME 1 1 double\n0.5\n" + kTwoTets.substr(kHeader.size()) +
      "POINT_DATA 5\nNORMALS n float\n0 0 1 0 0 1 0 0 1 0 0 1 0 0 1\nTEXTURE_COORDINATES t 2 float\n"
      "0 0 0 0 0 0 0 0 0 0\nCELL_DATA 2\nCOLOR_SCALARS c 3\n0 0 0 1 1 1\nLOOKUP_TABLE table 1\n0 0 0 1\n"
      "SCALARS flag bit\nLOOKUP_TABLE default\n0 1\nTENSORS t double\n1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9\n"
      "METADATA\nCOMPONENT_NAMES\nXX\n\nGLOBAL_IDS g vtkIdType\n8 9\nSCALARS tag int\nLOOKUP_TABLE "
      "default\n3 4\n"));
  EXPECT_EQ(mesh.regions, (std::vector<std::int32_t>{3, 4}));
  EXPECT_TRUE(mesh.warnings.empty());
}

TEST(VtkReader, WarnsOfDataThatItCannotPassOver) {
  const TetMesh mesh = read_made(text(kTwoTets + "CELL_DATA 2\nFIELD f 1\nname 1 2 string\none\ntwo\n"));
  EXPECT_EQ(mesh.tets.size(), 2u);
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_NE(mesh.warnings[0].text.find("'string'"), std::string::npos);
}

TEST(VtkReader, TakesTheCornersOfCurvedTetsAndWarns) {
  const TetMesh mesh =
      read_made(text(kHeader + kPoints + "CELLS 1 11\n10 0 1 2 3 4 4 4 4 4 4\nCELL_TYPES 1\n24\n"));
  EXPECT_EQ(mesh.tets, (std::vector<std::array<std::uint32_t, 4>>{{0, 1, 2, 3}}));
  EXPECT_EQ(mesh.warnings.size(), 1u);
}

TEST(VtkReader, RefusesOtherSolidElements) {
  expect_tet_error(
      text(kHeader + kPoints + "CELLS 2 14\n4 0 1 2 3\n8 0 1 2 3 0 1 2 3\nCELL_TYPES 2\n10\n12\n"),
      "10: hexahedra (1), but only tets can be used; put them onto a model as they are");
}

TEST(VtkReader, RefusesCellsOfAnotherSizeOrUnknownType) {
  expect_tet_error(text(kHeader + kPoints + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n10\n"),
                   "9: a cell of type 10 (tets) has 3 points");
  expect_tet_error(text(kHeader + kPoints + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n99\n"),
                   "11: cell 0 has the unknown type 99");
}

TEST(VtkReader, NamesTheLineOfAPointOutOfRange) {
  for (const char* number : {"5", "-1", "4294967296"})
    expect_tet_error(
        text(kHeader + kPoints + fmt::format("CELLS 1 5\n4 0 1 2 {}\nCELL_TYPES 1\n10\n", number)),
        fmt::format("9: a tet refers to vertex {}, but they are numbered from 0 to 4", number));
}

TEST(VtkReader, NamesTheCellOfABinaryFile) {
  TetMesh mesh = made_tet_mesh(4, 2);
  mesh.tets[1][3] = 4;
  for (const char* version : {"4.2", "5.1"})
    expect_tet_error(vtk_legacy<double>(mesh, version, true), "cell 9: a tet refers to vertex 4");
}

TEST(VtkReader, RefusesWrongCounts) {
  for (const char* count : {"1000000", "9223372036854775807", "-1", "x"}) {
    expect_tet_error(text(kHeader + "POINTS " + count + " float\n0 0 0\n"), "5: ");
    expect_tet_error(text(kHeader + kPoints + "CELLS 1 " + count + "\n4 0 1 2 3\n"), "8: ");
  }
  expect_tet_error(text(kHeader + kPoints + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 2\n10 10\n"),
                   "1 CELLS and 2 CELL_TYPES");
  expect_tet_error(text(kTwoTets + "CELL_DATA 3\nSCALARS tag int\nLOOKUP_TABLE default\n1 2 3\n"),
                   "3 rows of cell data for 2 cells");
}

TEST(VtkReader, ShowsNamesOfArraysAsOnePrintableLine) {
  expect_tet_error(text(kTwoTets + "CELL_DATA 40\nSCALARS \x1b[2J int\nLOOKUP_TABLE default\n1 2\n"),
                   "'?[2J' should have 40 numbers");
}

TEST(VtkReader, RefusesOtherDataSetsAndFiles) {
  expect_tet_error(text("# vtk DataFile Version 3.0\nmade\nASCII\nDATASET POLYDATA\n"),
                   "4: DATASET 'POLYDATA', but a mesh must be an UNSTRUCTURED_GRID");
  expect_tet_error(text("# vtk DataFile Version 7.0\nmade\nASCII\n"),
                   "the version cannot be read, unlike 4.2 and 5.1; export it again");
  expect_tet_error(text("anything\n"), "this is not a VTK file");
  expect_tet_error(text(kHeader), "POINTS is missing");
  expect_tet_error(text(kHeader + kPoints), "CELLS is missing");
}

TEST(VtkReader, SaysWhatItMissesInASurfaceMesh) {
  expect_tet_error(text(kHeader + kPoints + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n"),
                   "1 triangle but no tets");
}

}  // namespace
}  // namespace crossgrain
