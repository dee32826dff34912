// SPDX-License-Identifier: Apache-2.0
// Files of the map of hexahedra against readers written from their description.
#include <gtest/gtest.h>

#include <fstream>
#include <vector>

#include "crossgrain/error.hpp"
#include "crossgrain/writing.hpp"
#include "files/temporary_folder.hpp"
#include "measure/made_tets.hpp"
#include "mesh_files/made_map.hpp"
#include "vtu/vtu_reader.hpp"

namespace crossgrain {
namespace {

struct HexexFile {
  explicit HexexFile(const std::filesystem::path& path) {
    std::ifstream in(path);
    std::size_t count = 0;
    in >> count;
    vertices.resize(count);
    for (Vector3& vertex : vertices) in >> vertex[0] >> vertex[1] >> vertex[2];
    in >> count;
    tets.resize(count), coordinates.resize(count);
    for (std::size_t t = 0; t < count; ++t) {
      for (std::uint32_t& corner : tets[t]) in >> corner;
      for (Vector3& corner : coordinates[t]) in >> corner[0] >> corner[1] >> corner[2];
    }
    EXPECT_TRUE(in);
    std::string rest;
    EXPECT_FALSE(in >> rest) << rest;
  }

  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 4>> tets;
  std::vector<HexMap::Corners> coordinates;
};

/// More tets and vertices than one task makes text of.
HexMap many_tets() {
  return made_map(tet_box({11, 11, 11}, 0.2));
}

ErrorKind refusal(const HexMap& map, const std::string& name) {
  const TemporaryFolder folder;
  try {
    write_map(map, folder.path() / name);
  } catch (const Error& error) {
    EXPECT_TRUE(folder.names().empty());
    return error.kind();
  }
  ADD_FAILURE() << "no error";
  return ErrorKind::kOutput;
}

TEST(WriteMap, HexexHasTetsAndTheIntegerGridMapToTheBit) {
  const HexMap map = many_tets();
  const TemporaryFolder folder;
  write_map(map, folder.path() / "a.hexex");
  const HexexFile file(folder.path() / "a.hexex");
  EXPECT_EQ(file.vertices, map.vertices);
  EXPECT_EQ(file.tets, map.tets);
  EXPECT_EQ(file.coordinates, map.integer_grid);
}

TEST(WriteMap, VtuHasFourPointsOfItsOwnForEachTet) {
  const HexMap map = many_tets();
  const TemporaryFolder folder;
  write_map(map, folder.path() / "a.vtu");
  const VtuFile file(folder.path() / "a.vtu");
  ASSERT_EQ(file.cells(), map.tets.size());
  ASSERT_EQ(file.points(), 4 * map.tets.size());
  const auto points = file.read<double>(VtuSection::kPoints, "Points", 3);
  const auto seamless = file.read<double>(VtuSection::kPointData, "seamless", 3);
  const auto grid = file.read<double>(VtuSection::kPointData, "integer_grid", 3);
  const auto vertices = file.read<std::int32_t>(VtuSection::kPointData, "vertex", 1);
  const auto connectivity = file.read<std::int32_t>(VtuSection::kCells, "connectivity", 1);
  for (std::size_t i = 0; i < file.points(); ++i) {
    const std::size_t t = i / 4, a = i % 4;
    ASSERT_EQ(connectivity[i], static_cast<std::int32_t>(i));
    ASSERT_EQ(static_cast<std::uint32_t>(vertices[i]), map.tets[t][a]);
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_EQ(points[3 * i + k], map.vertices[map.tets[t][a]][k]);
      ASSERT_EQ(seamless[3 * i + k], map.seamless[t][a][k]);
      ASSERT_EQ(grid[3 * i + k], map.integer_grid[t][a][k]);
    }
  }
}

TEST(WriteMap, DeterminantIsOneWhereHexahedraHaveTheSizeOfTheMap) {
  HexMap map = made_map(tet_box({1, 1, 1}, 0));
  for (std::size_t t = 0; t < map.tets.size(); ++t)
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t k = 0; k < 3; ++k)
        map.integer_grid[t][a][k] = map.vertices[map.tets[t][a]][k] / map.size;
  std::swap(map.integer_grid[2][0], map.integer_grid[2][1]);
  const TemporaryFolder folder;
  write_map(map, folder.path() / "a.vtu");
  const auto found = VtuFile(folder.path() / "a.vtu").read<double>(VtuSection::kCellData, "determinant", 1);
  for (std::size_t t = 0; t < found.size(); ++t) EXPECT_NEAR(found[t], t == 2 ? -1 : 1, 1e-12);
}

TEST(WriteMap, RefusesOtherExtensionsAndMapsThatContradictThemselves) {
  const HexMap map = made_map(tet_box({1, 1, 1}, 0));
  EXPECT_EQ(refusal(map, "a.mesh"), ErrorKind::kUsage);
  HexMap other = map;
  other.seamless.pop_back();
  EXPECT_EQ(refusal(other, "a.vtu"), ErrorKind::kUsage);
  other = map;
  other.integer_grid.clear();
  EXPECT_EQ(refusal(other, "a.hexex"), ErrorKind::kUsage);
  other = map;
  other.tets[3][2] = static_cast<std::uint32_t>(map.vertices.size());
  EXPECT_EQ(refusal(other, "a.hexex"), ErrorKind::kUsage);
}

}  // namespace
}  // namespace crossgrain
