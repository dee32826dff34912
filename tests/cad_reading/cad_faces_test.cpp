// SPDX-License-Identifier: Apache-2.0
// The faces of CAD models with their kinds, areas and centroids, and exact sizes.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/vector3.hpp"
#include "cad_reading/made_cad_answers.hpp"
#include "cad_reading/made_cad_files.hpp"
#include "crossgrain/model_summary.hpp"
#include "mesh_files/surface_files.hpp"

#ifdef CROSSGRAIN_CAD_FILES

namespace crossgrain {
namespace {

constexpr double kPi = std::numbers::pi;

TriangleMesh read_glued(const std::string& name) {
  CadReading options;
  options.glue = true;
  return read_made(name, options);
}

double area_of_faces(const TriangleMesh& mesh, std::uint32_t solids = 1) {
  double area = 0;
  for (const ModelFace& face : mesh.face_list)
    if (face.solids == solids) area += face.area;
  return area;
}

TEST(CadFaces, OfAPlateWithAHoleHaveTheirKindsAndExactAreas) {
  for (const char* name : {"plate.step", "plate.iges", "plate.brep", "inch.stp"}) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = read_made(name);
    ASSERT_EQ(mesh.face_list.size(), 7u);
    std::size_t planes = 0;
    for (std::size_t k = 0; k < 7; ++k) {
      const ModelFace& face = mesh.face_list[k];
      EXPECT_EQ(face.number, static_cast<std::int64_t>(k + 1));
      EXPECT_EQ(face.solids, 1u);
      EXPECT_FALSE(face.quads);
      planes += face.kind == FaceKind::kPlane;
      if (face.kind == FaceKind::kPlane) continue;
      EXPECT_EQ(face.kind, FaceKind::kCylinder);
      EXPECT_NEAR(face.area, 100 * kPi, 1e-6);
      EXPECT_LT(norm(face.centre - Vector3{20, 15, 5}), 1e-6);
    }
    EXPECT_EQ(planes, 6u);
    EXPECT_NEAR(mesh.exact_size.volume, 12000 - 250 * kPi, 1e-5);
    EXPECT_NEAR(mesh.exact_size.area, 2 * (1200 - 25 * kPi) + 1400 + 100 * kPi, 1e-6);
    EXPECT_NEAR(area_of_faces(mesh), mesh.exact_size.area, 1e-9);
  }
}

TEST(CadFaces, OfCurvedSolidsHaveTheSizesOfTheirFormulas) {
  const TriangleMesh ball = read_made("sphere.brep");
  ASSERT_EQ(ball.face_list.size(), 1u);
  EXPECT_EQ(ball.face_list[0].kind, FaceKind::kSphere);
  EXPECT_LT(norm(ball.face_list[0].centre - Vector3{3, 4, 5}), 1e-9);
  EXPECT_NEAR(ball.exact_size.area, 100 * kPi, 1e-7);
  EXPECT_NEAR(ball.exact_size.volume, 500 * kPi / 3, 1e-7);
  const TriangleMesh rounded = read_made("rounded.brep");  // a cube of 14 and all within 3 of it
  EXPECT_NEAR(rounded.exact_size.area, 6 * 196 + 6 * kPi * 14 * 3 + 4 * kPi * 9, 1e-5);
  EXPECT_NEAR(rounded.exact_size.volume, 2744 + 6 * 196 * 3 + 3 * kPi * 14 * 9 + 36 * kPi, 1e-4);
}

/// Half the extent of a circle of radius 1 across an axis, along a coordinate.
double half_width(double along) {
  return std::sqrt(1 - along * along);
}

TEST(CadFaces, OfTurnedSolidsHaveTheBoxesOfTheirFormulas) {
  const Vector3 from{1, 2, 3}, axis = normalised(from);
  const auto expect = [&](const std::string& name, const auto& low_of, const auto& high_of) {
    for (const std::string kind : {"oblique_", "spline_"}) {
      const TriangleMesh mesh = read_made(kind + name + ".brep");
      EXPECT_EQ(summary_of(mesh).bounding_box.low, mesh.exact_box.low);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(mesh.exact_box.low[k], from[k] + low_of(axis[k]), 1e-8) << kind << name << " along " << k;
        EXPECT_NEAR(mesh.exact_box.high[k], from[k] + high_of(axis[k]), 1e-8)
            << kind << name << " along " << k;
      }
    }
  };
  expect(
      "sphere", [](double) { return -5; }, [](double) { return 5; });
  const auto below_disc = [](double along) { return -5 * half_width(along); };
  expect("cylinder", below_disc, [](double along) { return 20 * along + 5 * half_width(along); });
  expect("cone", below_disc, [](double along) { return std::max(5 * half_width(along), 20 * along); });
  const auto half_torus = [](double along) { return 10 * half_width(along) + 2; };
  expect(
      "torus", [&](double along) { return -half_torus(along); }, half_torus);
}

