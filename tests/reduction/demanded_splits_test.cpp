// SPDX-License-Identifier: Apache-2.0
#include "reduction/demanded_splits.hpp"

#include <gtest/gtest.h>

#include "reduction/mapped_shapes.hpp"

namespace crossgrain {
namespace {

using testing::AskewBox;

double length_of_arcs(const MatchedField& field) {
  double length = 0;
  for (std::uint32_t e = 0; e < field.complex().edges().size(); ++e) {
    const TetComplex::Edge& edge = field.complex().edges()[e];
    if (!edge.is_on_boundary() && field.is_singular(e)) length += edge.length;
  }
  return length;
}

DemandedSplits demanded(const MatchedField& field) {
  const CutSolid cut(field);
  return demanded_splits(MapUnknowns(cut));
}

TEST(DemandedSplits, AreNoneInABoxWithoutEdgesAcrossItsCorners) {
  const AskewBox box({3, 3, 3});
  EXPECT_TRUE(demanded(box.field).empty());
}

TEST(DemandedSplits, LeaveNoneAndKeepVolumesAndArcs) {
  const TetSolid box = solid_of(TetBox{{3, 3, 3}}.mesh(0.1));
  const TetComplex complex(box);
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const std::vector<Quaternion> frames(box.mesh.tets.size(), Quaternion{1, 0, 0, 0});
    MatchedField field(complex, frames);
    testing::turn_random_faces(field, 2, seed);
    const DemandedSplits splits = demanded(field);
    count += splits.edges.size() + splits.faces.size();
    const OwnedField split = split_for_map(field, 20);
    EXPECT_TRUE(demanded(*split.field).empty()) << seed;
    EXPECT_NEAR(length_of_arcs(*split.field), length_of_arcs(field), 1e-9);
    EXPECT_NEAR(volume_of_tets(split.solid->mesh), volume_of_tets(box.mesh), 1e-12);
  }
  EXPECT_GT(count, 0u);
}

}  // namespace
}  // namespace crossgrain
