// SPDX-License-Identifier: Apache-2.0
// Files of hexahedra of any mesher, read.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <tuple>

#include "crossgrain/error.hpp"
#include "crossgrain/writing.hpp"
#include "files/temporary_folder.hpp"
#include "measure/hex_quality.hpp"
#include "mesh_files/hex/hex_reader.hpp"
#include "mesh_files/made_bricks.hpp"

namespace crossgrain {
namespace {

using Solid = std::pair<std::int32_t, std::array<Vector3, 8>>;
using Side = std::pair<std::int32_t, std::array<Vector3, 4>>;

/// Hexahedra by region and places of their corners, whatever the order in the file.
std::vector<Solid> solids_of(const HexMesh& mesh) {
  std::vector<Solid> solids;
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h) {
    solids.emplace_back(mesh.regions.empty() ? 0 : mesh.regions[h], std::array<Vector3, 8>());
    for (std::size_t k = 0; k < 8; ++k) solids.back().second[k] = mesh.vertices[mesh.hexahedra[h][k]];
  }
  std::ranges::sort(solids);
  return solids;
}

std::vector<Side> sides_of(const HexMesh& mesh) {
  std::vector<Side> sides;
  for (const HexMesh::Face& face : mesh.boundary) {
    sides.emplace_back(face.tag, std::array<Vector3, 4>());
    for (std::size_t k = 0; k < 4; ++k) sides.back().second[k] = mesh.vertices[face.vertices[k]];
    std::ranges::sort(sides.back().second);
  }
  std::ranges::sort(sides);
  return sides;
}

double volume_of(const HexMesh& mesh) {
  const std::vector<double> volumes = volumes_of(mesh);
  return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

HexMesh read_text(const char* name, const std::string& text) {
  const TemporaryFolder folder;
  return read_hexahedra_file(folder.write(name, text));
}

std::string error_of(const char* name, const std::string& text) {
  try {
    read_text(name, text);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput) << error.what();
    return error.what();
  }
  return "";
}

void expect_error(const char* name, const std::string& text, const std::string& words) {
  EXPECT_NE(error_of(name, text).find(words), std::string::npos) << error_of(name, text);
}

/// A cube as an input file: "*ELEMENT, TYPE=C3D8" with these rows.
std::string cube_in_abaqus(const std::string& elements) {
  return "** made\n*Heading\n a cube\n*NODE, NSET=ALL\n10, 0, 0, 0\n20, 1, 0, 0\n30, 1, 1\n40, 0, 1,\n"
         "50, 0, 0, 1\n60, 1., 0., 1.\n70, 1, 1, 1e0\n80, 0, 1, 1\n99, 7, 7, 7\n" +
         elements;
}

constexpr const char* kCube = "*Element, type=C3D8R, elset=Volume1\n1, 10, 20, 30, 40, 50, 60, 70, 80\n";

TEST(HexReader, RestoresWhatIsWrittenInEachFormat) {
  const TemporaryFolder folder;
  HexMesh mesh = made_bricks({4, 3, 2}, {4, 3, 0.1});
  mesh.boundary[3].tag = -7;
  for (const char* name : {"a.vtu", "a.mesh", "a.msh", "a.inp"}) {
    write_hexahedra(mesh, folder.path() / name);
    const HexMesh read = read_hexahedra_file(folder.path() / name);
    if (name == std::string("a.msh")) {
      // Groups of Gmsh have positive numbers: the smallest that is free.
      HexMesh numbered = mesh;
      numbered.boundary[3].tag = 1;
      EXPECT_EQ(sides_of(read), sides_of(numbered)) << name;
    } else {
      EXPECT_EQ(sides_of(read), sides_of(mesh)) << name;
    }
    EXPECT_EQ(solids_of(read), solids_of(mesh)) << name;
    EXPECT_TRUE(read.warnings.empty()) << name;
  }
}

TEST(HexReader, KeepsNoRegionsWhereTheFileHasNone) {
  const TemporaryFolder folder;
  HexMesh mesh = made_bricks({2, 1, 1}, {2, 1, 1});
  mesh.regions.clear();
  for (const char* name : {"a.mesh", "a.inp"}) {
    write_hexahedra(mesh, folder.path() / name);
    EXPECT_TRUE(read_hexahedra_file(folder.path() / name).regions.empty()) << name;
  }
}

/// Runs make_hex_files.py, which writes meshes of a beam with a program, and reads all of them.
void expect_read_from(const char* program) {
  const TemporaryFolder folder;
  const std::string command =
      fmt::format("/usr/bin/python3 {}/mesh_files/make_hex_files.py {} {} > /dev/null",
                  CROSSGRAIN_TESTS_FOLDER, program, folder.path().string());
  constexpr int kNotInstalled = 77;
  const int code = WEXITSTATUS(std::system(command.c_str()));
  if (code == kNotInstalled) GTEST_SKIP() << program << " is not installed";
  ASSERT_EQ(code, 0);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".geo")) continue;
    ++files;
    SCOPED_TRACE(name);
    const HexMesh mesh = read_hexahedra_file(entry.path());
    EXPECT_EQ(mesh.hexahedra.size(), 12u);
    EXPECT_EQ(mesh.vertices.size(), 36u);
    EXPECT_EQ(mesh.boundary.size(), 2u * (3 * 2 + 2 * 2 + 3 * 2));
    EXPECT_NEAR(volume_of(mesh), 6, 1e-9);
    EXPECT_EQ(topology_of(mesh).open_edges, 0u);
    EXPECT_EQ(name.starts_with("curved"), !mesh.warnings.empty());
    for (const Warning& warning : mesh.warnings) EXPECT_EQ(warning.kind, WarningKind::kSkippedData);
    if (name.starts_with("tagged")) {
      EXPECT_EQ(std::ranges::count(mesh.boundary, 5, &HexMesh::Face::tag), 6) << "quads of group 5";
    }
  }
  EXPECT_GE(files, 8u);
}