TEST(CadFaces, OfFlatSolidsHaveTheBoxesOfTheirVertices) {
  const TriangleMesh mesh = read_made("chamfered.step");
  const Box box = mesh.exact_box, given = box_of(mesh.vertices);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(box.low[k], given.low[k], 1e-12);
    EXPECT_NEAR(box.high[k], given.high[k], 1e-12);
  }
}

TEST(CadFaces, NumbersAreThoseOfTheTriangles) {
  const TriangleMesh mesh = read_made("plate.step");
  for (const ModelFace& face : mesh.face_list) {
    double area = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      if (mesh.faces[t] == face.number)
        area += norm(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a])) / 2;
    }
    EXPECT_NEAR(area, face.area, 0.01 * face.area) << "face " << face.number;
  }
}

TEST(CadFaces, BetweenGluedSolidsCountForNoArea) {
  const TriangleMesh apart = read_made("stacked.brep"), glued = read_glued("stacked.brep");
  for (const TriangleMesh* mesh : {&apart, &glued}) EXPECT_NEAR(mesh->exact_size.volume, 4210, 1e-6);
  EXPECT_NEAR(apart.exact_size.area, 1600 + 214, 1e-6);
  EXPECT_NEAR(glued.exact_size.area, 1600 + 130, 1e-6);
  const TriangleMesh boxes = read_made("glued.brep");
  EXPECT_NEAR(boxes.exact_size.area, 2 * 100 + 4 * 150, 1e-6);
  EXPECT_NEAR(area_of_faces(boxes, 2), 100, 1e-9);
}

TEST(CadFaces, WhatTwoSolidsHoldCountsTwiceUnlessTheyAreGlued) {
  EXPECT_NEAR(read_made("overlapping.brep").exact_size.volume, 1360, 1e-6);
  EXPECT_NEAR(read_glued("overlapping.brep").exact_size.volume, 1180, 1e-6);
}

TEST(CadFaces, OfASolidInsideOutHaveAVolumeTooAndThoseOfAnOpenShellNone) {
  EXPECT_NEAR(read_made("inside_out.brep").exact_size.volume, 6, 1e-9);
  EXPECT_NEAR(read_made("loose.brep").exact_size.volume, 6, 1e-9);
  EXPECT_EQ(read_made("open.brep").exact_size.volume, 0);
}

TEST(CadFaces, AreNotBelievedWithoutAKindOrAnArea) {
  const auto spoil = [](const auto& change) {
    CadAnswer answer = some_answer();
    change(answer.mesh.face_list.front());
    return cad_answer_in(written(answer)).has_value();
  };
  EXPECT_TRUE(spoil([](ModelFace&) {}));
  EXPECT_FALSE(spoil([](ModelFace& face) { face.kind = FaceKind::kPatch; }));
  EXPECT_FALSE(spoil([](ModelFace& face) { face.area = -1; }));
  EXPECT_FALSE(spoil([](ModelFace& face) { face.centre[1] = NAN; }));
}

}  // namespace
}  // namespace crossgrain

#endif
