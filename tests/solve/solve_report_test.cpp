// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vector3.hpp"
#include "field/field_data.hpp"
#include "solve/tuned_solve.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

TEST(SolveReport, PassesOnWhatReadingFound) {
  TriangleMesh mesh = make_box({1, 1, 1});
  mesh.unit = "mm";
  mesh.file_unit = "INCH";
  const Warning warning(WarningKind::kMissingFaces, {"a.step", "face 3", "is missing", Remedy::kRepairFile});
  mesh.warnings = {warning};
  SolveTuning options;
  options.resolution = 4;
  const SolveReport report = solve(mesh, options).report();
  EXPECT_EQ(report.model.unit, "mm");
  EXPECT_EQ(report.model.file_unit, "INCH");
  EXPECT_EQ(std::count(report.warnings.begin(), report.warnings.end(), warning), 1);
}

TEST(SolveReport, ListsTheFacesBetweenTheCreasesOfASurface) {
  SolveTuning options;
  options.resolution = 4;
  const FrameField field = solve(make_box({1, 2, 3}), options);
  const std::vector<ModelFace>& faces = field.report().faces;
  ASSERT_EQ(faces.size(), 6u);
  double area = 0;
  for (const ModelFace& face : faces) {
    EXPECT_EQ(face.kind, FaceKind::kPatch);
    area += face.area;
  }
  EXPECT_NEAR(area, 22, 1e-12);
  const auto surface = field.data().surface.get();
  ASSERT_EQ(surface->faces.size(), surface->triangles.size());
  for (const std::int32_t number : surface->faces) EXPECT_TRUE(number >= 1 && number <= 6) << number;
}

TEST(SolveReport, ListsTheFacesThatTheFileOfASurfaceKnows) {
  TriangleMesh mesh = make_box({1, 2, 3});
  mesh.faces.assign(mesh.triangles.size(), 4);
  mesh.face_list = {{4, FaceKind::kCone, 1.5, {1, 2, 3}}};
  SolveTuning options;
  options.resolution = 4;
  const std::vector<ModelFace> faces = solve(mesh, options).report().faces;
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_EQ(faces[0].kind, FaceKind::kCone);
  EXPECT_EQ(faces[0].area, 1.5);
}

/// Six times the signed volume that triangles enclose.
double volume6(const SolvedSurface& surface) {
  double sum = 0;
  for (const auto& [a, b, c] : surface.triangles)
    sum += dot(surface.vertices[a], cross(surface.vertices[b], surface.vertices[c]));
  return sum;
}

/// The largest angle between an axis of a frame and the nearest axis of the coordinates, over all cells.
double most_off_axes_deg(const FrameField& field) {
  double least_cosine = 1;
  for (const Frame& frame : field.frames()) {
    for (const Vector3& axis : frame.axes)
      least_cosine =
          std::min(least_cosine, std::max({std::abs(axis[0]), std::abs(axis[1]), std::abs(axis[2])}));
  }
  return std::acos(std::min(1.0, least_cosine)) * 180 / std::numbers::pi;
}

bool is_unsettled(const SolveReport& report) {
  return std::any_of(report.warnings.begin(), report.warnings.end(),
                     [](const Warning& warning) { return warning.kind == WarningKind::kNotSettled; });
}

TEST(Solve, LeavesNoTwistInAThinPlateWhoseEnergyIsAlmostNothing) {
  for (const Degree degree : {Degree::kThree, Degree::kFour}) {
    SolveTuning options;
    options.degree = degree;
    options.resolution = 128;
    const TriangleMesh plate = make_box({1, 1.0 / 120, 1});
    const FrameField field = solve(plate, options);
    EXPECT_FALSE(is_unsettled(field.report()));
    EXPECT_LT(most_off_axes_deg(field), 0.02);
    // Its sweeps alone leave degrees, and say so.
    options.solver.calm_fields.more_sweeps = 0;
    options.solver.calm_fields.least_turn_deg = 0;
    const FrameField twisted = solve(plate, options);
    EXPECT_TRUE(is_unsettled(twisted.report()));
    EXPECT_GT(most_off_axes_deg(twisted), 0.5);
  }
}

TEST(SolvedSurface, LooksOutOfTheSolidAlsoWhereTheModelIsInsideOut) {
  SolveTuning options;
  options.resolution = 4;
  TriangleMesh mesh = make_box({1, 1, 1});
  const auto box = solve(mesh, options).data().surface.get();
  for (auto& [a, b, c] : mesh.triangles) std::swap(b, c);
  const auto inside_out = solve(mesh, options).data().surface.get();
  EXPECT_EQ(box->triangles.size(), 12u);
  EXPECT_EQ(box->creases.size(), 12u);
  EXPECT_NEAR(volume6(*box), 6, 1e-12);
  EXPECT_NEAR(volume6(*inside_out), 6, 1e-12);
}

TEST(SolvedSurface, LeavesOutWhatWasMendedAway) {
  SolveTuning options;
  options.resolution = 4;
  TriangleMesh mesh = make_box({1, 1, 1});
  mesh.triangles.push_back(mesh.triangles.front());
  EXPECT_EQ(solve(mesh, options).data().surface.get()->triangles.size(), 12u);
}

}  // namespace
}  // namespace crossgrain
