// SPDX-License-Identifier: Apache-2.0
#include "hex/model_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "base/vector3.hpp"
#include "measure/hex_faces.hpp"
#include "support/shapes.hpp"
#include "surface/surface.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

/// One hexahedron, the box from the origin to `high`, with tags of its six faces in the order of kHexFaces.
HexMesh brick(const Vector3& high, const std::array<std::int32_t, 6>& tags = {}) {
  HexMesh mesh;
  for (const auto& [x, y, z] : std::initializer_list<Vector3>{
           {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}})
    mesh.vertices.push_back({x * high[0], y * high[1], z * high[2]});
  mesh.hexahedra = {{0, 1, 2, 3, 4, 5, 6, 7}};
  for (std::size_t f = 0; f < 6; ++f) {
    HexMesh::Face& face = mesh.boundary.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) face.vertices[k] = kHexFaces[f][k];
    face.tag = tags[f];
  }
  return mesh;
}

TetSolid tets_of(TetMesh mesh) {
  std::vector<Warning> warnings;
  return prepare_tets(std::move(mesh), warnings);
}

/// A box of 4 by 3 by 2 as tets, made of a model that is given.
TetSolid box_of(std::optional<GivenModel> given = {}) {
  TetMesh mesh = TetBox{{4, 3, 2}}.mesh(0);
  if (given) mesh.given = std::make_shared<const GivenModel>(*std::move(given));
  return tets_of(std::move(mesh));
}

HexReport fit_of(const HexMesh& mesh, const TetSolid& tets, FitTo fit_to = FitTo::kCommonSurface) {
  HexReport report;
  report.hexahedra = mesh.hexahedra.size();
  report.size = report.used_size = 2;
  measure_fit(mesh, tets, fit_to, report);
  return report;
}

TEST(ModelFit, OfTetsThatWereReadIsToldBesideThese) {
  const TetSolid tets = box_of();
  const Box box = box_of_solid_triangles({tets.mesh.vertices, tets.boundary});
  HexMesh mesh = brick(box.high - box.low);
  for (Vector3& vertex : mesh.vertices) vertex += box.low;
  const HexReport report = fit_of(mesh, tets);
  EXPECT_EQ(report.model, ModelSource::kTets);
  EXPECT_NEAR(report.volume, report.model_volume, 1e-9);
  EXPECT_NEAR(report.area, report.model_area, 1e-9);
  EXPECT_LT(report.largest_distance, 1e-12);
  EXPECT_LT(report.largest_distance_of_model, 1e-12);
  EXPECT_FALSE(poor_fit(report));
}

TEST(ModelFit, OfSolidsMeshedApartIsToldBesideTheSurfacesOfEachOfThem) {
  const TetSolid bare = box_of();
  const Box box = box_of_solid_triangles({bare.mesh.vertices, bare.boundary});
  const TriangleMesh outer = make_box({4, 3, 2});
  GivenModel given{ModelSource::kCad, {}, {24, 64}, outer};
  for (Vector3& vertex : given.surface.vertices) vertex += box.low - box_of_solid_triangles(outer).low;
  // A wall across the middle, which the two solids share; hexahedra have it twice.
  const auto first = static_cast<std::uint32_t>(given.surface.vertices.size());
  for (const auto& [y, z] : {std::pair(0.0, 0.0), {3.0, 0.0}, {3.0, 2.0}, {0.0, 2.0}})
    given.surface.vertices.push_back(box.low + Vector3{2, y, z});
  given.between = {{first, first + 1, first + 2}, {first, first + 2, first + 3}};
  HexMesh mesh = brick({2, 3, 2});
  const HexMesh half = mesh;
  for (Vector3 vertex : half.vertices) mesh.vertices.push_back(vertex + Vector3{2, 0, 0});
  mesh.hexahedra.push_back({8, 9, 10, 11, 12, 13, 14, 15});
  for (HexMesh::Face face : half.boundary) {
    for (std::uint32_t& v : face.vertices) v += 8;
    mesh.boundary.push_back(face);
  }
  for (Vector3& vertex : mesh.vertices) vertex += box.low;
  // A vertex of both bodies inside the wall, so that it is off the common surface.
  const Vector3 inside = box.low + Vector3{2, 1, 1};
  mesh.vertices[2] = mesh.vertices[11] = inside;
  const TetSolid tets = box_of(given);
  EXPECT_LT(fit_of(mesh, tets, FitTo::kEachSolid).largest_distance, 1e-12);
  EXPECT_NEAR(fit_of(mesh, tets).largest_distance, 1, 1e-12) << "the wall is no part of the common surface";
  EXPECT_EQ(fit_of(mesh, tets, FitTo::kEachSolid).model, ModelSource::kCad);
  EXPECT_EQ(fit_of(mesh, tets, FitTo::kEachSolid).model_volume, 24);
  given.source = ModelSource::kSurface;
  EXPECT_EQ(fit_of(mesh, box_of(given), FitTo::kEachSolid).model, ModelSource::kTets);
}

