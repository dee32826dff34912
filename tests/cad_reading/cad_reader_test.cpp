// SPDX-License-Identifier: Apache-2.0
// CAD files, made on the spot by tests/cad_reading/make_cad_files.cpp, and those of the shared folder.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <set>
#include <thread>

#include "cad_reading/made_cad_files.hpp"
#include "mesh_files/surface_files.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

#ifndef CROSSGRAIN_CAD_FILES

TEST(ReadCad, NamesThePackagesThatTheProgramWasBuiltWithout) {
  const std::string message = input_error_as("a.step", "ISO-10303-21;\nEND-ISO-10303-21;\n");
  EXPECT_NE(message.find("libocct-data-exchange-dev"), std::string::npos) << message;
  GTEST_SKIP() << "built without OpenCASCADE: no CAD file is read";
}

#else

std::set<std::int32_t> distinct(const std::vector<std::int32_t>& numbers) {
  return {numbers.begin(), numbers.end()};
}

/// Corner normals are unit vectors on the side of their triangle.
void expect_normals_outward(const TriangleMesh& mesh) {
  ASSERT_EQ(mesh.corner_normals.size(), mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vector3 facet = cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
    for (const Vector3& normal : mesh.corner_normals[t]) {
      EXPECT_NEAR(norm(normal), 1, 1e-14);
      EXPECT_GT(dot(normal, normalised(facet)), 0.9);
    }
  }
}

Box box_of_vertices(const TriangleMesh& mesh) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (const Vector3& vertex : mesh.vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], vertex[axis]);
      box.high[axis] = std::max(box.high[axis], vertex[axis]);
    }
  }
  return box;
}

TEST(ReadCad, OfAPlateWithAHoleHasItsFacesAreaAndVolumeInEveryFormat) {
  constexpr double kPi = std::numbers::pi;
  for (const char* name : {"plate.step", "plate.iges", "plate.brep", "plate.brp", "inch.stp", "inch.igs"}) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = read_made(name);
    EXPECT_EQ(distinct(mesh.faces), (std::set<std::int32_t>{1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(distinct(mesh.solids), (std::set<std::int32_t>{0}));
    EXPECT_NEAR(volume_of(mesh), 12000 - 250 * kPi, 0.01 * 12000);
    EXPECT_NEAR(area_of(mesh), 2 * (1200 - 25 * kPi) + 1400 + 100 * kPi, 0.01 * 4000);
    EXPECT_TRUE(analyse_topology(mesh).watertight);
    EXPECT_EQ(mesh.creases.size(), 14u);
    EXPECT_TRUE(mesh.warnings.empty()) << sentence_of(mesh.warnings.front());
    expect_normals_outward(mesh);
  }
}

TEST(ReadCad, NormalsOfACylinderAreRadialToRounding) {
  for (const char* name : {"cylinder.brep", "cylinder.step"}) {
    const TriangleMesh mesh = read_made(name);
    std::size_t on_side = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const Vector3& normal = mesh.corner_normals[t][corner];
        const Vector3& at = mesh.vertices[mesh.triangles[t][corner]];
        if (std::abs(normal[2]) > 0.5) {
          EXPECT_NEAR(std::abs(normal[2]), 1, 1e-14);
          continue;
        }
        ++on_side;
        EXPECT_LT(norm(normal - 0.2 * Vector3{at[0] - 3, at[1] - 4, 0}), 1e-12);
      }
    }
    EXPECT_GT(on_side, 100u);
  }
}

TEST(ReadCad, NormalsOfASphereAreRadialAtItsPolesToo) {
  const TriangleMesh mesh = read_made("sphere.brep");
  EXPECT_TRUE(analyse_topology(mesh).watertight);
  EXPECT_TRUE(mesh.creases.empty());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vector3 radius = mesh.vertices[mesh.triangles[t][corner]] - Vector3{3, 4, 5};
      // At the poles the surface is asked a millionth of a facet beside.
      EXPECT_LT(norm(mesh.corner_normals[t][corner] - 0.2 * radius), 1e-6);
    }
  }
}

TEST(ReadCad, TrianglesOfAConeMeetInItsApex) {
  const TriangleMesh mesh = read_made("cone.brep");
  EXPECT_TRUE(analyse_topology(mesh).watertight);
  EXPECT_EQ(mesh.creases.size(), 1u);
  expect_normals_outward(mesh);
}