TEST(HexReader, ReadsWhatMeshioWrites) {
  expect_read_from("meshio");
}

TEST(HexReader, ReadsWhatGmshWrites) {
  expect_read_from("gmsh");
}

TEST(HexReader, ReadsCubesOfImages) {
  const HexMesh mesh = read_text("a.vtk",
                                 "# vtk DataFile Version 3.0\nmade\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                                 "POINTS 8 float\n0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1\n"
                                 "CELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n11\n");
  EXPECT_DOUBLE_EQ(volume_of(mesh), 1);
  EXPECT_DOUBLE_EQ(scaled_jacobians(mesh)[0], 1);
}

TEST(HexReader, TurnsLeftHandedHexahedraOver) {
  const TemporaryFolder folder;
  const HexMesh mesh = made_bricks({3, 2, 2}, {3, 2, 2});
  const auto turn = [](auto& corners) {
    std::swap_ranges(corners.begin(), corners.begin() + 4, corners.begin() + 4);
  };
  for (const std::size_t left_handed : {std::size_t{12}, std::size_t{5}}) {
    HexMesh turned = mesh;
    for (std::size_t h = 0; h < left_handed; ++h) turn(turned.hexahedra[h]);
    write_hexahedra(turned, folder.path() / "a.mesh", {}, InvertedHexahedra::kAllowed);
    const HexMesh read = read_hexahedra_file(folder.path() / "a.mesh");
    EXPECT_EQ(read.hexahedra, mesh.hexahedra) << left_handed;
    ASSERT_EQ(read.warnings.size(), 1u);
    EXPECT_EQ(read.warnings[0].kind, WarningKind::kInvertedTets);
    EXPECT_EQ(read.warnings[0].text,
              fmt::format("{} hexahedra are left-handed in the file, and turned over", left_handed));
    EXPECT_EQ(topology_of(read).crowded_faces, 0u);
  }
}

TEST(HexReader, LeavesAHexahedronThatIsFoldedAmongOthersAsItIs) {
  const TemporaryFolder folder;
  HexMesh mesh = made_bricks({3, 3, 3}, {3, 3, 3});
  // All vertices of the middle one are exchanged with those opposite.
  const auto middle = mesh.hexahedra[13];
  for (std::size_t k = 0; k < 4; ++k)
    std::swap(mesh.vertices[middle[k]], mesh.vertices[middle[(k + 2) % 4 + 4]]);
  write_hexahedra(mesh, folder.path() / "a.mesh", {}, InvertedHexahedra::kAllowed);
  const HexMesh read = read_hexahedra_file(folder.path() / "a.mesh");
  EXPECT_LT(volumes_of(read)[13], 0);
  EXPECT_EQ(read.hexahedra, mesh.hexahedra);
  EXPECT_TRUE(read.warnings.empty());
}