TEST(ModelFit, OfAGivenModelIsToldBesideThatWithItsPlaces) {
  // The tets have less than the model, as facets in a cylinder have; the hexahedra fill the tets.
  const TetSolid bare = box_of();
  const Box box = box_of_solid_triangles({bare.mesh.vertices, bare.boundary});
  TriangleMesh larger = make_box({4, 3, 3});
  const Box its_box = box_of_solid_triangles(larger);
  for (Vector3& vertex : larger.vertices) vertex += box.low - its_box.low;
  const TetSolid tets = box_of(GivenModel{ModelSource::kCad, {}, {36, 66}, larger});
  HexMesh mesh = brick(box.high - box.low);
  for (Vector3& vertex : mesh.vertices) vertex += box.low;
  const HexReport report = fit_of(mesh, tets);
  EXPECT_EQ(report.model, ModelSource::kCad);
  EXPECT_EQ(report.model_volume, 36);
  EXPECT_EQ(report.model_area, 66);
  EXPECT_NEAR(report.volume, 24, 1e-9);
  EXPECT_NEAR(report.largest_distance, 0, 1e-12);
  EXPECT_NEAR(report.largest_distance_of_model, 1, 1e-12);
  EXPECT_NEAR(report.largest_distance_of_model_place[2], box.low[2] + 3, 1e-12);
}

TEST(ModelFit, IsPoorWithMuchLessVolumeOrFarFromTheSurface) {
  HexReport report;
  report.hexahedra = 1;
  report.size = report.used_size = 2;
  report.volume = 81, report.model_volume = 100;
  EXPECT_EQ(poor_fit(report)->text, "the hexahedra have 19 % less volume than the model");
  EXPECT_EQ(poor_fit(report)->kind, WarningKind::kPoorFit);
  report.volume = 100.5;
  EXPECT_FALSE(poor_fit(report));
  report.outcome = HexOutcome::kAllHex;
  report.size = 2;
  report.volume = 97;
  EXPECT_EQ(poor_fit(report)->text,
            "the hexahedra have 3 % less volume than the model, those of 1.1 about 1 %");
  EXPECT_EQ(poor_fit(report)->remedy, Remedy::kNone) << "what was tried is not known here";
  report.outcome = HexOutcome::kNone;
  report.volume = 100.5;
  report.largest_distance_of_model = 1.5;
  report.largest_distance_of_model_place = {4, 0, 2};
  EXPECT_EQ(
      poor_fit(report)->text,
      "the hexahedra miss parts of the model's surface by up to 1.5, at 4 0 2, which is 0.75 of the size");
  report.largest_distance = 1.6;
  EXPECT_EQ(poor_fit(report)->text,
            "the hexahedra are off the model's surface by up to 1.6, at 0 0 0, which is 0.8 of the size");
}

TEST(ModelFit, OfAWholeMeshWithMuchLessVolumeIsToldWithASizeThatBringsItNearer) {
  HexReport report;
  report.outcome = HexOutcome::kAllHex;
  report.hexahedra = 1;
  report.used_size = 3;
  report.area = 6 * 9;
  report.volume = 104.9, report.model_volume = 100;
  EXPECT_FALSE(size_for_volume(report, 6));
  report.volume = 78;
  EXPECT_EQ(words_of_volume(report), "its volume is 22 % below the model's");
  // What a chord cuts off falls with the square of its length: to 4 %.
  EXPECT_NEAR(*size_for_volume(report, 6), 1.2, 1e-12);
  EXPECT_FALSE(poor_fit(report));
  report.volume = 116;
  EXPECT_EQ(words_of_volume(report), "its volume is 16 % above the model's");
  EXPECT_NEAR(*size_for_volume(report, 6), 1.5, 1e-12);
  // Edges that are shorter than asked for already.
  EXPECT_NEAR(*size_for_volume(report, 4 * 6), 0.75, 1e-12);
  report.outcome = HexOutcome::kPartial;
  EXPECT_EQ(poor_fit(report)->text, "the hexahedra have 16 % more volume than the model");
}

