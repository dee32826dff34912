// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "base/vector3.hpp"
#include "crossgrain/solve.hpp"
#include "field/field_data.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

TEST(SolveReport, PassesOnWhatReadingFound) {
  TriangleMesh mesh = make_box({1, 1, 1});
  mesh.unit = "mm";
  mesh.file_unit = "INCH";
  const Warning warning(WarningKind::kMissingFaces, {"a.step", "face 3", "is missing", Remedy::kRepairFile});
  mesh.warnings = {warning};
  SolveOptions options;
  options.resolution = 4;
  const SolveReport report = solve(mesh, options).report();
  EXPECT_EQ(report.model.unit, "mm");
  EXPECT_EQ(report.model.file_unit, "INCH");
  EXPECT_EQ(std::count(report.warnings.begin(), report.warnings.end(), warning), 1);
}

/// Six times the signed volume that triangles enclose.
double volume6(const SolvedSurface& surface) {
  double sum = 0;
  for (const auto& [a, b, c] : surface.triangles)
    sum += dot(surface.vertices[a], cross(surface.vertices[b], surface.vertices[c]));
  return sum;
}

TEST(SolvedSurface, LooksOutOfTheSolidAlsoWhereTheModelIsInsideOut) {
  SolveOptions options;
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
  SolveOptions options;
  options.resolution = 4;
  TriangleMesh mesh = make_box({1, 1, 1});
  mesh.triangles.push_back(mesh.triangles.front());
  EXPECT_EQ(solve(mesh, options).data().surface.get()->triangles.size(), 12u);
}

}  // namespace
}  // namespace crossgrain
