// SPDX-License-Identifier: Apache-2.0
// What holds for every format and encoding of tets, and the meshes of the shared folder.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <random>
#include <set>
#include <sstream>

#include "mesh_files/gmsh_files.hpp"
#include "mesh_files/medit_files.hpp"
#include "mesh_files/vtk_files.hpp"
#include "support/nightly.hpp"

namespace crossgrain {
namespace {

std::vector<MadeFile> all_files(const TetMesh& mesh) {
  std::vector<MadeFile> files;
  for (const auto& some : {medit_files(mesh), gmsh_files(mesh), vtk_files(mesh), vtu_files(mesh)})
    files.insert(files.end(), some.begin(), some.end());
  return files;
}

TEST(ReadTets, GivesTheSameMeshFromEveryEncoding) {
  const TetMesh mesh = made_tet_mesh();
  for (const MadeFile& file : all_files(mesh)) {
    SCOPED_TRACE(file.what);
    const TetMesh read = read_made(file);
    expect_same_mesh(read, mesh);
    EXPECT_TRUE(read.warnings.empty());
  }
}

/// What ends within a number may still be a whole mesh; mostly it is an error that names the file.
TEST(ReadTets, NeverCrashesOnAFileCutShortAnywhere) {
  const TetMesh mesh = made_tet_mesh(4, 2);
  const TemporaryFolder folder;
  for (const MadeFile& file : all_files(mesh)) {
    SCOPED_TRACE(file.what);
    const auto path = folder.write("a" + file.extension, file.content);
    std::size_t errors = 0, cuts = 0;
    for (std::size_t size = file.content.size() - 1; size > 0;
         size -= is_nightly() ? 1 : std::min<std::size_t>(size, 7)) {
      std::filesystem::resize_file(path, size);
      errors += !error_of_reading_tets(path).empty();
      ++cuts;
    }
    EXPECT_GT(errors, cuts / 2);
  }
}

TEST(ReadTets, NeverCrashesOnDamagedFiles) {
  const TetMesh mesh = made_tet_mesh(4, 2);
  const TemporaryFolder folder;
  std::mt19937 random(8);
  for (const MadeFile& file : all_files(mesh)) {
    SCOPED_TRACE(file.what);
    for (int trial = 0; trial < 25; ++trial) {
      std::string damaged = file.content;
      for (int flips = 1 + trial % 4; flips > 0; --flips)
        damaged[random() % damaged.size()] =
            trial % 2 == 0 ? static_cast<char>(random()) : "0123456789 -\n.e"[random() % 15];
      error_of_reading_tets(folder.write("a" + file.extension, damaged));
    }
  }
}

TEST(ReadTets, NeverCrashesOnNoise) {
  std::mt19937 random(5);
  for (const char* extension : {".mesh", ".meshb", ".msh", ".vtk", ".vtu"}) {
    for (int trial = 0; trial < 30; ++trial) {
      std::string noise(1 + random() % 3000, '\0');
      for (char& c : noise) c = static_cast<char>(random());
      EXPECT_NE(error_of_reading_tets({"noise", extension, noise}), "");
    }
  }
}

TEST(ReadTets, GoesByTheExtension) {
  for (const char* name :
       {"folder/part.mesh", "PART.MESH", "part.meshb", "part.msh", "part.MSH", "part.vtk", "part.vtu"})
    EXPECT_TRUE(is_tet_file(name)) << name;
  for (const char* name : {"part.stl", "part", "mesh", "part.mesh.xz", "part.vtp"})
    EXPECT_FALSE(is_tet_file(name)) << name;
  const TemporaryFolder folder;
  EXPECT_THROW(read_tets(folder.path() / "missing.mesh"), Error);
  expect_tet_error({"", ".stl", "solid a\nendsolid\n"}, "only in .mesh, .meshb, .msh, .vtk or .vtu");
}

TEST(ReadTets, SaysWhatAFileUnderAWrongNameIs) {
  const TetMesh mesh = made_tet_mesh(4, 2);
  const auto renamed = [](MadeFile file, const char* extension) {
    file.extension = extension;
    return file;
  };
  expect_tet_error(renamed(medit_text(mesh), ".msh"), "begins like a Medit mesh (.mesh); rename it");
  expect_tet_error(renamed(medit_binary(mesh, 2, false), ".mesh"),
                   "a Medit mesh in binary (.meshb); rename it");
  expect_tet_error(renamed(gmsh_2(mesh, {}), ".mesh"), "begins like a Gmsh mesh (.msh); rename it");
  expect_tet_error(renamed(vtk_legacy<float>(mesh, "2.0", true), ".vtu"), "a VTK file (.vtk); rename it");
  expect_tet_error(renamed(vtu(mesh, {"ascii"}), ".vtk"), "a VTK XML file (.vtu); rename it");
}

TEST(ReadSurface, SendsTetsToWhereTheyAreRead) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.msh", gmsh_2(made_tet_mesh(4, 2), {}).content);
  try {
    read_surface(path);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'.msh' files hold tets"), std::string::npos) << error.what();
  }
}

// The models of the shared folder.

std::filesystem::path shared_models() {
  const char* set = std::getenv("CROSSGRAIN_SHARED");
  return std::filesystem::path(set != nullptr ? set : CROSSGRAIN_DEFAULT_SHARED) / "models";
}

TEST(SharedModels, TetMeshesHaveTheCountsOfTheManifest) {
  std::size_t read = 0;
  for (const char* folder : {"good", "bad"}) {
    std::ifstream manifest(shared_models() / folder / "MANIFEST.tsv");
    for (std::string line; std::getline(manifest, line);) {
      std::istringstream row(line);
      std::vector<std::string> fields;
      for (std::string field; std::getline(row, field, '\t');) fields.push_back(field);
      if (!is_tet_file(fields.at(0)) || fields.at(5).empty()) continue;
      SCOPED_TRACE(fields[0]);
      const TetMesh mesh = read_tets(shared_models() / folder / fields[0]);
      EXPECT_EQ(std::to_string(mesh.vertices.size()), fields.at(3));
      EXPECT_EQ(std::to_string(mesh.tets.size()), fields.at(5));
      EXPECT_EQ(mesh.regions.size(), mesh.tets.size());
      ++read;
    }
  }
  if (read == 0) GTEST_SKIP() << "no tet meshes in " << shared_models();
  EXPECT_GE(read, 7u);
}

TEST(SharedModels, HexahedraOfGmshAreRefused) {
  const auto path = shared_models() / "bad" / "cube-hex.msh";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  expect_tet_error({"", ".msh", content_of(path)}, "17: hexahedra (1), but only tets can be used");
}

TEST(SharedModels, FeaturesOfAVtkFileOfHexMeAreRead) {
  const auto path = shared_models() / "good" / "s02u_prism.vtk";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const TetMesh mesh = read_tets(path);
  // A triangular prism: nine edges and five faces.
  const auto count_tags = [](const auto& features) {
    std::set<std::int32_t> tags;
    for (const auto& feature : features) tags.insert(feature.tag);
    return tags.size();
  };
  EXPECT_EQ(count_tags(mesh.feature_edges), 9u);
  EXPECT_EQ(count_tags(mesh.feature_faces), 5u);
  EXPECT_EQ(mesh.feature_edges.size(), 99u);
  EXPECT_EQ(mesh.feature_faces.size(), 1106u);
}

}  // namespace
}  // namespace crossgrain
