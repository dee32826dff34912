// SPDX-License-Identifier: Apache-2.0
#include "display/shown_field.hpp"

#include <gtest/gtest.h>

#include "crossgrain/solve.hpp"
#include "measure/made_tets.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

TetFrameField field_on_tets() {
  TetMesh mesh = tet_box({2, 2, 2});
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    double middle = 0;
    for (const std::uint32_t v : mesh.tets[t]) middle += mesh.vertices[v][0] / 4;
    mesh.regions.push_back(middle < 1 ? 1 : 2);
  }
  SolveOptions options;
  options.resolution = 8;
  return solve_onto(TetDomain(std::move(mesh)), options);
}

TEST(ShownField, HasTheBoundaryOfTetsWithTheFacesBetweenRegions) {
  const ShownField shown(field_on_tets());
  EXPECT_TRUE(shown.is_on_tets());
  EXPECT_FALSE(shown.is_starting_grid());
  EXPECT_EQ(shown.surface().triangles.size(), 6u * 4 * 2);
  EXPECT_EQ(shown.surface().interfaces.size(), 4u * 2);
}

TEST(ShownField, CountsTheLinesThatItShows) {
  const TetFrameField field = field_on_tets();
  EXPECT_EQ(&ShownField(field).lines(), &field.singularities());
  EXPECT_EQ(&ShownField(field.grid()).lines(), &field.grid().singularities());
  EXPECT_EQ(&ShownField(field).counts(), &field.report().onto->singularity);
}

}  // namespace
}  // namespace crossgrain
