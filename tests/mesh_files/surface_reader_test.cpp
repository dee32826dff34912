// SPDX-License-Identifier: Apache-2.0
// What holds for every format, and the models of the shared folder.
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <random>
#include <sstream>

#include "mesh_files/surface_files.hpp"

namespace crossgrain {
namespace {

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST(ReadSurface, NamesAMissingFile) {
  const TemporaryFolder folder;
  const std::string message = input_error_of(folder.path() / "none.stl");
  EXPECT_NE(message.find("no such file"), std::string::npos) << message;
}

TEST(ReadSurface, RefusesAFolderAnEmptyFileAndADevice) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "folder.stl");
  EXPECT_NE(input_error_of(folder.path() / "folder.stl").find("is a folder"), std::string::npos);
  EXPECT_NE(input_error_of(folder.write("a.ply", "")).find("is empty"), std::string::npos);
  EXPECT_NE(input_error_of("/dev/zero").find("not a regular file"), std::string::npos);
  ASSERT_EQ(::mkfifo((folder.path() / "pipe.stl").c_str(), 0600), 0);
  EXPECT_NE(input_error_of(folder.path() / "pipe.stl").find("not a regular file"), std::string::npos);
}

TEST(ReadSurface, NamesAFileItMayNotRead) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const TemporaryFolder folder;
  const auto path = folder.write("a.obj", kObj);
  std::filesystem::permissions(path, std::filesystem::perms::none);
  EXPECT_NE(input_error_of(path).find("permission"), std::string::npos);
}

TEST(ReadSurface, RefusesAnExtensionItDoesNotKnow) {
  EXPECT_NE(input_error_as("a.xyz", "1 2 3").find(".stl, .obj, .ply, .off, .3mf, .step"), std::string::npos);
  EXPECT_NE(input_error_as("a", kObj).find("no extension"), std::string::npos);
  EXPECT_NE(input_error_as("a.sat", "ISO-10303-21;\n").find("STEP"), std::string::npos);
}

TEST(ReadSurface, SaysWhatAFileUnderAWrongNameIs) {
  const std::string message = input_error_as("a.stl", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_NE(message.find("begins like an OFF file (.off); rename it"), std::string::npos) << message;
  EXPECT_NE(input_error_as("a.obj", "PK\x03\x04 and so on").find("ZIP"), std::string::npos);
}

TEST(ReadSurface, WeldsVerticesOfEveryFormat) {
  const TriangleMesh mesh = read_as("a.obj",
                                    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nv 1 0 -0\nv 0 1 0\nv 1 1 0\n"
                                    "f 1 2 3\nf 5 7 6\n");
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.triangles.size(), 2u);
}

TEST(ReadSurface, NeverCrashesOnNoise) {
  const TemporaryFolder folder;
  std::mt19937 random(5);
  for (const char* name : {"a.stl", "a.obj", "a.ply", "a.off"}) {
    for (int trial = 0; trial < 50; ++trial) {
      std::string noise(1 + random() % 3000, '\0');
      for (char& c : noise) c = static_cast<char>(random());
      input_error_of(folder.write(name, noise));
    }
  }
}

/// Flips bytes of sound files: what comes back is a surface with sound indices or one clear error.
TEST(ReadSurface, NeverCrashesOnDamagedFiles) {
  const std::map<std::string, std::string> sound = {
      {"a.obj", kObj + "f 1 3 2\nf 3 2 1 1 2\n"},
      {"a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n4 0 1 3 2\n3 0 1 2\n"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
       "element face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"a.stl",
       "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
       "endfacet\nendsolid\n"}};
  const TemporaryFolder folder;
  std::mt19937 random(6);
  for (const auto& [name, content] : sound) {
    for (int trial = 0; trial < 400; ++trial) {
      std::string damaged = content;
      for (int flips = 1 + trial % 4; flips > 0; --flips)
        damaged[random() % damaged.size()] =
            trial % 2 == 0 ? static_cast<char>(random()) : "0123456789 -\n.e"[random() % 15];
      const auto path = folder.write(name, damaged);
      try {
        const TriangleMesh mesh = read_surface(path);
        for (const auto& triangle : mesh.triangles)
          for (const std::uint32_t corner : triangle) ASSERT_LT(corner, mesh.vertices.size());
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::kInput);
      }
    }
  }
}