TEST(ReadCad, TrianglesAreWithinATenthOfACellOfTheSurface) {
  for (const int resolution : {32, 128, 512}) {
    CadReading options;
    options.resolution = resolution;
    const TriangleMesh mesh = read_made("cylinder.brep", options);
    double farthest = 0;
    for (const auto& triangle : mesh.triangles) {
      Vector3 middle{0, 0, 0};
      for (const std::uint32_t vertex : triangle) middle += 1.0 / 3 * mesh.vertices[vertex];
      if (middle[2] < 5 + 1e-9 || middle[2] > 25 - 1e-9) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector3 edge =
            0.5 * (mesh.vertices[triangle[k]] + mesh.vertices[triangle[(k + 1) % 3]]) - Vector3{3, 4, 0};
        farthest = std::max(farthest, 5 - std::hypot(edge[0], edge[1]));
      }
    }
    EXPECT_LT(farthest, 0.1 * 20 / resolution);
  }
}

TEST(ReadCad, ACellSizeCutsAsTheResolutionItComesTo) {
  CadReading by_resolution, by_size;
  by_resolution.resolution = 1000;
  by_size.cell_size = 20.0 / 1000;
  const TriangleMesh mesh = read_made("cylinder.brep", by_size);
  EXPECT_GT(mesh.triangles.size(), read_made("cylinder.brep").triangles.size());
  EXPECT_NEAR(static_cast<double>(mesh.triangles.size()),
              static_cast<double>(read_made("cylinder.brep", by_resolution).triangles.size()),
              0.05 * static_cast<double>(mesh.triangles.size()));
}

TEST(ReadCad, AFarTooFineResolutionIsNotCutForever) {
  CadReading options;
  options.resolution = std::numeric_limits<int>::max();
  EXPECT_LT(read_made("cylinder.brep", options).triangles.size(), 100'000u);
}

TEST(ReadCad, CreasesAreSharpEdgesAndNoSeams) {
  EXPECT_EQ(read_made("box.brep").creases.size(), 12u);
  EXPECT_EQ(read_made("cylinder.brep").creases.size(), 2u);
  EXPECT_EQ(read_made("rounded.brep").creases.size(), 0u);
}

TEST(ReadCad, AnglesBelowTheCreaseAngleAreNone) {
  CadReading options;
  options.crease_angle_deg = 89;
  EXPECT_EQ(read_made("cone.brep", options).creases.size(), 1u);  // 116.6 degrees
  EXPECT_EQ(read_made("box.brep", options).creases.size(), 12u);
  options.crease_angle_deg = 91;
  EXPECT_EQ(read_made("box.brep", options).creases.size(), 0u);
}

TEST(ReadCad, CreasesRunThroughVerticesWithTheTangentsOfTheCurve) {
  const TriangleMesh mesh = read_made("cylinder.brep");
  const std::set<Vector3> vertices(mesh.vertices.begin(), mesh.vertices.end());
  for (const CreaseCurve& crease : mesh.creases) {
    ASSERT_EQ(crease.points.size(), crease.tangents.size());
    EXPECT_EQ(crease.points.front(), crease.points.back());
    EXPECT_GT(crease.tag, 0);
    for (std::size_t i = 0; i < crease.points.size(); ++i) {
      EXPECT_EQ(vertices.count(crease.points[i]), 1u);
      const Vector3 radius = 0.2 * (crease.points[i] - Vector3{3, 4, crease.points[i][2]});
      EXPECT_NEAR(norm(radius), 1, 1e-12);
      EXPECT_LT(norm(crease.tangents[i] - cross(Vector3{0, 0, 1}, radius)), 1e-12);
      const Vector3 step = crease.points[i] - crease.points[i == 0 ? 0 : i - 1];
      EXPECT_GE(dot(step, crease.tangents[i]), 0);
    }
  }
}

TEST(ReadCad, AFaceBetweenTwoSolidsIsThereOnceForEach) {
  const TriangleMesh mesh = read_made("glued.brep");
  EXPECT_EQ(distinct(mesh.solids), (std::set<std::int32_t>{0, 1}));
  EXPECT_EQ(distinct(mesh.faces).size(), 11u);
  EXPECT_EQ(mesh.creases.size(), 20u);
  double volumes[2] = {0, 0}, turned[2] = {0, 0};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto solid = static_cast<std::size_t>(mesh.solids[t]);
    volumes[solid] += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c])) / 6;
    if (mesh.vertices[a][0] == 10 && mesh.vertices[b][0] == 10 && mesh.vertices[c][0] == 10)
      turned[solid] = mesh.corner_normals[t][0][0];
  }
  EXPECT_NEAR(volumes[0], 1000, 1e-9);
  EXPECT_NEAR(volumes[1], 500, 1e-9);
  EXPECT_EQ(turned[0], 1);
  EXPECT_EQ(turned[1], -1);
}

