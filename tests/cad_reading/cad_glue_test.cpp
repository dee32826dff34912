// SPDX-License-Identifier: Apache-2.0
// Solids that touch, glued while they are read: ReadOptions::glue.
#include <map>
#include <numbers>
#include <set>

#include "cad_reading/made_cad_files.hpp"
#include "mesh_files/surface_files.hpp"
#include "surface/topology.hpp"

#ifdef CROSSGRAIN_CAD_FILES

namespace crossgrain {
namespace {

TriangleMesh read_glued(const std::string& name) {
  CadReading options;
  options.glue = true;
  return read_made(name, options);
}

double area_of_triangle(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  return norm(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a])) / 2;
}

/// The area of triangles that two solids have in opposite orientations.
double shared_area(const TriangleMesh& mesh) {
  std::map<std::set<std::uint32_t>, std::int32_t> seen;
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::set<std::uint32_t> corners(mesh.triangles[t].begin(), mesh.triangles[t].end());
    const auto [place, is_new] = seen.try_emplace(corners, mesh.solids[t]);
    if (is_new) continue;
    EXPECT_NE(place->second, mesh.solids[t]);
    area += area_of_triangle(mesh, mesh.triangles[t]);
  }
  return area;
}

/// The volume that the triangles of each solid enclose.
std::map<std::int32_t, double> volumes_of(const TriangleMesh& mesh) {
  std::map<std::int32_t, double> volumes;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    volumes[mesh.solids[t]] += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c])) / 6;
  }
  return volumes;
}

TEST(GlueCad, SolidsShareTheTrianglesOfThePartOfAFaceWhereTheyTouch) {
  constexpr double kPi = std::numbers::pi;
  struct Case {
    const char* name;
    double area, volume, other_volume;
    double area_before = 0;  ///< faces that are alike share their triangles even without glue
  };
  const double facets = 0.01;
  for (const Case& expected : {Case{"stacked.brep", 42, 4000, 210}, Case{"offset.brep", 50, 1000, 1000},
                               Case{"pocket.step", 4 * 24 + 16, 1000 - 96, 96, 4 * 24 + 16},
                               Case{"pin.step", 100 * kPi, 12000 - 250 * kPi, 500 * kPi}}) {
    SCOPED_TRACE(expected.name);
    EXPECT_NEAR(shared_area(read_made(expected.name)), expected.area_before, 1e-9);
    const TriangleMesh mesh = read_glued(expected.name);
    EXPECT_NEAR(shared_area(mesh), expected.area, facets * expected.area);
    const std::map<std::int32_t, double> volumes = volumes_of(mesh);
    ASSERT_EQ(volumes.size(), 2u);
    EXPECT_NEAR(volumes.at(0), expected.volume, facets * expected.volume);
    EXPECT_NEAR(volumes.at(1), expected.other_volume, facets * expected.other_volume);
    EXPECT_TRUE(mesh.warnings.empty());
  }
}

TEST(GlueCad, FacesKeepTheirNumbers) {
  const TriangleMesh apart = read_made("stacked.brep"), glued = read_glued("stacked.brep");
  const auto area_by_face = [](const TriangleMesh& mesh) {
    std::map<std::int32_t, double> areas;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      areas[mesh.faces[t]] += area_of_triangle(mesh, mesh.triangles[t]);
    return areas;
  };
  std::map<std::int32_t, double> before = area_by_face(apart);
  const std::map<std::int32_t, double> after = area_by_face(glued);
  // The bottom of the small box has become part of the top of the large one, which has it on both sides.
  EXPECT_EQ(after.size() + 1, before.size());
  for (const auto& [face, area] : after)
    EXPECT_NEAR(area, before.at(face) + (before.at(face) == 400 && area > 401 ? 42 : 0), 1e-9) << face;
}

TEST(GlueCad, WhatTwoSolidsHoldBelongsToTheSmaller) {
  const TriangleMesh mesh = read_glued("overlapping.brep");
  const std::map<std::int32_t, double> volumes = volumes_of(mesh);
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes.at(0), 820, 1e-9);
  EXPECT_NEAR(volumes.at(1), 360, 1e-9);
  // The walls of the overlap and its end, without the section of the small box where it leaves the large one.
  EXPECT_NEAR(shared_area(mesh), 4 * 30 + 36, 1e-9);
}

TEST(GlueCad, LeavesOneSolidAndSolidsApartAsTheyAre) {
  expect_same(read_glued("plate.step"), read_made("plate.step"));
  EXPECT_EQ(shared_area(read_glued("assembly.step")), 0);
  EXPECT_NEAR(shared_area(read_glued("glued.brep")), 100, 1e-9);
}

TEST(GlueCad, GivesTheSameBitsOnEveryRun) {
  expect_same(read_glued("pin.step"), read_glued("pin.step"));
}

TEST(GlueCad, FailsWithOneLineWhereAVolumeWouldChange) {
  CadReading options;
  options.glue = true;
  options.glue_gap = 0.3;
  try {
    read_made("stacked.brep", options);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(message.find("cannot glue"), std::string::npos) << message;
    EXPECT_NE(message.find("without gluing"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace crossgrain

#endif
