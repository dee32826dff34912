// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "crossgrain/solve.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

TEST(SolveReport, PassesOnWhatReadingFound) {
  TriangleMesh mesh = make_box({1, 1, 1});
  mesh.unit = "mm";
  mesh.file_unit = "INCH";
  mesh.warnings = {"a face is missing"};
  SolveOptions options;
  options.resolution = 4;
  const SolveReport report = solve(mesh, options).report();
  EXPECT_EQ(report.model.unit, "mm");
  EXPECT_EQ(report.model.file_unit, "INCH");
  EXPECT_EQ(std::count(report.warnings.begin(), report.warnings.end(), "a face is missing"), 1);
}

}  // namespace
}  // namespace crossgrain
