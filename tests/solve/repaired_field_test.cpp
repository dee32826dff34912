// SPDX-License-Identifier: Apache-2.0
// Repairs, as users of the library get them.
#include <gtest/gtest.h>

#include "crossgrain/error.hpp"
#include "crossgrain/repair.hpp"
#include "crossgrain/solve.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

TEST(RepairedField, MovesVerticesOfPreparedTetsOnly) {
  const TetDomain given(tet_cylinder(6));
  const TetFrameField plain = repaired(solve_onto(given));
  EXPECT_EQ(plain.domain().mesh().vertices, given.mesh().vertices);
  EXPECT_EQ(plain.report().onto->repair->moved_vertices, 0u);

  const TetDomain prepared = given.prepared_for_map();
  const TetFrameField before = solve_onto(prepared), after = repaired(before);
  EXPECT_EQ(before.domain().mesh().vertices, prepared.mesh().vertices);
  EXPECT_EQ(after.domain().mesh().tets, prepared.mesh().tets);
  EXPECT_NEAR(volume_of_tets(after.domain().mesh()), volume_of_tets(prepared.mesh()), 1e-12);
  std::size_t moved = 0;
  for (std::size_t v = 0; v < prepared.mesh().vertices.size(); ++v)
    moved += after.domain().mesh().vertices[v] != prepared.mesh().vertices[v];
  EXPECT_GT(moved, 0u);
  EXPECT_EQ(after.report().onto->repair->moved_vertices, moved);
  EXPECT_EQ(repaired(before, {.moves_vertices = false}).domain().mesh().vertices, prepared.mesh().vertices);
}

TEST(TetDomain, WithItsVerticesElsewhereMustHaveTetsOfPositiveVolume) {
  const TetDomain domain(TetBox{{2, 2, 2}}.mesh());
  std::vector<Vector3> vertices = domain.mesh().vertices;
  vertices[13] = {1.2, 0.9, 1.1};  // the one inside
  EXPECT_EQ(domain.with_vertices(vertices).mesh().vertices, vertices);
  EXPECT_EQ(domain.mesh().vertices[13], (Vector3{1, 1, 1}));
  vertices[13] = {1, 1, 3};
  EXPECT_THROW(static_cast<void>(domain.with_vertices(vertices)), Error);
  vertices.pop_back();
  EXPECT_THROW(static_cast<void>(domain.with_vertices(vertices)), Error);
}

}  // namespace
}  // namespace crossgrain
