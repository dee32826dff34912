// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/vtk_files.hpp"

namespace crossgrain {
namespace {

/// A grid of one cell on the points of a made mesh.
MadeFile one_cell(int type, const std::vector<std::int64_t>& nodes, const VtuEncoding& encoding = {"ascii"}) {
  const TetMesh mesh = made_tet_mesh();
  VtuFileWriter out(encoding);
  out.text(fmt::format("<UnstructuredGrid><Piece NumberOfPoints=\"{}\" NumberOfCells=\"1\">\n<Points>\n",
                       mesh.vertices.size()));
  out.array<float>("Float32", "Points", 3, VtkGrid(mesh).points);
  out.text("</Points><Cells>\n");
  out.array<std::int64_t>("Int64", "connectivity", 1, nodes);
  out.array<std::int64_t>("Int64", "offsets", 1, std::vector<std::size_t>{nodes.size()});
  out.array<std::uint8_t>("UInt8", "types", 1, std::vector<int>{type});
  out.text("</Cells></Piece></UnstructuredGrid>\n");
  return {"VTU", ".vtu", out.finish()};
}

MadeFile replaced(MadeFile file, const std::string& from, const std::string& to) {
  const std::size_t at = file.content.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  file.content.replace(at, from.size(), to);
  return file;
}

TEST(VtuTetReader, TakesTheCornersOfCurvedTetsAndWarns) {
  const TetMesh mesh = read_made(one_cell(24, {3, 2, 1, 0, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(mesh.tets, (std::vector<std::array<std::uint32_t, 4>>{{3, 2, 1, 0}}));
  EXPECT_TRUE(mesh.regions.empty());
  EXPECT_EQ(mesh.warnings.size(), 1u);
}

TEST(VtuTetReader, RefusesGridsWithoutTets) {
  expect_tet_error(one_cell(12, {0, 1, 2, 3, 4, 5, 6, 7}), "hexahedra (1), but only tets can be used");
  expect_tet_error(one_cell(5, {0, 1, 2}), "1 triangle but no tets");
  expect_tet_error(one_cell(7, {0, 1, 2, 3, 4}), "no tets");
}

TEST(VtuTetReader, NamesTheLineOfTextAndTheCellOfOtherEncodings) {
  expect_tet_error(one_cell(10, {0, 1, 2, 12}),
                   "10: a tet refers to vertex 12, but they are numbered from 0 to 11");
  expect_tet_error(one_cell(10, {0, 1, 2, 12}, {"raw"}), " cell 0: a tet refers to vertex 12");
}

TEST(VtuTetReader, RefusesWrongCounts) {
  const MadeFile text = one_cell(10, {0, 1, 2, 3}), raw = one_cell(10, {0, 1, 2, 3}, {"raw"});
  for (const char* count : {"13", "1000000", "18446744073709551615", "-1", ""}) {
    const std::string stated = fmt::format("NumberOfPoints=\"{}\"", count);
    EXPECT_NE(error_of_reading_tets(replaced(text, "NumberOfPoints=\"12\"", stated)), "") << count;
    EXPECT_NE(error_of_reading_tets(replaced(raw, "NumberOfPoints=\"12\"", stated)), "") << count;
  }
  expect_tet_error(replaced(raw, "NumberOfCells=\"1\"", "NumberOfCells=\"2\""),
                   "array 'offsets' has 1 number instead of 2");
  expect_tet_error(one_cell(10, {0, 1, 2}), "a cell of type 10 (tets) has 3 points");
}

TEST(VtuTetReader, RefusesPackingsThatItDoesNotKnow) {
  const MadeFile file = vtu(made_tet_mesh(), {"base64", true});
  expect_tet_error(replaced(file, "vtkZLib", "vtkLZ4"),
                   "2: compressed by 'vtkLZ4DataCompressor', but only zlib can be read; export it again");
  expect_tet_error(replaced(file, "encoding=\"base64\"", "encoding=\"hex\""), "appended data in 'hex'");
  expect_tet_error(replaced(file, "\"UnstructuredGrid\"", "\"PolyData\""),
                   "2: a VTK file of type 'PolyData'");
}

TEST(VtuTetReader, RefusesASecondPieceWithCells) {
  expect_tet_error(replaced(vtu(made_tet_mesh(), {"ascii"}), "NumberOfPoints=\"0\" NumberOfCells=\"0\"",
                            "NumberOfPoints=\"4\" NumberOfCells=\"1\""),
                   "a second piece with cells; merge the pieces");
}

TEST(VtuTetReader, KnowsAFrameFieldOfItsOwn) {
  expect_tet_error(
      replaced(one_cell(11, {0, 1, 2, 3, 4, 5, 6, 7}), "<UnstructuredGrid>",
               "<UnstructuredGrid><FieldData><DataArray type=\"UInt32\" Name=\"crossgrain_schema\" "
               "format=\"ascii\">1</DataArray></FieldData>"),
      "a frame field written by crossgrain, not a mesh");
}

TEST(VtuTetReader, RefusesBase64ThatIsNone) {
  const MadeFile file = vtu(made_tet_mesh(), {"binary"});
  std::string broken = file.content;
  const std::size_t at = broken.find("format=\"binary\">", broken.find("<Points>")) + 20;
  broken[at] = '!';
  expect_tet_error({"", ".vtu", broken}, "array 'Points' is damaged or cut short");
}

TEST(VtuTetReader, TakesBlanksAroundTheSignBetweenAnAttributeAndItsValue) {
  MadeFile file = one_cell(10, {0, 1, 2, 3});
  std::size_t count = 0;
  for (std::size_t at = 0; (at = file.content.find("=\"", at)) != std::string::npos; at += 4, ++count)
    file.content.replace(at, 2, " =\n\"");
  EXPECT_GT(count, 10u);
  EXPECT_EQ(read_made(file).tets.size(), 1u);
}

TEST(VtuTetReader, NamesTheLineOfATagThatIsNoXml) {
  const MadeFile file = one_cell(10, {0, 1, 2, 3});
  const std::size_t at = file.content.find("Name=\"offsets\"");
  const std::string before = file.content.substr(0, at);
  const std::string expected = fmt::format("{}: not XML, or cut short inside a tag",
                                           1 + std::count(before.begin(), before.end(), '\n'));
  expect_tet_error(replaced(file, "Name=\"offsets\"", "Name=offsets"), expected);
  expect_tet_error({"", ".vtu", before + "Name="}, expected);
}

TEST(VtuTetReader, RefusesOtherXml) {
  expect_tet_error({"", ".vtu", "<?xml version=\"1.0\"?>\n<svg></svg>"}, "begins like an XML file");
  expect_tet_error({"", ".vtu", "<VTKFile type=\"UnstructuredGrid\">"}, "<Piece> with cells is missing");
  expect_tet_error({"", ".vtu", "anything"}, "this is not a VTK XML file");
}

}  // namespace
}  // namespace crossgrain