TEST(ReadSurface, ShowsNoMoreThanABitOfAnEndlessLine) {
  const std::string message = input_error_as("a.obj", "v " + std::string(10'000'000, 'x') + "\n");
  EXPECT_LT(message.size(), 300u);
}

/// Bounds the ear clipping of a polygon that somebody made to be slow; takes a second.
TEST(ReadSurface, GivesUpOnAPolygonThatWouldTakeForever) {
  std::string text;
  const int corners = 60'000;
  for (int i = 0; i < corners; ++i) {
    const double angle_rad = 2 * std::numbers::pi * i / corners, r = i % 2 == 0 ? 1.0 : 0.999;
    text += fmt::format("v {} {} 0\n", r * std::cos(angle_rad), r * std::sin(angle_rad));
  }
  text += "f";
  for (int i = 1; i <= corners; ++i) text += fmt::format(" {}", i);
  const std::string message = input_error_as("a.obj", text);
  EXPECT_NE(message.find("a.obj: line 60001: this polygon of"), std::string::npos) << message;
}

// The models of the shared folder.

std::filesystem::path shared_models() {
  const char* set = std::getenv("CROSSGRAIN_SHARED");
  return std::filesystem::path(set != nullptr ? set : CROSSGRAIN_DEFAULT_SHARED) / "models";
}

struct Model {
  std::string file;
  std::string vertices, triangles;  ///< as the manifest has them; empty where it does not know
};

/// The surface files of a manifest: those whose extension has a reader.
std::vector<Model> surface_models(const std::string& folder) {
  std::ifstream manifest(shared_models() / folder / "MANIFEST.tsv");
  std::vector<Model> models;
  std::string line;
  std::getline(manifest, line);
  while (std::getline(manifest, line)) {
    std::vector<std::string> fields;
    std::istringstream row(line);
    for (std::string field; std::getline(row, field, '\t');) fields.push_back(field);
    std::string extension = std::filesystem::path(fields.at(0)).extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (extension == ".stl" || extension == ".obj" || extension == ".ply" || extension == ".off")
      models.push_back({fields.at(0), fields.at(3), fields.at(4)});
  }
  return models;
}

TEST(SharedModels, GoodSurfacesHaveTheCountsOfTheManifest) {
  const auto models = surface_models("good");
  if (models.empty()) GTEST_SKIP() << "no models in " << shared_models();
  for (const Model& model : models) {
    SCOPED_TRACE(model.file);
    const TriangleMesh mesh = read_surface(shared_models() / "good" / model.file);
    EXPECT_EQ(std::to_string(mesh.vertices.size()), model.vertices);
    EXPECT_EQ(std::to_string(mesh.triangles.size()), model.triangles);
    EXPECT_GT(volume_of(mesh), 0);
  }
}

TEST(SharedModels, BadSurfacesGiveTheCountsOfTheManifestOrOneClearError) {
  const auto models = surface_models("bad");
  if (models.empty()) GTEST_SKIP() << "no models in " << shared_models();
  for (const Model& model : models) {
    SCOPED_TRACE(model.file);
    try {
      const TriangleMesh mesh = read_surface(shared_models() / "bad" / model.file);
      if (model.triangles.empty()) continue;
      EXPECT_EQ(std::to_string(mesh.vertices.size()), model.vertices);
      EXPECT_EQ(std::to_string(mesh.triangles.size()), model.triangles);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput);
      EXPECT_NE(std::string(error.what()).find(model.file), std::string::npos);
      // Nothing but these may be refused.
      EXPECT_TRUE(std::string("stl_empty_bin.stl obj_points.obj malformed.obj empty.ply invalid.off")
                      .find(model.file) != std::string::npos)
          << error.what();
    }
  }
}

TEST(SharedModels, OddWhiteSpaceAndContinuationsAreRead) {
  if (surface_models("bad").empty()) GTEST_SKIP() << "no models in " << shared_models();
  EXPECT_EQ(read_surface(shared_models() / "bad" / "whitespace.off").triangles.size(), 12u);
  EXPECT_GT(read_surface(shared_models() / "bad" / "wallhole.obj").triangles.size(), 0u);
}

}  // namespace
}  // namespace crossgrain
