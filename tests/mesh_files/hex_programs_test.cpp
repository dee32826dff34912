// SPDX-License-Identifier: Apache-2.0
// Files of hexahedra as other programs see them; tests are skipped where a program is not installed.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

#include "crossgrain/writing.hpp"
#include "files/temporary_folder.hpp"
#include "mesh_files/made_bricks.hpp"

namespace crossgrain {
namespace {

/// Exit code of check_hex_files.py where the program is not there.
constexpr int kNotInstalled = 77;

/// Writes the files that check_hex_files.py describes, and has it check them with a program.
int checked_with(const std::string& program) {
  const TemporaryFolder folder;
  HexMesh beam = made_bricks({8, 2, 2}, {80, 10, 10});
  for (const char* name : {"beam.msh", "beam.mesh", "beam.inp"}) write_hexahedra(beam, folder.path() / name);
  beam.regions.clear();
  for (HexMesh::Face& face : beam.boundary) face.tag = 0;
  write_hexahedra(beam, folder.path() / "untagged.inp");
  const std::string command =
      fmt::format("/usr/bin/python3 {}/mesh_files/check_hex_files.py {} {} > /dev/null",
                  CROSSGRAIN_TESTS_FOLDER, program, folder.path().string());
  return WEXITSTATUS(std::system(command.c_str()));
}

TEST(HexFiles, AreReadByGmshWithTheirGroups) {
  const int code = checked_with("gmsh");
  if (code == kNotInstalled) GTEST_SKIP() << "gmsh is not installed";
  EXPECT_EQ(code, 0);
}

TEST(HexFiles, AreReadByMeshioWithTheirGroupsAndSets) {
  const int code = checked_with("meshio");
  if (code == kNotInstalled) GTEST_SKIP() << "meshio is not installed";
  EXPECT_EQ(code, 0);
}

TEST(HexFiles, AreReadByAnIndependentReaderOfVtu) {
  if (std::system("/usr/bin/python3 -c pass") != 0) GTEST_SKIP() << "no /usr/bin/python3";
  const TemporaryFolder folder;
  for (const HexMesh& mesh : {made_bricks({8, 2, 2}, {80, 10, 10}), HexMesh{}}) {
    const auto path = folder.path() / "beam.vtu";
    write_hexahedra(mesh, path);
    const std::string command = fmt::format("/usr/bin/python3 {}/vtu/check_vtu.py {} > /dev/null",
                                            CROSSGRAIN_TESTS_FOLDER, path.string());
    EXPECT_EQ(std::system(command.c_str()), 0);
  }
}

/// A cantilever within 5 % of the beam of Euler and Bernoulli; pressure on the surfaces of all faces.
TEST(HexFiles, RunInCalculix) {
  const int code = checked_with("calculix");
  if (code == kNotInstalled) GTEST_SKIP() << "ccx is not installed";
  EXPECT_EQ(code, 0);
}

}  // namespace
}  // namespace crossgrain
