// SPDX-License-Identifier: Apache-2.0
// Tets made by gmsh, measured against the shapes that they fill; without gmsh the tests are skipped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/ascending.hpp"
#include "base/vector3.hpp"
#include "cad_reading/made_cad_files.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/tet_domain.hpp"
#include "crossgrain/tet_making.hpp"
#include "support/nightly.hpp"
#include "support/shapes.hpp"
#include "tet_making/tet_making_tuning.hpp"
#include "tet_making/tets_of_makers.hpp"

namespace crossgrain {
namespace {

class MakeTets : public testing::TestWithParam<TetMaker> {
 protected:
  void SetUp() override {
    if (!is_installed(GetParam())) GTEST_SKIP() << name_of(GetParam()) << " is not installed";
  }
  TetMesh made(const TriangleMesh& surface, double size) const {
    TetMakingOptions options = tets_of_size(size);
    options.maker = GetParam();
    return make_tets(surface, options);
  }
};

std::string named(const testing::TestParamInfo<TetMaker>& info) {
  return info.param == TetMaker::kGmsh ? "Gmsh" : "Netgen";
}

INSTANTIATE_TEST_SUITE_P(By, MakeTets, testing::Values(TetMaker::kGmsh, TetMaker::kNetgen), named);

TEST_P(MakeTets, FillsABox) {
  const TetMesh box = made(make_box({1, 2, 3}), 0.4);
  expect_sound(box);
  EXPECT_NEAR(volume_of(box), 6, 1e-9);
  EXPECT_EQ(tags_of(box.feature_faces), (std::set<std::int32_t>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(tags_of(box.feature_edges).size(), 12u);
  EXPECT_EQ(std::set<std::int32_t>(box.regions.begin(), box.regions.end()), (std::set<std::int32_t>{1}));
  EXPECT_TRUE(box.warnings.empty());
}

TEST_P(MakeTets, TagsEveryBoundaryTriangleAndEveryEdgeOfACrease) {
  const TetMesh box = made(make_box({1, 1, 1}), 0.3);
  std::set<std::array<std::uint32_t, 3>> tagged;
  for (const TetMesh::Face& face : box.feature_faces)
    EXPECT_TRUE(tagged.insert(ascending(face.vertices)).second);
  EXPECT_EQ(tagged.size(), TetDomain(box).boundary().triangles.size());
  double length = 0;
  std::set<std::array<std::uint32_t, 2>> edges;
  for (const TetMesh::Edge& edge : box.feature_edges) {
    EXPECT_TRUE(edge.is_stated);
    EXPECT_TRUE(edges.insert(ascending(edge.vertices)).second);
    length += norm(box.vertices[edge.vertices[0]] - box.vertices[edge.vertices[1]]);
  }
  EXPECT_NEAR(length, 12, 1e-9);
}

TEST_P(MakeTets, FollowsASphereAndNotItsTriangles) {
  const TetMesh sphere = made(make_sphere(1, 4), 0.3);
  expect_sound(sphere);
  EXPECT_NEAR(volume_of(sphere), 4.0 / 3 * M_PI, 0.15);
  EXPECT_EQ(tags_of(sphere.feature_faces).size(), 1u);
  EXPECT_TRUE(sphere.feature_edges.empty());
  EXPECT_GT(quality_of(sphere).worst, 0.1);
}

TEST_P(MakeTets, LeavesVoidsEmpty) {
  const TriangleMesh shell = join_meshes(make_box({3, 3, 3}), flip_mesh(make_box({1, 1, 1})));
  const TetMesh tets = made(shell, 0.6);
  expect_sound(tets);
  EXPECT_NEAR(volume_of(tets), 26, 1e-8);
  EXPECT_EQ(tags_of(tets.feature_faces).size(), 12u);
}

TEST_P(MakeTets, NumbersSeparateBodiesAsRegions) {
  const TriangleMesh boxes = join_meshes(make_box({1, 1, 1}), translate_mesh(make_box({2, 1, 1}), {3, 0, 0}));
  const TetMesh tets = made(boxes, 0.5);
  expect_sound(tets);
  std::map<std::int32_t, double> volumes = volumes_of_regions(tets);
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes[1], 1, 1e-9);
  EXPECT_NEAR(volumes[2], 2, 1e-9);
}

TEST_P(MakeTets, MendsASurfaceFirst) {
  TriangleMesh box = to_soup(make_box({1, 1, 1}));
  std::swap(box.triangles[3][0], box.triangles[3][1]);
  const TetMesh tets = made(box, 0.5);
  EXPECT_NEAR(volume_of(tets), 1, 1e-9);
  ASSERT_EQ(tets.warnings.size(), 1u);
  EXPECT_EQ(tets.warnings[0].kind, WarningKind::kSurfaceFinding);
}

/// Both halves of a box write their vertices as they round them.
TEST_P(MakeTets, ClosesCracksThatRoundingLeaves) {
  TriangleMesh box = to_soup(make_box({1, 1, 1}));
  for (std::size_t v = 0; v < box.vertices.size() / 2; ++v) box.vertices[v][2] += 1e-9;
  const TetMesh tets = made(box, 0.5);
  EXPECT_NEAR(volume_of(tets), 1, 1e-8);
  ASSERT_EQ(tets.warnings.size(), 1u);
  EXPECT_NE(tets.warnings[0].text.find("merged"), std::string::npos);
}

TEST_P(MakeTets, IsTheSameTwice) {
  const TriangleMesh torus = make_torus(2, 0.7, 24, 12);
  const TetMesh first = made(torus, 1), second = made(torus, 1);
  EXPECT_EQ(first.vertices, second.vertices);
  EXPECT_EQ(first.tets, second.tets);
}

TEST_P(MakeTets, IsAlsoOfTheWantedSize) {
  for (const double size : {0.5, 0.25}) {
    const TetMesh box = made(make_box({1, 1, 1}), size);
    const double typical = TetDomain(box).typical_edge_length();
    EXPECT_GT(typical, 0.5 * size);
    EXPECT_LT(typical, 1.2 * size);
  }
}

#ifdef CROSSGRAIN_CAD_FILES

TetMesh made_cad(const std::string& name, TetMaker maker, double size = 0) {
  TetMakingOptions options = tets_of_size(size);
  options.maker = maker;
  return make_tets(cad_files() / name, options);
}

/// The triangles of each face, by a reader that knows nothing of tets.
TriangleMesh fine_faces(const std::string& name) {
  CadReading options;
  options.resolution = 100;
  options.facet_angle_deg = 5;
  return read_made(name, options);
}

/// Largest distance of tagged triangles' middles from the triangles of the face that their tag names.
double farthest_from_face(const TetMesh& tets, const TriangleMesh& faces) {
  std::map<std::int32_t, std::vector<std::array<Vector3, 3>>> by_face;
  for (std::size_t t = 0; t < faces.triangles.size(); ++t) {
    const auto& [a, b, c] = faces.triangles[t];
    by_face[faces.faces[t]].push_back({faces.vertices[a], faces.vertices[b], faces.vertices[c]});
  }
  EXPECT_EQ(tags_of(tets.feature_faces), keys_of(by_face));
  double farthest = 0;
  for (const TetMesh::Face& face : tets.feature_faces)
    farthest = std::max(farthest, distance_to(by_face[face.tag], middle_of(tets, face.vertices)));
  return farthest;
}

/// Largest distance of stated edges' middles from the crease that their tag names.
double farthest_from_crease(const TetMesh& tets, const TriangleMesh& faces) {
  std::map<std::int32_t, std::vector<Vector3>> creases;
  for (const CreaseCurve& crease : faces.creases) creases[crease.tag] = crease.points;
  double farthest = 0;
  std::set<std::int32_t> stated;
  for (const TetMesh::Edge& edge : tets.feature_edges) {
    EXPECT_EQ(edge.is_stated, creases.contains(edge.tag)) << edge.tag;
    if (!edge.is_stated) continue;
    stated.insert(edge.tag);
    farthest = std::max(farthest, distance_to(creases[edge.tag], middle_of(tets, edge.vertices)));
  }
  EXPECT_EQ(stated, keys_of(creases));
  return farthest;
}

TEST_P(MakeTets, GivesTrianglesTheNumbersOfTheirCadFacesAndEdges) {
  std::vector<std::string> names{"plate.iges", "cone.brep"};
  if (is_nightly())
    names.insert(names.end(), {"cylinder.step", "loose.brep", "plate.step", "faces.iges", "rounded.brep",
                               "shell.brep", "inside_out.brep", "assembly.step"});
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const TriangleMesh faces = fine_faces(name);
    const double side = longest_side(box_of(faces.vertices));
    const TetMesh tets = made_cad(name, GetParam());
    expect_sound(tets);
    // Flat triangles of a twentieth of the side, 18 around a circle, are this far from a curved face.
    EXPECT_LT(farthest_from_face(tets, faces), 0.006 * side);
    EXPECT_LT(farthest_from_crease(tets, faces), 0.006 * side);
  }
}

TEST_P(MakeTets, GivesTrianglesOfSharedModelsTheNumbersOfTheirCadFaces) {
  const char* set = std::getenv("CROSSGRAIN_SHARED");
  const auto models =
      std::filesystem::path(set != nullptr ? set : CROSSGRAIN_DEFAULT_SHARED) / "models" / "good";
  if (!std::filesystem::exists(models)) GTEST_SKIP() << "no models in " << models;
  std::vector<std::string> names{"s11o_cube_cyl.stp"};
  if (is_nightly())
    names.insert(names.end(),
                 {"i10o_simp.step", "base_interface_AP214.STEP", "featuretype.STEP", "i02o_m2.step"});
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    ReadOptions fine;
    fine.resolution = 100;
    fine.facet_angle_deg = 5;
    const TriangleMesh faces = read_surface(models / name, fine);
    TetMakingOptions options;
    options.maker = GetParam();
    options.edges = 15;
    const TetMesh tets = make_tets(models / name, options);
    expect_sound(tets);
    EXPECT_LT(farthest_from_face(tets, faces), 0.006 * longest_side(box_of(faces.vertices)));
    EXPECT_LT(farthest_from_crease(tets, faces), 0.006 * longest_side(box_of(faces.vertices)));
  }
}

TEST_P(MakeTets, GivesSolidsThatShareFacesTheirNumbers) {
  std::map<std::int32_t, double> glued = volumes_of_regions(made_cad("glued.brep", GetParam(), 2));
  EXPECT_NEAR(glued[1], 1000, 1e-6);
  EXPECT_NEAR(glued[2], 500, 1e-6);
  const TetMesh sleeve = made_cad("sleeve.brep", GetParam(), 2);
  expect_sound(sleeve);
  std::map<std::int32_t, double> volumes = volumes_of_regions(sleeve);
  ASSERT_EQ(volumes.size(), 2u);
  const double core = 9 * M_PI * 10, whole = 36 * M_PI * 10;
  EXPECT_NEAR(std::min(volumes[1], volumes[2]) / core, 1, 0.05);
  EXPECT_NEAR((volumes[1] + volumes[2]) / whole, 1, 0.05);
}

TEST_P(MakeTets, GluesSolidsThatTouch) {
  TetMakingOptions options;
  options.maker = GetParam();
  options.glue = true;
  options.edges = 8;
  const TetMesh glued = make_tets(cad_files() / "pocket.step", options);
  expect_sound(glued);
  EXPECT_TRUE(TetDomain(glued).warnings().empty());
  std::map<std::int32_t, double> volumes = volumes_of_regions(glued);
  EXPECT_NEAR(volumes[1], 1000 - 96, 1e-6);
  EXPECT_NEAR(volumes[2], 96, 1e-6);
}

TEST_P(MakeTets, FollowsCadFacesMoreCloselyWithMoreEdgesAroundACircle) {
  double before = 1e9;
  for (const double edges : {12, 24}) {
    TetMakingTuning options{tets_of_size(10)};
    options.smallest_share = 0.01;
    options.maker = GetParam();
    options.edges_per_circle = edges;
    const double missing =
        1 - volume_of(make_tets(cad_files() / "cylinder.brep", options)) / (25 * M_PI * 20);
    EXPECT_GT(missing, 0);
    EXPECT_LT(missing, 0.4 * before);
    before = missing;
  }
}

#endif

/// The whole way to a field's domain, with tags that the boundary of tets keeps.
TEST_P(MakeTets, GivesADomainWhoseBoundaryKnowsTheFaces) {
  const TriangleMesh boundary = TetDomain(made(make_box({1, 1, 1}), 0.3)).boundary();
  std::set<std::int32_t> faces(boundary.faces.begin(), boundary.faces.end());
  EXPECT_EQ(faces, (std::set<std::int32_t>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(boundary.creases.size(), 12u);
}

}  // namespace
}  // namespace crossgrain
