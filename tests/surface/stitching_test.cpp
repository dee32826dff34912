// SPDX-License-Identifier: Apache-2.0
#include "surface/stitching.hpp"

#include <gtest/gtest.h>

#include "support/shapes.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

/// A box whose triangles each have their own vertices, every second one moved a little.
TriangleMesh cracked_box(double crack) {
  TriangleMesh box = to_soup(make_box({1, 1, 1}));
  for (std::size_t v = 0; v < box.vertices.size(); v += 2) box.vertices[v][1] += crack;
  return weld(std::move(box));
}

TEST(Stitching, ClosesCracksUpToTheGap) {
  const TriangleMesh open = cracked_box(1e-7);
  ASSERT_FALSE(analyse_topology(open).watertight);
  const StitchedSurface closed = stitched(open, 2e-7);
  EXPECT_TRUE(analyse_topology(closed.mesh).watertight);
  EXPECT_EQ(closed.mesh.vertices.size(), 8u);
  EXPECT_EQ(closed.mesh.triangles.size(), 12u);
  EXPECT_EQ(closed.merged, open.vertices.size() - 8);
  EXPECT_NEAR(closed.widest, 1e-7, 1e-9);
}

TEST(Stitching, LeavesWiderCracks) {
  const TriangleMesh open = cracked_box(1e-7);
  const StitchedSurface same = stitched(open, 0.5e-7);
  EXPECT_EQ(same.merged, 0u);
  EXPECT_EQ(same.mesh.vertices, open.vertices);
}

/// Their vertices are close, but on no open edge.
TEST(Stitching, DoesNotJoinClosedParts) {
  const TriangleMesh boxes =
      join_meshes(make_box({1, 1, 1}), translate_mesh(make_box({1, 1, 1}), {1 + 1e-8, 0, 0}));
  EXPECT_EQ(stitched(boxes, 1e-6).merged, 0u);
}

}  // namespace
}  // namespace crossgrain
