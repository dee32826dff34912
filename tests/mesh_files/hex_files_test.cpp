// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "crossgrain/error.hpp"
#include "crossgrain/thread_limit.hpp"
#include "crossgrain/writing.hpp"
#include "files/file_mark.hpp"
#include "files/output_error.hpp"
#include "files/small_files.hpp"
#include "files/temporary_folder.hpp"
#include "measure/hex_quality.hpp"
#include "mesh_files/hex_file_readers.hpp"
#include "mesh_files/made_bricks.hpp"

namespace crossgrain {
namespace {

constexpr std::array kNames{"a.vtu", "a.mesh", "a.msh", "a.inp"};

/// Bricks with corners moved at random, so that coordinates need all their digits.
HexMesh crooked_bricks(const std::array<std::uint32_t, 3>& counts = {4, 3, 2}) {
  HexMesh mesh = made_bricks(counts, {4, 3, 2});
  std::mt19937 random(5);
  for (Vector3& vertex : mesh.vertices)
    for (double& x : vertex) x += 0.3 / counts[1] * static_cast<double>(random()) / 4294967296.0;
  return mesh;
}

/// Writes and reads a mesh; what only some formats have is empty for the others.
ReadHexFile written(const HexMesh& mesh, const std::string& name,
                    InvertedHexahedra inverted = InvertedHexahedra::kRefused) {
  const TemporaryFolder folder;
  const auto path = folder.path() / name;
  write_hexahedra(mesh, path, {}, inverted);
  EXPECT_EQ(folder.names(), std::vector<std::string>{name});
  if (name.ends_with(".vtu")) return read_vtu_hexahedra(VtuFile(path));
  if (name.ends_with(".mesh")) return read_medit(path);
  if (name.ends_with(".msh")) return GmshHexFile(path).read;
  return AbaqusFile(path).read;
}

GmshHexFile written_gmsh(const HexMesh& mesh) {
  const TemporaryFolder folder;
  write_hexahedra(mesh, folder.path() / "a.msh");
  return GmshHexFile(folder.path() / "a.msh");
}

AbaqusFile written_abaqus(const HexMesh& mesh) {
  const TemporaryFolder folder;
  write_hexahedra(mesh, folder.path() / "a.inp");
  return AbaqusFile(folder.path() / "a.inp");
}

std::vector<std::int32_t> tags_of(const HexMesh& mesh) {
  std::vector<std::int32_t> tags;
  for (const HexMesh::Face& face : mesh.boundary) tags.push_back(face.tag);
  return tags;
}

std::vector<QuadCorners> corners_of(const HexMesh& mesh) {
  std::vector<QuadCorners> corners;
  for (const HexMesh::Face& face : mesh.boundary) corners.push_back(face.vertices);
  return corners;
}

/// `before` and each tag.
std::vector<std::string> names_of(const std::string& before, const std::vector<std::int32_t>& tags) {
  std::vector<std::string> names;
  for (const std::int32_t tag : tags) names.push_back(before + std::to_string(tag));
  return names;
}

TEST(WriteHexahedra, KeepsVerticesAndHexahedraWithTheirOrderInEveryFormat) {
  const HexMesh mesh = crooked_bricks();
  for (const char* name : kNames) {
    SCOPED_TRACE(name);
    const ReadHexFile read = written(mesh, name);
    EXPECT_EQ(read.hexahedra, mesh.hexahedra);
    ASSERT_EQ(read.vertices.size(), mesh.vertices.size());
    // Abaqus reads 20 columns, which suffice for 17 decimals.
    const bool is_exact = std::string(name) != "a.inp";
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      for (std::size_t a = 0; a < 3; ++a)
        ASSERT_NEAR(read.vertices[v][a], mesh.vertices[v][a], is_exact ? 0 : 1e-17);
  }
}

TEST(WriteHexahedra, NumbersCornersOfUprightBricksByTheRightHand) {
  for (const char* name : kNames) {
    SCOPED_TRACE(name);
    const ReadHexFile read = written(crooked_bricks(), name);
    for (const HexCorners& corners : read.hexahedra) {
      const auto along = [&](std::size_t k, std::size_t axis) {
        return read.vertices[corners[k]][axis] - read.vertices[corners[0]][axis];
      };
      EXPECT_GT(along(1, 0), 0.5);
      EXPECT_GT(along(3, 1), 0.5);
      EXPECT_GT(along(4, 2), 0.5);
      EXPECT_GT(std::min({along(6, 0), along(6, 1), along(6, 2)}), 0.5);
    }
  }
}

TEST(WriteHexahedra, PutsTagsAndRegionsAsReferencesIntoMedit) {
  const HexMesh mesh = crooked_bricks();
  const ReadHexFile read = written(mesh, "a.mesh");
  EXPECT_EQ(read.quads, corners_of(mesh));
  EXPECT_EQ(read.quad_groups, names_of("", tags_of(mesh)));
  EXPECT_EQ(read.hex_groups, names_of("", mesh.regions));
}

TEST(WriteHexahedra, PutsTagsAndRegionsAsNamedGroupsIntoGmsh) {
  const HexMesh mesh = crooked_bricks();
  const ReadHexFile read = written(mesh, "a.msh");
  EXPECT_EQ(read.quads, corners_of(mesh));
  EXPECT_EQ(read.quad_groups, names_of("face ", tags_of(mesh)));
  EXPECT_EQ(read.hex_groups, names_of("region ", mesh.regions));
}

TEST(WriteHexahedra, GivesGmshOneEntityOfTheSameNumberForEachTagAndRegion) {
  const GmshHexFile file = written_gmsh(crooked_bricks());
  EXPECT_EQ(file.entities.size(), 8u);
  EXPECT_EQ(file.names.size(), 8u);
  for (int tag = 11; tag <= 16; ++tag) {
    EXPECT_EQ(file.names.at({2, tag}), "face " + std::to_string(tag));
    EXPECT_EQ(file.entities.at({2, tag}).group, "face " + std::to_string(tag));
  }
  for (int region = 1; region <= 2; ++region)
    EXPECT_EQ(file.entities.at({3, region}).group, "region " + std::to_string(region));
  // Only the low and the high end along x are of one region.
  EXPECT_EQ(file.entities.at({3, 1}).boundary, (std::vector<std::int32_t>{11, 13, 14, 15, 16}));
  EXPECT_EQ(file.entities.at({3, 2}).boundary, (std::vector<std::int32_t>{12, 13, 14, 15, 16}));
}

TEST(WriteHexahedra, GivesGmshTheTightBoxOfEachEntity) {
  const HexMesh mesh = crooked_bricks();
  const auto expect_box = [&](const std::array<double, 6>& box, const std::vector<std::uint32_t>& vertices) {
    for (std::size_t a = 0; a < 3; ++a) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const std::uint32_t v : vertices) {
        low = std::min(low, mesh.vertices[v][a]);
        high = std::max(high, mesh.vertices[v][a]);
      }
      EXPECT_EQ(box[a], low);
      EXPECT_EQ(box[3 + a], high);
    }
  };
  std::map<std::pair<int, int>, std::vector<std::uint32_t>> vertices;
  for (const HexMesh::Face& face : mesh.boundary)
    for (const std::uint32_t v : face.vertices) vertices[{2, face.tag}].push_back(v);
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
    for (const std::uint32_t v : mesh.hexahedra[h]) vertices[{3, mesh.regions[h]}].push_back(v);
  for (const auto& [key, entity] : written_gmsh(mesh).entities) expect_box(entity.box, vertices.at(key));
}