TEST(HexReader, LeavesOutVerticesOfNoHexahedronAndQuadsInside) {
  const HexMesh mesh = read_text("a.mesh",
                                 "MeshVersionFormatted 2\nDimension 3\nVertices 13\n9 9 9 0\n"
                                 "0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n0 0 1 0\n1 0 1 0\n1 1 1 0\n0 1 1 0\n"
                                 "0 0 2 0\n1 0 2 0\n1 1 2 0\n0 1 2 0\n"
                                 "Hexahedra 2\n2 3 4 5 6 7 8 9 4\n6 7 8 9 10 11 12 13 5\n"
                                 "Quadrilaterals 3\n6 7 8 9 1\n2 3 4 5 8\n1 2 3 4 9\nEnd\n");
  EXPECT_EQ(mesh.vertices.size(), 12u);
  EXPECT_EQ(mesh.hexahedra[0], (std::array<std::uint32_t, 8>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(mesh.regions, (std::vector<std::int32_t>{4, 5}));
  ASSERT_EQ(mesh.boundary.size(), 10u);
  for (const HexMesh::Face& face : mesh.boundary) {
    const bool is_bottom = std::ranges::all_of(face.vertices, [](std::uint32_t v) { return v < 4; });
    EXPECT_EQ(face.tag, is_bottom ? 8 : 0);
  }
}

TEST(HexReader, RefusesMeshesWithOtherSolidsAndCountsThem) {
  expect_error(
      "a.mesh",
      "Vertices 8\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n0 0 1 0\n1 0 1 0\n1 1 1 0\n0 1 1 0\n"
      "Hexahedra 1\n1 2 3 4 5 6 7 8 0\nTetrahedra 2\n1 2 3 5 0\n1 2 3 6 0\nPrisms 1\n1 2 3 5 6 7 0\nEnd\n",
      "tets (2) and prisms (1), but only hexahedra can be used; mesh the part again");
  expect_error("a.inp", cube_in_abaqus("*ELEMENT, TYPE=C3D6\n1,10,20,30,50,60,70\n"),
               "line 15: wedges (1), but only hexahedra can be used");
  expect_error("a.mesh", "Vertices 1\n0 0 0 0\nEnd\n", "the file has no hexahedra; export it again");
  expect_error("a.stl", "solid\n", "no reader for hexahedra in '.stl' files, only in .mesh, .meshb, .msh");
  expect_error("a.inp", "$MeshFormat\n2.2 0 8\n", "is named .inp but begins like a Gmsh mesh (.msh)");
}

TEST(HexReader, RefusesHexahedraWithACornerTwice) {
  expect_error(
      "a.inp",
      cube_in_abaqus("*ELEMENT, TYPE=C3D8\n1, 10,20,30,40, 50,60,70,80\n2, 10,20,30,30,50,60,70,70\n"),
      "hexahedron 1: has a corner twice, as wedges and pyramids do");
}

TEST(HexReader, ReadsElementsOfAbaqusOverSeveralLines) {
  const HexMesh mesh = read_text(
      "a.inp",
      cube_in_abaqus("*ELEMENT,\nTYPE=C3D20R\n7, 10, 20, 30, 40, 50, 60, 70, 80,\n10,20,30,40,50,60,70,80,\n"
                     "** a comment\n 10, 20, 30, 40\n*MATERIAL, NAME=STEEL\n*ELASTIC\n2e5, .3\n"));
  EXPECT_EQ(mesh.vertices.size(), 8u);
  EXPECT_DOUBLE_EQ(volume_of(mesh), 1);
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_EQ(mesh.warnings[0].text,
            "hexahedra of higher order: 1; only their corners are used, as if they were straight");
}

TEST(HexReader, TakesRegionsOfAbaqusFromSetsOfElements) {
  const std::string nodes = "110, 0, 0, 2\n120, 1, 0, 2\n130, 1, 1, 2\n140, 0, 1, 2\n";
  const std::string top = "4, 50, 60, 70, 80, 110, 120, 130, 140\n";
  const std::string cube = cube_in_abaqus("*NODE\n" + nodes + kCube);
  EXPECT_EQ(read_text("a.inp", cube + "*ELEMENT, TYPE=C3D8, ELSET=Volume9\n" + top).regions,
            (std::vector<std::int32_t>{1, 2}));
  EXPECT_TRUE(read_text("a.inp", cube + top).regions.empty());
  EXPECT_EQ(read_text("a.inp",
                      cube + top +
                          "*ELSET, ELSET=region_3\n1, 77\n*ELSET, GENERATE, ELSET=REGION_MINUS_5\n2, 8, 2\n")
                .regions,
            (std::vector<std::int32_t>{3, -5}));
}

TEST(HexReader, SaysWhatIsWrongWithAnInputFile) {
  expect_error("a.inp", "anything\n", "line 1: does not begin with a keyword such as *NODE");
  expect_error("a.inp", "*STEP\n1, 2\n", "no *NODE: cut short, or not a mesh");
  expect_error("a.inp", cube_in_abaqus("*INCLUDE, INPUT=part.inp\n"),
               "line 14: parts of it are in the file 'part.inp'; give one of these");
  expect_error("a.inp", cube_in_abaqus("*ELEMENT, TYPE=C3D8\n1, 10, 20, 30\n"),
               "an element of 8 nodes has 3");
  expect_error("a.inp", cube_in_abaqus("*ELEMENT, TYPE=C3D8\n1, 10,20,30,40,50,60,70,81\n"),
               "line 15: refers to node 81, which the file does not have");
  expect_error("a.inp", cube_in_abaqus(std::string("*NODE\n10, 1, 2, 3\n") + kCube),
               "two nodes have the number 10");
  expect_error("a.inp", cube_in_abaqus(std::string(kCube) + kCube), "two elements have the number 1");
  expect_error("a.inp", "*NODE\n1, x, 0, 0\n", "line 2: 'x' instead of a coordinate");
}

}  // namespace
}  // namespace crossgrain