TEST(FacesOff, AreThoseWhoseQuadsCoverAnotherArea) {
  std::vector<ModelFace> faces(3);
  HexReport report;
  report.outcome = HexOutcome::kAllHex;
  report.mean_edge = 1;
  report.model_volume = 1000;
  for (std::size_t k = 0; k < 3; ++k) {
    faces[k].number = static_cast<std::int64_t>(k + 1);
    faces[k].kind = FaceKind::kCylinder;
    faces[k].area = 10;
    faces[k].quads = 9;
    faces[k].quads_area = 9;
  }
  EXPECT_FALSE(faces_off(faces, report)) << "chords around a hole";
  faces[1].quads_area = 12;
  faces[2].quads_area = 7;
  EXPECT_EQ(
      faces_off(faces, report)->text,
      "the mesh moves the smooth border of 2 faces, and so changes the area: face 3 by -30 % of 10 around "
      "0 0 0; face 2 by +20 % of 10 around 0 0 0");
  report.mean_edge = 4;
  EXPECT_FALSE(faces_off(faces, report)) << "faces that are smaller than a quad";
  report.mean_edge = 1;
  report.interface_faces = 4;
  EXPECT_FALSE(faces_off(faces, report)) << "areas may have the part that is shared with another solid";
  report.interface_faces = 0;
  report.outcome = HexOutcome::kPartial;
  EXPECT_FALSE(faces_off(faces, report));
}

TEST(FacesWithoutQuads, AreThoseOnTheOutsideThatNoTagNames) {
  std::vector<ModelFace> faces(3);
  for (std::size_t k = 0; k < 3; ++k) faces[k].number = static_cast<std::int64_t>(k + 1);
  faces[2].solids = 2;
  count_quads(brick({1, 1, 1}, {1, 1, 1, 1, 1, 0}), faces);
  EXPECT_EQ(faces[0].quads_area, 5);
  EXPECT_EQ(faces[0].quads, 5u);
  EXPECT_EQ(faces[1].quads, 0u);
  EXPECT_FALSE(faces[2].quads);
  count_quads(brick({1, 1, 1}), faces);
  for (const ModelFace& face : faces) EXPECT_FALSE(face.quads);
}

TEST(FacesWithoutQuads, AreWarnedOfWithTheirWidth) {
  TetMesh mesh = TetBox{{4, 3, 2}}.mesh(0);
  const TetSolid untagged = tets_of(mesh);
  const Box box = box_of_solid_triangles({mesh.vertices, untagged.boundary});
  for (const auto& triangle : untagged.boundary) {
    const bool is_top = std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t v) {
      return mesh.vertices[v][2] > box.high[2] - 1e-9;
    });
    mesh.feature_faces.push_back({triangle, is_top ? 7 : 1});
  }
  const TetSolid tets = tets_of(mesh);
  ModelFace face{7, FaceKind::kPlane, 12, {2, 1.5, 2}};
  face.quads = 0;
  HexReport report;
  report.used_size = 3;
  report.model_volume = 24;
  const auto warning = faces_without_quads({face}, tets, report);
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->kind, WarningKind::kFacesWithoutQuads);
  EXPECT_EQ(
      warning->text,
      "1 face of the model has no quads: face 7, a plane of area 12 and about 2.4 wide, around 2 1.5 2; "
      "the hexahedra of 3 are larger; those of 2.4 would fit across (about 2), but finer ones may have no "
      "mesh");
  EXPECT_EQ(warning->remedy, Remedy::kNone) << "no order: finer ones may have no mesh";
  EXPECT_NEAR(*size_for_faces({face}, tets, report), 2.4, 1e-12);
  report.remedy = Remedy::kUseHexSize;
  const auto second = faces_without_quads({face}, tets, report);
  EXPECT_TRUE(second->text.ends_with("the hexahedra of 3 are larger")) << "the report names a size";
  report.remedy = Remedy::kNone;
  const auto many = faces_without_quads(std::vector<ModelFace>(8, face), tets, report);
  EXPECT_NE(many->text.find("8 faces of the model have no quads"), std::string::npos) << many->text;
  EXPECT_NE(many->text.find("; and 3 more"), std::string::npos) << many->text;
  face.quads = 1;
  EXPECT_FALSE(faces_without_quads({face}, tets, report));
  face.quads = 0;
  face.area = 0.01;
  const auto thin = faces_without_quads({face}, tets, report);
  EXPECT_NE(thin->text.find("; those of 0.002 would fit across, but so many are not made"), std::string::npos)
      << thin->text;
  EXPECT_FALSE(size_for_faces({face}, tets, report));
  report.used_size = 1;
  face.area = 12;
  EXPECT_EQ(faces_without_quads({face}, tets, report)->text.find("larger"), std::string::npos);
}

}  // namespace
}  // namespace crossgrain