TEST(WriteHexahedra, GivesGmshNodesInsideToVolumesAndOthersToSurfaces) {
  const HexMesh mesh = made_bricks({4, 3, 2}, {4, 3, 2});
  for (const auto& [key, nodes] : written_gmsh(mesh).nodes)
    for (const std::uint32_t v : nodes) {
      const auto [x, y, z] = mesh.vertices[v];
      const bool is_inside = x > 0 && x < 4 && y > 0 && y < 3 && z > 0 && z < 2;
      EXPECT_EQ(key.first, is_inside ? 3 : 2);
    }
}

TEST(WriteHexahedra, PutsNodesOfTaggedFacesIntoSetsOfAbaqus) {
  const HexMesh mesh = crooked_bricks();
  std::map<std::string, std::set<std::int64_t>> expected;
  for (const HexMesh::Face& face : mesh.boundary)
    for (const std::uint32_t v : face.vertices) expected["FACE_" + std::to_string(face.tag)].insert(v + 1);
  const AbaqusFile file = written_abaqus(mesh);
  ASSERT_EQ(file.node_sets.size(), 6u);
  for (const auto& [name, nodes] : file.node_sets)
    EXPECT_EQ(nodes, std::vector<std::int64_t>(expected.at(name).begin(), expected.at(name).end())) << name;
}

