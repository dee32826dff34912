// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "crossgrain/error.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/writing.hpp"
#include "files/temporary_folder.hpp"
#include "mesh_files/made_bricks.hpp"
#include "results/report_file.hpp"
#include "vtu/vtu_arrays.hpp"
#include "vtu/vtu_writer.hpp"

namespace crossgrain {
namespace {

void expect_same(const HexMesh& read, const HexMesh& mesh) {
  EXPECT_EQ(read.vertices, mesh.vertices);
  EXPECT_EQ(read.hexahedra, mesh.hexahedra);
  EXPECT_EQ(read.regions, mesh.regions);
  ASSERT_EQ(read.boundary.size(), mesh.boundary.size());
  for (std::size_t k = 0; k < mesh.boundary.size(); ++k) {
    EXPECT_EQ(read.boundary[k].vertices, mesh.boundary[k].vertices);
    EXPECT_EQ(read.boundary[k].tag, mesh.boundary[k].tag);
  }
}

HexMesh written_and_read(const HexMesh& mesh) {
  const TemporaryFolder folder;
  write_hexahedra(mesh, folder.path() / "a.vtu");
  return read_hexahedra(folder.path() / "a.vtu");
}

std::string error_of_reading(const std::filesystem::path& path) {
  try {
    read_hexahedra(path);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return error.what();
  }
  return "";
}

/// A file with these cells, which lists one face of the boundary or, as older versions wrote it, none.
std::filesystem::path file_of_cells(const TemporaryFolder& folder, const std::vector<Vector3>& points,
                                    const std::vector<std::int32_t>& connectivity,
                                    const std::vector<std::int32_t>& offsets,
                                    const std::vector<std::uint8_t>& types,
                                    const std::vector<std::int32_t>& regions = {},
                                    bool has_boundary = false) {
  std::vector<VtuArray> arrays{points_array(points.size(), [&](std::size_t i) { return points[i]; }),
                               stored_array(VtuSection::kCells, "connectivity", connectivity),
                               stored_array(VtuSection::kCells, "offsets", offsets),
                               stored_array(VtuSection::kCells, "types", types)};
  if (!regions.empty()) arrays.push_back(stored_array(VtuSection::kCellData, "region", regions));
  const std::vector<std::int32_t> tags{5};
  const std::vector<std::array<std::int32_t, 4>> quads{{0, 2, 3, 1}};
  if (has_boundary) {
    arrays.push_back(row_array<std::int32_t>(VtuSection::kFieldData, "boundary", 4, quads.size(),
                                             [&](std::size_t i) { return quads[i]; }));
    arrays.push_back(stored_array(VtuSection::kFieldData, "boundary_tag", tags));
  }
  const auto path = folder.path() / "cells.vtu";
  OutputFile file(path);
  write_vtu(file, points.size(), types.size(), arrays);
  file.commit();
  return path;
}

TEST(ReadHexahedra, RestoresTheBitsOfAMesh) {
  HexMesh mesh = made_bricks({4, 3, 2}, {4, 3, 2});
  std::mt19937 random(5);
  for (Vector3& vertex : mesh.vertices)
    for (double& x : vertex) x += 0.1 * static_cast<double>(random()) / 4294967296.0;
  mesh.vertices.push_back({5e-324, -1e22, 0.1 + 0.2});  // of no hexahedron
  mesh.boundary[3].tag = std::numeric_limits<std::int32_t>::min();
  std::shuffle(mesh.boundary.begin(), mesh.boundary.end(), random);
  std::rotate(mesh.boundary[0].vertices.begin(), mesh.boundary[0].vertices.begin() + 1,
              mesh.boundary[0].vertices.end());
  expect_same(written_and_read(mesh), mesh);
}

TEST(ReadHexahedra, RestoresAMeshWithoutRegionsBoundaryOrAnything) {
  HexMesh mesh = made_bricks({2, 1, 1}, {1, 1, 1});
  mesh.regions.clear();
  mesh.boundary.clear();
  expect_same(written_and_read(mesh), mesh);
  expect_same(written_and_read({}), {});
}

TEST(ReadHexahedra, FindsTheBoundaryOfAFileThatDoesNotListIt) {
  const TemporaryFolder folder;
  HexMesh mesh = made_bricks({2, 1, 1}, {2, 1, 1});
  std::vector<std::int32_t> corners;
  for (const auto& hexahedron : mesh.hexahedra)
    corners.insert(corners.end(), hexahedron.begin(), hexahedron.end());
  for (HexMesh::Face& face : mesh.boundary) face.tag = 0;
  expect_same(read_hexahedra(file_of_cells(folder, mesh.vertices, corners, {8, 16}, {12, 12}, {1, 2})), mesh);
}

TEST(ReadHexahedra, RefusesArraysThatMakeNoHexahedra) {
  const TemporaryFolder folder;
  const HexMesh mesh = made_bricks({1, 1, 1}, {1, 1, 1});
  const auto error_of = [&](const std::vector<std::int32_t>& corners,
                            const std::vector<std::int32_t>& offsets,
                            const std::vector<std::uint8_t>& types) {
    return error_of_reading(file_of_cells(folder, mesh.vertices, corners, offsets, types, {}, true));
  };
  const std::vector<std::int32_t> sound{0, 1, 3, 2, 4, 5, 7, 6};
  EXPECT_EQ(error_of(sound, {8}, {12}), "");
  const std::string words = "its arrays make no hexahedra";
  EXPECT_NE(error_of({0, 1, 3, 2, 4, 5, 7, 8}, {8}, {12}).find(words), std::string::npos) << "no such point";
  EXPECT_NE(error_of({0, 1, 3, 2, 4, 5, 7, -1}, {8}, {12}).find(words), std::string::npos) << "negative";
  EXPECT_NE(error_of(sound, {7}, {12}).find(words), std::string::npos) << "seven corners";
  EXPECT_NE(error_of(sound, {8}, {11}).find(words), std::string::npos) << "a voxel";
  EXPECT_NE(error_of({0, 1, 3, 2, 4, 5, 7, 6, 0}, {8}, {12}).find(words), std::string::npos)
      << "nine corners";
}

TEST(ReadHexahedra, TakesTheFileOfAFolderAndTheUnitOfItsReport) {
  const TemporaryFolder folder;
  const HexMesh mesh = made_bricks({2, 1, 1}, {2, 1, 1});
  write_hexahedra(mesh, folder.path() / kHexahedraFile);
  SolveReport report;
  report.model.unit = "mm";
  folder.write("report.json", json_of(report).dump());
  const HexMesh read = read_hexahedra(folder.path());
  expect_same(read, mesh);
  EXPECT_EQ(read.unit, "mm");
}

TEST(ReadHexahedra, TakesThePartialMeshOfAFolderThatHasNoOther) {
  const TemporaryFolder folder;
  HexMesh mesh = made_bricks({2, 1, 1}, {2, 1, 1});
  mesh.is_partial = true;
  write_hexahedra(mesh, folder.path() / kPartialHexahedraFile);
  folder.write("report.json", json_of(SolveReport()).dump());
  const HexMesh read = read_hexahedra(folder.path());
  expect_same(read, mesh);
  EXPECT_TRUE(read.is_partial);
  EXPECT_FALSE(written_and_read(made_bricks({2, 1, 1}, {2, 1, 1})).is_partial);
}

TEST(ReadHexahedra, SaysThatAFolderHasNone) {
  const TemporaryFolder folder;
  EXPECT_EQ(error_of_reading(folder.path()),
            folder.path().string() + ": has no hexahedra; make hexahedra of its model and write them to it");
}

TEST(ReadHexahedra, SurvivesDamage) {
  const TemporaryFolder folder;
  write_hexahedra(made_bricks({3, 2, 2}, {3, 2, 2}), folder.path() / "a.vtu");
  const std::string content = content_of(folder.path() / "a.vtu");
  std::mt19937 random(9);
  int refused = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    std::string damaged = content;
    for (int flips = 0; flips < 3; ++flips) damaged[random() % damaged.size()] = static_cast<char>(random());
    if (trial % 4 == 0) damaged.resize(random() % damaged.size());
    refused += !error_of_reading(folder.write("b.vtu", damaged)).empty();
  }
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace crossgrain
