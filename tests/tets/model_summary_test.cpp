// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/model_summary.hpp"

#include <gtest/gtest.h>

#include "support/shapes.hpp"

namespace crossgrain {
namespace {

TEST(ModelSummary, TellsSizeUnitPlaceAndParts) {
  TriangleMesh box = translate_mesh(make_box({40, 30, 12}), {20, 15, 6});
  EXPECT_EQ(sentence_of(summary_of(box)), "40 x 30 x 12 (no unit) from 0 0 0; 12 triangles");
  box.unit = "mm";
  box.faces = {1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6};
  box.solids.assign(12, 0);
  EXPECT_EQ(sentence_of(summary_of(box)), "40 x 30 x 12 mm from 0 0 0; 6 faces, 1 solid");
  box.file_unit = "inch";
  EXPECT_EQ(sentence_of(summary_of(box)), "40 x 30 x 12 mm (in the file: inch) from 0 0 0; 6 faces, 1 solid");
}

TEST(ModelSummary, LeavesOutVerticesThatNothingUses) {
  TriangleMesh box = make_box({2, 2, 2});
  box.vertices.push_back({100, 100, 100});
  EXPECT_EQ(summary_of(box).bounding_box.high, (Vector3{1, 1, 1}));
}

TEST(ModelSummary, OfTetsCountsThemAndTheirRegions) {
  TetMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {9, 9, 9}};
  mesh.tets = {{0, 1, 2, 3}};
  EXPECT_EQ(sentence_of(summary_of(mesh)), "1 x 2 x 3 (no unit) from 0 0 0; 1 tet");
  mesh.regions = {7};
  mesh.unit = "m";
  EXPECT_EQ(sentence_of(summary_of(mesh)), "1 x 2 x 3 m from 0 0 0; 1 tet, 1 region");
}

}  // namespace
}  // namespace crossgrain
