// SPDX-License-Identifier: Apache-2.0
// What a program that makes tets may do: be missing, crash, hang, lie, fill the disk. It is played by shell
// scripts in its place.
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "cad_reading/made_cad_files.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/features.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/tet_making.hpp"
#include "crossgrain/writing.hpp"
#include "files/temporary_folder.hpp"
#include "mesh_files/surface_files.hpp"
#include "results/result_files.hpp"
#include "support/shapes.hpp"
#include "tet_making/tet_making_tuning.hpp"
#include "tet_making/tets_of_makers.hpp"

namespace crossgrain {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A folder for temporary files, and a script in the place of gmsh. `$1` is the file of commands.
class FakeGmsh {
 public:
  explicit FakeGmsh(const std::string& script) {
#ifdef CROSSGRAIN_CAD_FILES
    cad_files();  // outside of this folder
#endif
    std::filesystem::create_directory(folder_.path() / "tmp");
    ::setenv("TMPDIR", (folder_.path() / "tmp").c_str(), 1);
    options_.gmsh = folder_.write("gmsh.sh", "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(options_.gmsh, std::filesystem::perms::owner_all);
    options_.maker = TetMaker::kGmsh;
    options_.size = 0.5;
    options_.seconds = 30;
  }
  ~FakeGmsh() {
    ::unsetenv("TMPDIR");
  }

  TetMakingTuning& options() {
    return options_;
  }
  const std::filesystem::path& folder() const {
    return folder_.path();
  }
  std::filesystem::path temporary_folder() const {
    return folder_.path() / "tmp";
  }

  TetMesh make(const Monitor& monitor = {}) const {
    return make_tets(make_box({1, 1, 1}), options_, monitor);
  }

  Error error(const Monitor& monitor = {}) const {
    try {
      make(monitor);
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      EXPECT_TRUE(std::filesystem::is_empty(temporary_folder()));
      return error;
    }
    ADD_FAILURE() << "no error";
    return Error(ErrorKind::kUsage, "");
  }

 private:
  TemporaryFolder folder_;
  TetMakingTuning options_;
};

void expect_words(const Error& error, ErrorKind kind, const std::vector<std::string>& words) {
  EXPECT_EQ(error.kind(), kind) << error.what();
  for (const std::string& word : words)
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
}

/// A script that runs gmsh itself.
std::string and_gmsh() {
  return "exec '" + gmsh_program().string() + "' \"$@\"";
}

TEST(TetMakingFailure, ACrashIsTold) {
  expect_words(FakeGmsh("kill -SEGV $$").error(), ErrorKind::kInput,
               {"gmsh crashed on it", "Segmentation fault", "another size"});
}

TEST(TetMakingFailure, AnErrorOfGmshIsPassedOn) {
  expect_words(FakeGmsh("echo 'Info    : so far'; echo 'Error   : No luck with surface 3' >&2").error(),
               ErrorKind::kInput, {"gmsh gives up on it (No luck with surface 3)", "another size"});
  expect_words(
      FakeGmsh("echo 'Error   : Invalid boundary mesh (overlapping facets) on surface 1' >&2").error(),
      ErrorKind::kInput, {"(Invalid boundary mesh (overlapping facets) on surface 1); unite its parts"});
  expect_words(FakeGmsh("exit 0").error(), ErrorKind::kInput, {"gmsh makes no tets of it"});
  expect_words(FakeGmsh("echo half > \"$(dirname \"$1\")/tets.msh\"").error(), ErrorKind::kInput,
               {"gmsh makes no tets of it"});
}

TEST(TetMakingFailure, AHangEndsWithItsTime) {
  FakeGmsh gmsh("sleep 1000; true");
  gmsh.options().seconds = 0.3;
  const auto start = Clock::now();
  expect_words(gmsh.error(), ErrorKind::kLimit, {"did not finish within 0.3 s", "allow more time"});
  EXPECT_LT(seconds_since(start), 20);
}

TEST(TetMakingFailure, AProcessThatTheSystemStopsIsTakenForOneWithoutMemory) {
  expect_words(FakeGmsh("kill -KILL $$").error(), ErrorKind::kLimit,
               {"the system stopped gmsh", "memory", "larger tets"});
}

TEST(TetMakingFailure, AMissingProgramNamesWhatToInstall) {
  FakeGmsh gmsh("");
  gmsh.options().gmsh = gmsh.folder() / "nowhere";
  expect_words(gmsh.error(), ErrorKind::kInput, {"cannot be started", "install gmsh"});
  const std::string path = ::getenv("PATH");
  ::setenv("PATH", "", 1);
  gmsh.options().gmsh.clear();
  expect_words(gmsh.error(), ErrorKind::kInput, {"not in PATH", "install gmsh"});
  ::setenv("PATH", path.c_str(), 1);
}

TEST(TetMakingFailure, IsKilledOnceTheMonitorIsCancelled) {
  const FakeGmsh gmsh("echo $$ > \"$(dirname \"$0\")/process\"; sleep 1000; true");
  Monitor monitor;
  std::thread interrupt([&] {
    while (content_of(gmsh.folder() / "process").find('\n') == std::string::npos)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    monitor.cancel();
  });
  const Error error = gmsh.error(monitor);
  interrupt.join();
  EXPECT_EQ(error.kind(), ErrorKind::kInterrupted);
  const pid_t process = std::stoi(content_of(gmsh.folder() / "process"));
  for (int k = 0; k < 1000 && ::kill(process, 0) == 0; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_NE(::kill(process, 0), 0);
}

TEST(TetMakingFailure, AFileThatIsTooLargeForTheSystemIsTold) {
  FakeGmsh gmsh("ulimit -f 1; yes > \"$(dirname \"$1\")/tets.msh\"; kill -XFSZ $$");
  expect_words(gmsh.error(), ErrorKind::kOutput, {"temporary files cannot be written", "TMPDIR"});
  ::signal(SIGXFSZ, SIG_IGN);
  rlimit before;
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit little{100, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &little);
  const Error error = gmsh.error();
  ::setrlimit(RLIMIT_FSIZE, &before);
  expect_words(error, ErrorKind::kOutput, {"temporary files cannot be written", "File too large"});
}

TEST(TetMakingFailure, APlaceForTemporaryFilesThatIsMissingIsTold) {
  const FakeGmsh gmsh("");
  std::filesystem::remove(gmsh.temporary_folder());
  EXPECT_THROW(gmsh.make(), Error);
}

/// It gives the tets of another box.
TEST(TetMakingFailure, TetsOfAnotherSurfaceAreNotBelieved) {
  if (!is_installed(TetMaker::kGmsh)) GTEST_SKIP() << "gmsh is not installed";
  FakeGmsh gmsh("cp \"$(dirname \"$0\")/other.msh\" \"$(dirname \"$1\")/tets.msh\"");
  TetMesh other = make_tets(make_box({1, 1, 2}), tets_of_size(0.5));
  write_tets(other, gmsh.folder() / "other.msh");
  expect_words(gmsh.error(), ErrorKind::kInput, {"did not keep the triangles of the surface"});
}

TEST(TetMakingFailure, IsFollowedByTheGivenTriangles) {
  if (!is_installed(TetMaker::kGmsh)) GTEST_SKIP() << "gmsh is not installed";
  const FakeGmsh gmsh(
      "test -e \"$(dirname \"$0\")/once\" || { touch \"$(dirname \"$0\")/once\"; exit 1; }\n" + and_gmsh());
  const TetMesh tets = gmsh.make();
  expect_sound(tets);
  EXPECT_EQ(tets.feature_faces.size(), 12u);
  ASSERT_EQ(tets.warnings.size(), 1u);
  EXPECT_EQ(tets.warnings[0].kind, WarningKind::kTetMaker);
}

#ifdef CROSSGRAIN_CAD_FILES

TEST(TetMakingFailure, OnCadFacesIsFollowedByTheTrianglesOfTheReader) {
  if (!is_installed(TetMaker::kGmsh)) GTEST_SKIP() << "gmsh is not installed";
  FakeGmsh gmsh("grep -q brep \"$1\" && kill -SEGV $$\n" + and_gmsh());
  gmsh.options().size = 3;
  const TetMesh tets = make_tets(cad_files() / "rounded.brep", gmsh.options());
  expect_sound(tets);
  EXPECT_EQ(tags_of(tets.feature_faces).size(), 26u);
  ASSERT_FALSE(tets.warnings.empty());
  EXPECT_EQ(tets.warnings.back().kind, WarningKind::kTetMaker);
}

TEST(TetMakingFailure, OnAnOpenShellNamesTheHole) {
  try {
    make_tets(cad_files() / "open.brep");
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    expect_words(error, ErrorKind::kInput,
                 {"open.brep", "1 hole: ", "edges around", "close these holes first"});
  }
}

#endif

/// What is said of a finding, of tets that are made all the same.
std::string said_of(const TriangleMesh& surface, const TetMakingOptions& options,
                    const std::string& finding) {
  const TetMesh tets = make_tets(surface, options);
  expect_sound(tets);
  for (const Warning& warning : tets.warnings)
    if (warning.text.starts_with(finding)) return warning.text;
  ADD_FAILURE() << "no word of " << finding;
  return "";
}

Error error_of(const TriangleMesh& surface, const TetMakingOptions& options = {}) {
  try {
    make_tets(surface, options);
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error";
  return Error(ErrorKind::kUsage, "");
}

TEST(TetsOfADamagedSurface, FillItsHolesAndNameTheLargest) {
  if (!is_installed(TetMaker::kGmsh)) GTEST_SKIP() << "gmsh is not installed";
  TriangleMesh sphere = make_sphere(1, 3);
  const auto remove_at = [&](const Vector3& place, double radius) {
    std::erase_if(sphere.triangles, [&](const auto& t) {
      return norm(sphere.vertices[t[0]] - place) < radius && norm(sphere.vertices[t[1]] - place) < radius &&
             norm(sphere.vertices[t[2]] - place) < radius;
    });
  };
  remove_at({0, 0, 1}, 0.3);
  remove_at({1, 0, 0}, 0.7);
  const std::string text = said_of(sphere, tets_of_size(0.3), "holes: 2");
  EXPECT_NE(text.find("filled with triangles"), std::string::npos) << text;
  std::istringstream places(text.substr(text.find(" at ") + 4));
  double x = 0;
  places >> x;
  EXPECT_GT(x, 0.5) << text;
}

TEST(TetsOfADamagedSurface, UnitePartsThatOverlap) {
  if (!is_installed(TetMaker::kGmsh)) GTEST_SKIP() << "gmsh is not installed";
  const TriangleMesh boxes =
      join_meshes(make_box({1, 1, 1}), translate_mesh(make_box({1, 1, 1}), {0.5, 0.3, 0.2}));
  const std::string text = said_of(boxes, tets_of_size(0.2), "overlapping components: 1");
  EXPECT_NE(text.find("merged into the surface around all"), std::string::npos) << text;
  const TetMesh tets = make_tets(boxes, tets_of_size(0.2));
  double volume = 0;
  for (const auto& [a, b, c, d] : tets.tets)
    volume += std::abs(dot(tets.vertices[b] - tets.vertices[a],
                           cross(tets.vertices[c] - tets.vertices[a], tets.vertices[d] - tets.vertices[a]))) /
              6;
  EXPECT_NEAR(volume, 2 - 0.5 * 0.7 * 0.8, 1e-9);
}

TEST(TetMakingRefusal, OfTooManyTetsComesBeforeTheWork) {
  TetMakingOptions options = tets_of_size(1e-3);
  const auto start = Clock::now();
  expect_words(error_of(make_box({1, 1, 1}), options), ErrorKind::kLimit,
               {"are to be expected", "larger tets"});
  EXPECT_LT(seconds_since(start), 5);
}

TEST(TetMakingRefusal, OfSizesThatDoNotSuitThePartTellsItsSize) {
  for (const double size : {2.0, 1e-5})
    expect_words(error_of(make_box({1, 1, 1}), tets_of_size(size)), ErrorKind::kUsage,
                 {"for the part, which is 1 across", "try tets of 0.05"});
}

TEST(TetMakingRefusal, OfOptionsOutOfRange) {
  TetMakingOptions options;
  options.size = -1;
  EXPECT_EQ(error_of(make_box({1, 1, 1}), options).kind(), ErrorKind::kUsage);
  options = {};
  options.edges_per_circle = std::nan("");
  EXPECT_EQ(error_of(make_box({1, 1, 1}), options).kind(), ErrorKind::kUsage);
}

TEST(TetMakingRefusal, OfAMeshOfTetsNamesTheFile) {
  const TemporaryFolder folder;
  const auto path =
      folder.write("a.mesh",
                   "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
                   "0 0 1 0\nTetrahedra\n1\n1 2 3 4 1\nEnd\n");
  try {
    make_tets(path);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    expect_words(error, ErrorKind::kInput, {"a.mesh", "holds tets already"});
  }
}

TetMesh small_mesh() {
  TetMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1.0 / 3}, {1e-17, -2e30, 5}};
  mesh.tets = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  mesh.regions = {1, 2};
  mesh.feature_faces = {{{0, 1, 2}, 7}, {{1, 2, 3}, 4}};
  mesh.feature_edges = {{{0, 1}, 3, true}, {{1, 2}, 4, true}};
  return mesh;
}

TEST(WriteTets, IsReadAgainToTheBit) {
  const TemporaryFolder folder;
  const TetMesh mesh = small_mesh();
  for (const char* name : {"a.mesh", "b.MSH"}) {
    SCOPED_TRACE(name);
    write_tets(mesh, folder.path() / name);
    const TetMesh got = read_tets(folder.path() / name);
    EXPECT_EQ(got.vertices, mesh.vertices);
    EXPECT_EQ(got.tets, mesh.tets);
    EXPECT_EQ(got.regions, mesh.regions);
    ASSERT_EQ(got.feature_faces.size(), 2u);
    ASSERT_EQ(got.feature_edges.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(got.feature_faces[k].vertices, mesh.feature_faces[k].vertices);
      EXPECT_EQ(got.feature_faces[k].tag, mesh.feature_faces[k].tag);
      EXPECT_EQ(got.feature_edges[k].vertices, mesh.feature_edges[k].vertices);
      EXPECT_EQ(got.feature_edges[k].tag, mesh.feature_edges[k].tag);
      EXPECT_TRUE(got.feature_edges[k].is_stated);
    }
    EXPECT_TRUE(is_own_file(folder.path() / name));
  }
}

TEST(WriteTets, TellsStatedEdgesFromOthers) {
  const TemporaryFolder folder;
  TetMesh mesh = small_mesh();
  mesh.feature_edges[0].is_stated = false;
  write_tets(mesh, folder.path() / "a.msh");
  const TetMesh from_msh = read_tets(folder.path() / "a.msh");
  ASSERT_EQ(from_msh.feature_edges.size(), 2u);
  EXPECT_FALSE(from_msh.feature_edges[0].is_stated);
  EXPECT_TRUE(from_msh.feature_edges[1].is_stated);
  write_tets(mesh, folder.path() / "a.mesh");
  const TetMesh from_medit = read_tets(folder.path() / "a.mesh");
  ASSERT_EQ(from_medit.feature_edges.size(), 1u);
  EXPECT_EQ(from_medit.feature_edges[0].tag, 4);
}

TEST(WriteTets, RefusesOtherFormats) {
  EXPECT_THROW(check_tets_output("a.vtk"), Error);
  EXPECT_THROW(write_tets(small_mesh(), "/nowhere/a.mesh"), Error);
}

}  // namespace
}  // namespace crossgrain
