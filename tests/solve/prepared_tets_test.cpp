// SPDX-License-Identifier: Apache-2.0
// Tets prepared for a map, and fields on them, as users of the library get them.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/vector3.hpp"
#include "crossgrain/solve.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

TEST(PreparedTets, KeepTheNumbersOfVerticesAndNameTheTetsThatTheyArePartsOf) {
  const TetDomain domain(tet_cylinder(6)), prepared = domain.prepared_for_map();
  const TetMesh &before = domain.mesh(), &after = prepared.mesh();
  ASSERT_GT(after.vertices.size(), before.vertices.size());
  EXPECT_TRUE(std::equal(before.vertices.begin(), before.vertices.end(), after.vertices.begin()));
  ASSERT_EQ(prepared.parents().size(), after.tets.size());
  std::vector<double> volumes(before.tets.size(), 0);
  for (std::size_t t = 0; t < after.tets.size(); ++t)
    volumes.at(prepared.parents()[t]) += volume_of_tets({after.vertices, {after.tets[t]}});
  for (std::size_t t = 0; t < before.tets.size(); ++t)
    EXPECT_NEAR(volumes[t], volume_of_tets({before.vertices, {before.tets[t]}}), 1e-15);
}

TEST(PreparedTets, SayWhatWasSplit) {
  const TetDomain domain(tet_cylinder(6)), prepared = domain.prepared_for_map();
  EXPECT_FALSE(domain.preparation());
  EXPECT_TRUE(domain.parents().empty());
  ASSERT_TRUE(prepared.preparation());
  const MapPreparation& did = *prepared.preparation();
  EXPECT_EQ(did.tets_before, domain.mesh().tets.size());
  EXPECT_EQ(did.vertices_before, domain.mesh().vertices.size());
  EXPECT_EQ(did.split_edges + did.split_faces + did.split_tets,
            prepared.mesh().vertices.size() - domain.mesh().vertices.size());
}

TEST(PreparedTets, HaveTheWarningsOfTheTetsAsGiven) {
  TetMesh mesh = TetBox{{2, 2, 2}}.mesh();
  mesh.vertices.push_back({9, 9, 9});
  mesh.tets.push_back(mesh.tets[3]);
  const TetDomain domain(mesh);
  ASSERT_GE(domain.warnings().size(), 3u);  // inverted and repeated tets, a vertex of no tet
  EXPECT_EQ(domain.prepared_for_map().warnings(), domain.warnings());
}

TEST(PreparedTets, WarnOfSplitsThatWouldLeaveATetFlat) {
  // Halves of the tet in the middle would be.
  const double thick = 2e-12;
  const TetDomain domain({{{0, 0, 0}, {1, 0, thick}, {1, 1, 0}, {0, 1, thick}, {0.5, 0.5, 1}, {0.5, 0.5, -1}},
                          {{1, 2, 3, 4}, {0, 1, 3, 4}, {0, 2, 1, 3}, {0, 2, 1, 5}, {0, 3, 2, 5}}});
  const TetDomain prepared = domain.prepared_for_map();
  ASSERT_FALSE(prepared.warnings().empty());
  EXPECT_EQ(prepared.warnings().back().kind, WarningKind::kRefusedSplits);
  EXPECT_EQ(prepared.mesh().tets.size(), prepared.parents().size());
}

TEST(PreparedTets, HaveNoParentForPartsOfFlatTets) {
  // A flat tet between two pairs of others.
  const TetDomain domain({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}, {0.5, 0.5, -1}},
                          {{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 1, 2, 3}, {1, 0, 3, 5}, {2, 1, 3, 5}}});
  const TetDomain prepared = domain.prepared_for_map();
  ASSERT_EQ(prepared.parents().size(), prepared.mesh().tets.size());
  for (const std::uint32_t parent : prepared.parents()) EXPECT_LT(parent, 4u);
  EXPECT_EQ(prepared.boundary().triangles.size(), domain.boundary().triangles.size());
  EXPECT_EQ(prepared.warnings(), domain.warnings());
}

TEST(ASolveOnPreparedTets, HasNoSingularLineThatTouchesACylinderBesideItsEnds) {
  SolveOptions options;
  options.resolution = 16;
  const TetDomain domain(tet_cylinder(8)), prepared = domain.prepared_for_map();
  const SolveReport plain = solve_onto(domain, options).report(),
                    split = solve_onto(prepared, options).report();
  EXPECT_FALSE(plain.onto->prepared);
  ASSERT_TRUE(split.onto->prepared);
  EXPECT_EQ(split.onto->prepared->tets_before, plain.onto->tets);
  EXPECT_EQ(split.onto->tets, prepared.mesh().tets.size());
  EXPECT_GT(plain.onto->singularity.contacts, 0u);
  EXPECT_EQ(split.onto->singularity.contacts, 0u);
}

}  // namespace
}  // namespace crossgrain