TEST(ReadCad, PartsOfAnAssemblyStandAtTheirPlaces) {
  for (const char* name : {"assembly.brep", "assembly.step"}) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = read_made(name);
    EXPECT_EQ(distinct(mesh.solids), (std::set<std::int32_t>{0, 1}));
    EXPECT_EQ(distinct(mesh.faces).size(), 12u);
    EXPECT_EQ(mesh.creases.size(), 24u);
    EXPECT_NEAR(volume_of(mesh), 2000, 1e-9);
    EXPECT_TRUE(analyse_topology(mesh).watertight);
    const Box box = box_of_vertices(mesh);
    EXPECT_NEAR(box.low[0], 0, 1e-9);
    EXPECT_NEAR(box.high[0], 100, 1e-9);
    EXPECT_NEAR(box.high[1], 20, 1e-9);
    EXPECT_NEAR(box.high[2], 5, 1e-9);
    expect_normals_outward(mesh);
  }
}

TEST(ReadCad, ASolidInsideOutIsTurned) {
  const TriangleMesh mesh = read_made("inside_out.brep");
  EXPECT_NEAR(volume_of(mesh), 6, 1e-12);
  EXPECT_EQ(mesh.creases.size(), 12u);
  expect_normals_outward(mesh);
}

TEST(ReadCad, LengthsAreMillimetresAndTheUnitOfTheFileIsTold) {
  for (const auto& [name, unit] :
       {std::pair{"plate.step", "mm"}, {"inch.stp", "inch"}, {"plate.iges", "mm"}, {"inch.igs", "inch"}}) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = read_made(name);
    EXPECT_EQ(mesh.unit, "mm");
    EXPECT_EQ(mesh.file_unit, unit);
    EXPECT_NEAR(box_of_vertices(mesh).high[0], 40, 1e-6);
  }
  EXPECT_EQ(read_made("plate.brep").unit, "");
  EXPECT_EQ(read_made("plate.brep").file_unit, "");
}

/// A made STEP file with `to` in place of each `from`, of which there must be some.
TriangleMesh read_with(const char* name, const std::string& from, const std::string& to,
                       std::size_t most = 99) {
  std::string content = content_of(cad_files() / name);
  std::size_t place = content.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  for (; place != std::string::npos && most-- > 0; place = content.find(from, place + to.size()))
    content.replace(place, from.size(), to);
  const TemporaryFolder folder;
  return read_surface(folder.write("a.step", content));
}

bool warns_of_units(const TriangleMesh& mesh) {
  return std::any_of(mesh.warnings.begin(), mesh.warnings.end(),
                     [](const Warning& warning) { return warning.kind == WarningKind::kUnknownUnit; });
}

TEST(ReadCad, TheUnitOfAStepFileIsThatOfTheContextsOfItsShapes) {
  // As NIST's parts in AP242 have it.
  const TriangleMesh inches =
      read_with("inch.stp", "LENGTH_MEASURE_WITH_UNIT(25.4,", "MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),");
  EXPECT_EQ(inches.file_unit, "inch");
  EXPECT_FALSE(warns_of_units(inches));
  EXPECT_NEAR(box_of_vertices(inches).high[0], 40, 1e-6);

  const TriangleMesh metres = read_with("plate.step", "SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT($,.METRE.)");
  EXPECT_EQ(metres.file_unit, "m");
  EXPECT_NEAR(box_of_vertices(metres).high[0], 40'000, 1e-3);

  // The first of two contexts, that of the assembly, holds no shape itself.
  EXPECT_EQ(read_with("assembly.step", "SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT(.CENTI.,.METRE.)", 1).file_unit,
            "mm");
  EXPECT_EQ(read_with("assembly.step", "SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT(.CENTI.,.METRE.)").file_unit,
            "cm");
}

TEST(ReadCad, AStepFileWithoutAUnitGetsAWarning) {
  const TriangleMesh mesh = read_with("plate.step", "LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.)",
                                      "NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT()");
  EXPECT_EQ(mesh.file_unit, "");
  EXPECT_TRUE(warns_of_units(mesh));
  EXPECT_NEAR(box_of_vertices(mesh).high[0], 40, 1e-6);
}

TEST(ReadCad, FacesWithoutASolidAreSewnWithAWarning) {
  for (const char* name : {"loose.brep", "shell.brep", "faces.iges"}) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = read_made(name);
    EXPECT_TRUE(analyse_topology(mesh).watertight);
    EXPECT_GT(volume_of(mesh), 5.9);
    EXPECT_EQ(distinct(mesh.solids), (std::set<std::int32_t>{0}));
    ASSERT_EQ(mesh.warnings.size(), 1u);
    EXPECT_NE(mesh.warnings[0].text.find("no solids, only faces, which form shells: 1 closed and 0 open"),
              std::string::npos)
        << mesh.warnings[0].text;
  }
}

