// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/medit_files.hpp"

namespace crossgrain {
namespace {

const std::vector<Vector3> kVertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

MadeFile binary(MeditBinaryWriter& out) {
  return {"Medit binary", ".meshb", out.finish()};
}

TEST(MeditBinaryReader, TakesTheCornersOfCurvedTetsAndWarns) {
  MeditBinaryWriter out(2, false);
  out.vertices(kVertices);
  out.section(30, 11, {1, 2, 3, 4, 1, 1, 1, 1, 1, 1, 8});
  const TetMesh mesh = read_made(binary(out));
  EXPECT_EQ(mesh.tets, (std::vector<std::array<std::uint32_t, 4>>{{0, 1, 2, 3}}));
  EXPECT_EQ(mesh.regions, std::vector<std::int32_t>{8});
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_NE(mesh.warnings[0].text.find("tets of higher order: 1;"), std::string::npos);
}

TEST(MeditBinaryReader, TakesOnlyEdgesThatAreRidges) {
  MeditBinaryWriter out(3, false);
  out.section(14, 1, {2});
  out.vertices(kVertices);
  out.section(5, 3, {1, 2, 5, 3, 4, 6});
  out.section(8, 5, {1, 2, 3, 4, 0});
  const TetMesh mesh = read_made(binary(out));
  ASSERT_EQ(mesh.feature_edges.size(), 1u);
  EXPECT_EQ(mesh.feature_edges[0].tag, 6);
}

TEST(MeditBinaryReader, RefusesOtherSolidElements) {
  MeditBinaryWriter out(2, true);
  out.vertices(kVertices);
  out.section(8, 5, {1, 2, 3, 4, 0});
  out.section(10, 9, {1, 2, 3, 4, 1, 2, 3, 4, 0});
  out.section(9, 7, {1, 2, 3, 4, 1, 2, 0, 1, 2, 3, 4, 1, 2, 0});
  expect_tet_error(binary(out),
                   "hexahedra (1) and prisms (2), but only tets can be used; cut the solid into tets");
}

TEST(MeditBinaryReader, NamesTheTetWithAVertexOutOfRange) {
  for (const std::int64_t number : {0, 5, -1}) {
    MeditBinaryWriter out(4, false);
    out.vertices(kVertices);
    out.section(8, 5, {1, 2, 3, 4, 0, 1, 2, 3, number, 0});
    expect_tet_error(
        binary(out),
        fmt::format("tet 1: a tet refers to vertex {}, but they are numbered from 1 to 4", number));
  }
}

TEST(MeditBinaryReader, NamesTheVertexThatIsNoNumber) {
  MeditBinaryWriter out(2, false);
  out.vertices({{0, 0, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 0}});
  expect_tet_error(binary(out), "vertex 1: a coordinate is nan");
}

TEST(MeditBinaryReader, RefusesMoreRowsThanTheFileCanHold) {
  MadeFile file = medit_binary(made_tet_mesh(4, 2), 4, false);
  // Behind the header of 16 + 4 bytes, the keyword and the place of the next: the number of tets.
  for (const std::int64_t count : {std::int64_t{-1}, std::int64_t{1'000'000}, INT64_MAX}) {
    std::memcpy(file.content.data() + 36, &count, sizeof count);
    expect_tet_error(file, "the number of Tetrahedra is");
  }
}

TEST(MeditBinaryReader, RefusesWhatItDoesNotKnow) {
  expect_tet_error({"", ".meshb", std::string("\2\0\0\0\2\0\0\0", 8)}, "does not begin with the number 1");
  expect_tet_error({"", ".meshb", std::string("\1\0\0\0\7\0\0\0", 8)}, "version 7");
  expect_tet_error({"", ".meshb", medit_text(made_tet_mesh()).content},
                   "begins like a Medit mesh (.mesh); rename it");
  MadeFile plane = medit_binary(made_tet_mesh(), 2, false);
  plane.content[16] = 2;
  expect_tet_error(plane, "not a mesh in three dimensions");
}

}  // namespace
}  // namespace crossgrain