/// The nodes of the faces S1 to S6 of C3D8 elements, from 1 (Abaqus Elements Guide, three-dimensional solid
/// element library; CalculiX manual, "Eight-node brick element").
constexpr std::array<std::array<std::size_t, 4>, 6> kAbaqusFaces{
    {{1, 2, 3, 4}, {5, 8, 7, 6}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 8, 4}, {4, 8, 5, 1}}};

TEST(WriteHexahedra, NamesFacesOfElementsAsAbaqusDoes) {
  const HexMesh mesh = crooked_bricks();
  std::map<std::string, std::set<std::set<std::uint32_t>>> expected, found;
  for (const HexMesh::Face& face : mesh.boundary)
    expected["FACE_" + std::to_string(face.tag)].insert({face.vertices.begin(), face.vertices.end()});
  const AbaqusFile file = written_abaqus(mesh);
  std::size_t faces = 0;
  for (const auto& [name, sides] : file.surfaces)
    for (const auto& [element, label] : sides) {
      std::set<std::uint32_t> nodes;
      for (const std::size_t corner : kAbaqusFaces.at(static_cast<std::size_t>(label - 1)))
        nodes.insert(mesh.hexahedra.at(static_cast<std::size_t>(element - 1))[corner - 1]);
      found[name].insert(nodes);
      ++faces;
    }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(faces, mesh.boundary.size());
}

TEST(WriteHexahedra, PutsRegionsIntoSetsOfElementsOfAbaqus) {
  const HexMesh mesh = crooked_bricks();
  const AbaqusFile file = written_abaqus(mesh);
  ASSERT_EQ(file.element_sets.size(), 2u);
  for (const std::int32_t region : {1, 2}) {
    std::vector<std::int64_t> expected;
    for (std::size_t h = 0; h < mesh.regions.size(); ++h)
      if (mesh.regions[h] == region) expected.push_back(static_cast<std::int64_t>(h + 1));
    EXPECT_EQ(file.element_sets.at("REGION_" + std::to_string(region)), expected);
  }
}

TEST(WriteHexahedra, KeepsLinesOfAbaqusWithin80Columns) {
  const TemporaryFolder folder;
  HexMesh mesh = made_bricks({60, 60, 30}, {1, 1, 1});  // numbers of six digits
  std::mt19937 random(7);
  for (Vector3& vertex : mesh.vertices)
    for (double& x : vertex) x = std::ldexp(x - static_cast<double>(random()) / 3e9, -int(random() % 400));
  write_hexahedra(mesh, folder.path() / "a.inp", {}, InvertedHexahedra::kAllowed);
  LinesOfFile lines(folder.path() / "a.inp");
  std::size_t longest = 0;
  while (!lines.is_at_end()) longest = std::max(longest, lines.take().size());
  EXPECT_LE(longest, 80u);
  EXPECT_GE(longest, 60u);
}

TEST(WriteHexahedra, PutsShapesAndRegionsIntoVtuOverCells) {
  const TemporaryFolder folder;
  const HexMesh mesh = crooked_bricks();
  write_hexahedra(mesh, folder.path() / "a.vtu");
  const VtuFile file(folder.path() / "a.vtu");
  EXPECT_EQ(file.read<double>(VtuSection::kCellData, "scaled_jacobian", 1), scaled_jacobians(mesh));
  EXPECT_EQ(file.read<std::int32_t>(VtuSection::kCellData, "region", 1), mesh.regions);
}

