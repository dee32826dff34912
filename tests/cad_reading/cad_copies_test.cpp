// SPDX-License-Identifier: Apache-2.0
// Faces and solids that a CAD file has twice.
#include <numbers>
#include <set>

#include "cad_reading/made_cad_files.hpp"
#include "mesh_files/surface_files.hpp"
#include "surface/topology.hpp"

#ifdef CROSSGRAIN_CAD_FILES

namespace crossgrain {
namespace {

constexpr double kPlate = 12000 - 250 * std::numbers::pi, kBall = 500 * std::numbers::pi / 3;

std::set<std::int32_t> solids_of(const TriangleMesh& mesh) {
  return {mesh.solids.begin(), mesh.solids.end()};
}

/// A model with one warning of copies, of which it has these words.
void expect_one_body(const std::string& name, double volume, const std::string& words) {
  SCOPED_TRACE(name);
  const TriangleMesh mesh = read_made(name);
  EXPECT_EQ(solids_of(mesh).size(), 1u);
  EXPECT_NEAR(volume_of(mesh), volume, 0.02 * volume);
  EXPECT_TRUE(analyse_topology(mesh).watertight);
  ASSERT_FALSE(mesh.warnings.empty());
  EXPECT_EQ(mesh.warnings[0].kind, WarningKind::kRepeatedBodies);
  EXPECT_NE(mesh.warnings[0].text.find(words), std::string::npos) << mesh.warnings[0].text;
}

void expect_as_they_are(const std::string& name, std::size_t bodies, double volume) {
  SCOPED_TRACE(name);
  const TriangleMesh mesh = read_made(name);
  EXPECT_EQ(solids_of(mesh).size(), bodies);
  EXPECT_NEAR(volume_of(mesh), volume, 1e-6);
  for (const Warning& warning : mesh.warnings) EXPECT_NE(warning.kind, WarningKind::kRepeatedBodies);
}

TEST(CadCopies, OfTheShellOfASolidAreNoBody) {
  const char* const words = "shells of faces that bound another body already, left out: 1";
  expect_one_body("own_shell.brep", kBall, words);
  expect_one_body("copied_shell.brep", kPlate, words);
  expect_one_body("copied_faces.brep", kPlate, words);
}

TEST(CadCopies, OfSomeFacesOfASolidAreNoBody) {
  expect_one_body("some_faces.brep", kPlate, "shells of faces that bound another body already, left out");
}

TEST(CadCopies, MayBeCutIntoFacesInAnotherWay) {
  expect_one_body("turned_shell.brep", kBall, "left out: 1");
}

TEST(CadCopies, OfASolidAreLeftOutAndTheOthersKeepTheirNumbers) {
  expect_one_body("twice.step", kPlate, "left out: 1; the first is solid 2, in the place of solid 1");
  EXPECT_EQ(solids_of(read_made("twice.step")), std::set<std::int32_t>{0});
}

TEST(CadCopies, OfLooseFacesAreLeftOut) {
  expect_one_body("doubled.iges", kPlate, "faces that lie on others, left out: 7");
}

TEST(CadCopies, LeaveTheFacesOfTheModelTheirNumbers) {
  std::set<std::int32_t> faces;
  for (const std::int32_t face : read_made("copied_shell.brep").faces) faces.insert(face);
  EXPECT_EQ(faces, (std::set<std::int32_t>{8, 9, 10, 11, 12, 13, 14}));  // those of the shell come first
}

TEST(CadCopies, AreNoneWhereSolidsOnlyHaveFacesInCommon) {
  expect_as_they_are("filled_void.brep", 2, 1000);
  expect_as_they_are("bricks.brep", 3, 18);
  expect_as_they_are("shell_beside.brep", 2, 18);
  expect_as_they_are("glued.brep", 2, 1500);
}

}  // namespace
}  // namespace crossgrain

#endif
