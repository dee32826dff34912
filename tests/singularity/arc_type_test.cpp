// SPDX-License-Identifier: Apache-2.0
#include "singularity/arc_type.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

namespace crossgrain {
namespace {

using Graph = SingularityGraph;

Verdict verdict_of(const std::vector<double>& indices) {
  std::vector<Graph::Arc> arcs(indices.size());
  std::vector<const Graph::Arc*> pointers;
  for (std::size_t k = 0; k < arcs.size(); ++k) {
    arcs[k].index = indices[k];
    pointers.push_back(&arcs[k]);
  }
  return node_verdict(pointers);
}

Verdict verdict_of(std::size_t valence_3, std::size_t valence_5) {
  std::vector<double> indices(valence_3, 0.25);
  indices.resize(valence_3 + valence_5, -0.25);
  return verdict_of(indices);
}

TEST(NodeVerdict, AllowsElevenPairsOfCountsOfQuarterTurns) {
  std::set<std::pair<std::size_t, std::size_t>> possible;
  for (std::size_t valence_3 = 0; valence_3 <= 5; ++valence_3)
    for (std::size_t valence_5 = 0; valence_5 <= 13; ++valence_5)
      if (verdict_of(valence_3, valence_5) == Verdict::kMeshable) possible.insert({valence_3, valence_5});
  const std::set<std::pair<std::size_t, std::size_t>> known{{0, 0}, {4, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 3},
                                                            {0, 4}, {2, 6}, {0, 6}, {0, 8}, {0, 12}};
  EXPECT_EQ(possible, known) << "P. Zhang and others, arXiv 2202.09686";
}

TEST(NodeVerdict, KnowsNodesWithArcsOfSixHexahedra) {
  EXPECT_EQ(verdict_of({-0.5, -0.5}), Verdict::kMeshable) << "a line that passes straight through";
  EXPECT_EQ(verdict_of({-0.5}), Verdict::kNotMeshable);
  EXPECT_EQ(verdict_of({-0.25, -0.25, -0.5}), Verdict::kNotMeshable);
}

TEST(NodeVerdict, OfArcsThatHexahedraCannotHaveIsBad) {
  Graph::Arc bad, good;
  good.index = 0.25;
  bad.verdict = Verdict::kNotMeshable;
  const std::vector<const Graph::Arc*> arcs{&bad, &good};
  EXPECT_EQ(node_verdict(arcs), Verdict::kNotMeshable);
}

TEST(NodeVerdict, OfMoreHexahedraThanAreSearchedIsUndecided) {
  EXPECT_EQ(verdict_of(std::vector<double>(14, -0.5)), Verdict::kUndecided);
}

}  // namespace
}  // namespace crossgrain