TEST(WriteHexahedra, RestoresTheBitsOfAnyNumber) {
  HexMesh mesh = made_bricks({1, 1, 1}, {1, 1, 1});
  mesh.vertices[0] = {5e-324, -2.2250738585072014e-308, -1.2345678901234567e-17};
  mesh.vertices[1] = {1.7976931348623157e299, 1e22, 0.1 + 0.2};
  mesh.vertices[2] = {-1.0 / 3, 100000, 1e15 + 0.3};
  for (const char* name : {"a.vtu", "a.mesh", "a.msh"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(written(mesh, name, InvertedHexahedra::kAllowed).vertices, mesh.vertices);
  }
}

TEST(WriteHexahedra, GivesAbaqusNumbersOfAtMost20ColumnsToTwelveDigits) {
  const TemporaryFolder folder;
  HexMesh mesh = made_bricks({1, 1, 1}, {1, 1, 1});
  mesh.vertices[0] = {-0.012345678901234567, 1.0 / 3, -1.2345678901234567e-17};
  mesh.vertices[1] = {-1.2345678901234567e-300, 123456.78901234567, -1.2345678901234567e+300};
  write_hexahedra(mesh, folder.path() / "a.inp", {}, InvertedHexahedra::kAllowed);
  LinesOfFile lines(folder.path() / "a.inp");
  lines.take();
  lines.expect("*NODE, NSET=ALL");
  for (std::size_t v = 0; v < 2; ++v) {
    std::istringstream words(lines.take());
    std::string word;
    std::getline(words, word, ',');
    for (const double x : mesh.vertices[v]) {
      std::getline(words, word, ',');
      EXPECT_LE(word.size(), 20u);
      EXPECT_NEAR(std::stod(word), x, 1e-12 * std::abs(x)) << word;
    }
    EXPECT_TRUE(words.eof());
  }
  EXPECT_EQ(AbaqusFile(folder.path() / "a.inp").read.vertices[0][1], 1.0 / 3);
}

TEST(WriteHexahedra, CallsTheBoundarySoWithoutTags) {
  HexMesh mesh = crooked_bricks();
  for (HexMesh::Face& face : mesh.boundary) face.tag = 0;
  mesh.regions.clear();
  const AbaqusFile inp = written_abaqus(mesh);
  EXPECT_TRUE(inp.element_sets.empty());
  ASSERT_EQ(inp.node_sets.size(), 1u);
  EXPECT_EQ(inp.node_sets.at("BOUNDARY").size(), mesh.vertices.size() - 3 * 2 * 1);
  ASSERT_EQ(inp.surfaces.size(), 1u);
  EXPECT_EQ(inp.surfaces.at("BOUNDARY").size(), mesh.boundary.size());
  const GmshHexFile msh = written_gmsh(mesh);
  ASSERT_EQ(msh.entities.size(), 2u);
  EXPECT_EQ(msh.entities.at({2, 1}).group, "boundary");
  EXPECT_EQ(msh.entities.at({3, 1}).group, "volume");
  EXPECT_EQ(written(mesh, "a.mesh").hex_groups, std::vector<std::string>(mesh.hexahedra.size(), "0"));
  const TemporaryFolder folder;
  write_hexahedra(mesh, folder.path() / "a.vtu");
  EXPECT_EQ(VtuFile(folder.path() / "a.vtu").find(VtuSection::kCellData, "region"), nullptr);
}

/// Gmsh has no groups of such numbers; Abaqus needs no set of what nobody has named.
TEST(WriteHexahedra, BearsNegativeTagsAndSomeThatAreZero) {
  HexMesh mesh = crooked_bricks();
  const std::map<std::int32_t, std::int32_t> tags{
      {11, -3}, {12, 0}, {13, 1}, {14, std::numeric_limits<std::int32_t>::max()}, {15, 2}, {16, -3}};
  for (HexMesh::Face& face : mesh.boundary) face.tag = tags.at(face.tag);
  for (std::int32_t& region : mesh.regions) region -= 2;
  EXPECT_EQ(written(mesh, "a.mesh").quad_groups, names_of("", tags_of(mesh)));
  const ReadHexFile msh = written(mesh, "a.msh");
  EXPECT_EQ(msh.quad_groups, names_of("face ", tags_of(mesh)));
  EXPECT_EQ(msh.hex_groups, names_of("region ", mesh.regions));
  const GmshHexFile file = written_gmsh(mesh);
  for (const auto& [key, entity] : file.entities) EXPECT_GT(key.second, 0);
  EXPECT_EQ(file.names.at({2, 2}), "face 2");
  const AbaqusFile inp = written_abaqus(mesh);
  EXPECT_EQ(inp.surfaces.size(), 4u);
  EXPECT_EQ(inp.surfaces.at("FACE_MINUS_3").size(), 3u * 2 + 4 * 3);
  EXPECT_EQ(inp.surfaces.count("FACE_2147483647"), 1u);
  EXPECT_EQ(inp.element_sets.count("REGION_MINUS_1") + inp.element_sets.count("REGION_0"), 2u);
}

TEST(WriteHexahedra, WritesAMeshWithoutAnything) {
  for (const char* name : kNames) {
    SCOPED_TRACE(name);
    EXPECT_TRUE(written({}, name).vertices.empty());
  }
}

TEST(WriteHexahedra, KeepsVerticesThatNoHexahedronHas) {
  HexMesh mesh = crooked_bricks();
  mesh.vertices.insert(mesh.vertices.begin(), {7, 8, 9});
  for (auto& corners : mesh.hexahedra)
    for (std::uint32_t& corner : corners) ++corner;
  for (HexMesh::Face& face : mesh.boundary)
    for (std::uint32_t& corner : face.vertices) ++corner;
  for (const char* name : {"a.vtu", "a.mesh", "a.msh"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(written(mesh, name).vertices, mesh.vertices);
    EXPECT_EQ(written(mesh, name).hexahedra, mesh.hexahedra);
  }
}

TEST(WriteHexahedra, MarksItsFilesAndGoesByTheExtensionInEitherCase) {
  const TemporaryFolder folder;
  for (const char* name : {"a.vtu", "a.mesh", "a.msh", "a.inp", "A.VTU", "A.MESH", "A.MSH", "A.INP"}) {
    write_hexahedra(crooked_bricks(), folder.path() / name);
    EXPECT_TRUE(has_mark(folder.path() / name)) << name;
  }
  for (const char* extension : {"vtu", "mesh", "msh", "inp"}) {
    std::string upper = std::string("A.") + extension;
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    EXPECT_EQ(content_of(folder.path() / upper), content_of(folder.path() / (std::string("a.") + extension)));
  }
}

TEST(WriteHexahedra, HasTheSameBytesForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const HexMesh mesh = crooked_bricks({30, 30, 20});
  for (const char* name : kNames) {
    const auto bytes = [&](int threads) {
      const ThreadLimit limit(threads);
      write_hexahedra(mesh, folder.path() / name);
      return content_of(folder.path() / name);
    };
    EXPECT_TRUE(bytes(1) == bytes(4)) << name;
  }
}

void expect_usage_error(const std::function<void()>& act, const std::string& words) {
  try {
    act();
    ADD_FAILURE() << "no error that says " << words;
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    EXPECT_NE(message.find(words), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(WriteHexahedra, RefusesOtherExtensions) {
  const TemporaryFolder folder;
  for (const char* name : {"a.vtk", "a", "a.inp.gz", "a.stl"}) {
    const auto path = folder.path() / name;
    const std::string words = path.string() +
                              ": is no name of a hexahedral mesh that can be written; let it end in .vtu, "
                              ".mesh, .msh or .inp";
    expect_usage_error([&] { write_hexahedra(crooked_bricks(), path); }, words);
    expect_usage_error([&] { check_hexahedra_path(path); }, words);
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(WriteHexahedra, RefusesAMeshThatContradictsItself) {
  const TemporaryFolder folder;
  HexMesh far_corner = crooked_bricks(), far_face = far_corner, few_regions = far_corner, inner = far_corner;
  far_corner.hexahedra[5][3] = 60;
  far_face.boundary[4].vertices[0] = 4000000000;
  few_regions.regions.pop_back();
  inner.boundary[7].vertices = {0, 1, 2, 3};
  for (const char* name : kNames) {
    const auto write = [&](const HexMesh& mesh) { write_hexahedra(mesh, folder.path() / name); };
    expect_usage_error([&] { write(far_corner); }, "hexahedron 5 (counted from 0): has a corner");
    expect_usage_error([&] { write(far_face); }, "boundary face 4 (counted from 0): has a corner");
    expect_usage_error([&] { write(few_regions); }, "must have a region for each of them");
    expect_usage_error([&] { write(inner); }, "boundary face 7 (counted from 0): is no face of a hexahedron");
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(WriteHexahedra, SaysNearTheBeginningThatAMeshIsPartial) {
  const TemporaryFolder folder;
  HexMesh mesh = crooked_bricks();
  for (const bool is_partial : {false, true}) {
    mesh.is_partial = is_partial;
    for (const char* name : kNames) {
      write_hexahedra(mesh, folder.path() / name);
      const std::string head = content_of(folder.path() / name).substr(0, kMarkedBytes);
      EXPECT_EQ(head.find("partial") != std::string::npos, is_partial) << name;
    }
  }
}

TEST(WriteHexahedra, RefusesInvertedOnesInFilesForSolversUnlessTheyAreAskedFor) {
  const TemporaryFolder folder;
  HexMesh mesh = made_bricks({2, 1, 1}, {2, 1, 1});
  mesh.vertices[mesh.hexahedra[1][6]] = {0.9, -0.2, -0.2};
  for (const char* name : {"a.mesh", "a.msh", "a.inp"}) {
    expect_usage_error([&] { write_hexahedra(mesh, folder.path() / name); },
                       "a." + std::string(name + 2) + ": hexahedron 2: is inverted");
    EXPECT_TRUE(folder.names().empty());
    write_hexahedra(mesh, folder.path() / name, {}, InvertedHexahedra::kAllowed);
    std::filesystem::remove(folder.path() / name);
  }
  write_hexahedra(mesh, folder.path() / "a.vtu");
}

TEST(WriteHexahedra, RefusesAHexahedronThatIsInvertedOnlyInside) {
  const TemporaryFolder folder;
  HexMesh mesh;
  mesh.vertices = {{0, -0.5, 0.5},  {1, -0.5, -0.5}, {1, 1, 0.5},   {-0.5, 0.5, 0},
                   {0.5, 0.5, 1.5}, {1.5, 0.5, 0.5}, {0.5, 0.5, 1}, {-0.5, 1.5, 0.5}};
  mesh.hexahedra = {{0, 1, 2, 3, 4, 5, 6, 7}};
  EXPECT_GT(scaled_jacobians(mesh)[0], 0.1);
  expect_usage_error([&] { write_hexahedra(mesh, folder.path() / "a.msh"); },
                     "a.msh: hexahedron 1: is inverted");
}

TEST(WriteHexahedra, LeavesTheEarlierFileWhenItIsCancelled) {
  for (const char* name : kNames) {
    const TemporaryFolder folder;
    const auto path = folder.write(name, "earlier");
    Monitor monitor;
    monitor.cancel();
    try {
      write_hexahedra(crooked_bricks(), path, monitor);
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInterrupted);
    }
    EXPECT_EQ(content_of(path), "earlier");
    EXPECT_EQ(folder.names(), std::vector<std::string>{name});
  }
}

TEST(WriteHexahedra, LeavesNothingWhenTheDiskFillsUpAndSaysHowToMendIt) {
  const HexMesh mesh = crooked_bricks({30, 30, 20});
  for (const char* name : kNames) {
    const TemporaryFolder folder;
    const SmallFiles limit;
    const std::string message = output_error_of([&] { write_hexahedra(mesh, folder.path() / name); });
    EXPECT_NE(message.find(std::string(name) + ": cannot be written: File too large; free some space"),
              std::string::npos)
        << message;
    EXPECT_TRUE(folder.names().empty());
  }
}

TEST(WriteHexahedra, FailsEarlyWhereNoFileCanBe) {
  const TemporaryFolder folder;
  const auto pipe = folder.path() / "pipe.msh";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const auto& path : {folder.path() / "none" / "a.msh", pipe}) {
    for (const auto& act : {std::function<void()>([&] { check_hexahedra_path(path); }),
                            std::function<void()>([&] { write_hexahedra(crooked_bricks(), path); })})
      EXPECT_NE(output_error_of(act).find(path.string()), std::string::npos);
  }
  check_hexahedra_path(folder.path() / "a.msh");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"pipe.msh"});
}

}  // namespace
}  // namespace crossgrain
