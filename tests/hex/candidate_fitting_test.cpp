// SPDX-License-Identifier: Apache-2.0
#include "hex/candidate_fitting.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/vector3.hpp"
#include "crossgrain/hexahedra.hpp"
#include "crossgrain/solve.hpp"
#include "hex/field_mapping.hpp"
#include "hex/hex_report.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

constexpr double kSize = 0.5;

HexCandidate box_candidate() {
  HexOptions options;
  options.size = kSize;
  const TetFrameField field = solve_onto(TetDomain(TetBox{{4, 3, 3}}.mesh(0.1)).prepared_for_map());
  const HexCandidate followed = followed_candidate(hexahedra(field, options).field, kSize, /*round=*/0);
  return mapped_candidate(followed, kSize, HexTuning());
}

/// Moves a vertex of each of the first hexahedra out of these, through the opposite one.
HexCandidate inverted(HexCandidate candidate, std::size_t count) {
  HexMesh& mesh = candidate.made->mesh;
  for (std::size_t h = 0; h < count; ++h) {
    Vector3& vertex = mesh.vertices[mesh.hexahedra[h][0]];
    vertex += 1.2 * (mesh.vertices[mesh.hexahedra[h][6]] - vertex);
  }
  candidate.made->quality = quality_of(mesh);
  return candidate;
}

TEST(CandidateFitting, MakesValidWhatHasAFewInvertedHexahedra) {
  HexCandidate candidate = inverted(box_candidate(), 1);
  ASSERT_GT(candidate.made->quality.inverted, 0u);
  ASSERT_FALSE(candidate.made->are_complete());
  const double work = candidate.attempt.work;
  mend_by_fitting(candidate);
  EXPECT_TRUE(candidate.made->are_complete());
  ASSERT_TRUE(candidate.fit);
  EXPECT_EQ(candidate.fit->best.measure.corners.kept, 8u);
  EXPECT_EQ(candidate.fit->best.measure.curves.kept, 12u);
  EXPECT_GT(candidate.made->quality.least, 0.5);
  EXPECT_EQ(candidate.made->mesh.boundary.size(), 2u * (48 + 48 + 36));
  EXPECT_GT(candidate.attempt.work, work);
}

TEST(CandidateFitting, LeavesValidHexahedraAndFoldedMapsAlone) {
  for (HexCandidate candidate : {box_candidate(), inverted(box_candidate(), 50)}) {
    const auto before = candidate.made->mesh.vertices;
    mend_by_fitting(candidate);
    EXPECT_FALSE(candidate.fit);
    EXPECT_EQ(candidate.made->mesh.vertices, before);
  }
}

}  // namespace
}  // namespace crossgrain