TEST(ReadCad, AnOpenShellIsReadWithAWarning) {
  const TriangleMesh mesh = read_made("open.brep");
  EXPECT_EQ(distinct(mesh.faces).size(), 5u);
  EXPECT_EQ(mesh.creases.size(), 8u);  // the four edges of one face are none
  EXPECT_FALSE(analyse_topology(mesh).watertight);
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_NE(mesh.warnings[0].text.find("0 closed and 1 open"), std::string::npos) << mesh.warnings[0].text;
}

TEST(ReadCad, RefusesWhatHasNoFaces) {
  EXPECT_NE(input_error_of(cad_files() / "curve.brep").find("has no faces"), std::string::npos);
}

TEST(ReadCad, RefusesAFaceWithoutBounds) {
  EXPECT_NE(input_error_of(cad_files() / "endless.brep").find("without bounds"), std::string::npos);
}

TEST(ReadCad, RefusesOpenFacesAlone) {
  for (const char* name : {"face.brep", "faces_apart.brep"}) {
    const std::string message = input_error_of(cad_files() / name);
    EXPECT_NE(message.find("encloses nothing; close it"), std::string::npos) << message;
  }
}

TEST(ReadCad, RefusesOptionsOutOfRange) {
  for (const CadReading& options :
       {CadReading{{.facet_angle_deg = 91}}, CadReading{{.crease_angle_deg = std::nan("")}}})
    EXPECT_THROW(read_made("box.brep", options), Error);
}

TEST(ReadCad, SaysNothingOnTheStreams) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  for (const char* name : {"plate.step", "plate.iges", "plate.brep", "faces.iges"}) read_made(name);
  const TemporaryFolder folder;
  input_error_of(folder.write("a.step", "ISO-10303-21;\nnonsense\nEND-ISO-10303-21;\n"));
  std::cout << "heard";
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "heard");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ReadCad, GivesTheSameBitsOnEveryRunAndFromTwoThreadsAtOnce) {
  const TriangleMesh once = read_made("rounded.brep"), plate = read_made("plate.step");
  TriangleMesh again;
  std::thread other([&] { again = read_made("rounded.brep"); });
  expect_same(read_made("plate.step"), plate);
  other.join();
  expect_same(again, once);
}

// The models of the shared folder.

TEST(SharedModels, CadModelsAreWatertightSolids) {
  const char* set = std::getenv("CROSSGRAIN_SHARED");
  const auto models =
      std::filesystem::path(set != nullptr ? set : CROSSGRAIN_DEFAULT_SHARED) / "models" / "good";
  if (!std::filesystem::exists(models)) GTEST_SKIP() << "no models in " << models;
  const std::vector<std::pair<const char*, std::size_t>> faces = {{"base_interface_AP214.STEP", 30},
                                                                  {"featuretype.STEP", 96},
                                                                  {"i02o_m2.step", 28},
                                                                  {"i10o_simp.step", 11},
                                                                  {"s11o_cube_cyl.stp", 8}};
  for (const auto& [name, count] : faces) {
    SCOPED_TRACE(name);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const TriangleMesh mesh = read_surface(models / name);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(distinct(mesh.faces).size(), count);
    EXPECT_EQ(distinct(mesh.solids).size(), 1u);
    EXPECT_GT(volume_of(mesh), 0);
    EXPECT_TRUE(analyse_topology(mesh).watertight);
    EXPECT_GT(mesh.creases.size(), 0u);
    EXPECT_EQ(mesh.unit, "mm");
    EXPECT_TRUE(mesh.warnings.empty()) << sentence_of(mesh.warnings.front());
  }
}

#endif

}  // namespace
}  // namespace crossgrain
