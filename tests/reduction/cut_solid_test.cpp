// SPDX-License-Identifier: Apache-2.0
#include "reduction/cut_solid.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "matching/made_matchings.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

using testing::frames_at_centroids;
using testing::random_tet_frames;
using testing::turn_random_faces;
using testing::TurningLine;

const TetSolid kBox = solid_of(TetBox{{3, 3, 3}}.mesh(0.1));
const TetComplex kComplex(kBox);

/// What crossing a face does in the names of the cut.
std::uint8_t named(const CutSolid& cut, std::uint32_t face) {
  const CubeGroup& group = CubeGroup::instance();
  const auto& [from, to] = kBox.inner_faces[face].tets;
  return group.product(cut.names_of(to),
                       group.product(cut.field().matching(face), group.inverse_of(cut.names_of(from))));
}

void expect_sound(const CutSolid& cut) {
  const CubeGroup& group = CubeGroup::instance();
  for (std::uint32_t f = 0; f < kBox.inner_faces.size(); ++f) {
    const SheetStep step = cut.step_across({f, false});
    EXPECT_EQ(cut.step_across({f, true}), -step);
    if (step == 0) {
      EXPECT_EQ(named(cut, f), CubeGroup::kIdentity);
    } else {
      const std::uint8_t rotation = cut.rotation(static_cast<std::size_t>(std::abs(step) - 1));
      EXPECT_EQ(named(cut, f), step > 0 ? rotation : group.inverse_of(rotation));
    }
  }
  for (std::uint32_t t = 0; t < kBox.mesh.tets.size(); ++t) {
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t copy = cut.copy_of(t, k), first = cut.first_copy(copy);
      EXPECT_EQ(cut.first_copy(first), first);
      EXPECT_TRUE(cut.word_to(first).empty());
    }
  }
}

TEST(CutSolid, CutsNothingWhereEveryEdgeIsRegular) {
  // The same frame everywhere, each time by another of its 24 names.
  std::vector<Quaternion> frames;
  std::mt19937 random(5);
  for (std::size_t t = 0; t < kBox.mesh.tets.size(); ++t)
    frames.push_back(
        from_rotation_vector({0.1, 0.2, 0.3}) *
        to_quaternion(CubeGroup::instance()[static_cast<std::uint8_t>(random() % CubeGroup::kCount)]));
  const MatchedField field(kComplex, frames);
  const CutSolid cut(field);
  EXPECT_EQ(cut.sheets(), 0u);
  EXPECT_EQ(cut.copies(), kBox.mesh.vertices.size());
  expect_sound(cut);
}

TEST(CutSolid, CutsFromAnArcToTheSurface) {
  const auto frames = frames_at_centroids(kBox, TurningLine{{1.53, 1.54, 0}, {0, 0, 1}, {0, 0, 1}, 0.25});
  const MatchedField field(kComplex, frames);
  const CutSolid cut(field);
  EXPECT_GE(cut.sheets(), 1u);
  EXPECT_GT(cut.copies(), kBox.mesh.vertices.size());
  expect_sound(cut);
}

TEST(CutSolid, KeepsTheMatchingsOfAnyField) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const auto frames = random_tet_frames(kBox, seed);
    MatchedField field(kComplex, frames);
    turn_random_faces(field, 50, seed);
    const CutSolid cut(field);
    expect_sound(cut);
    for (std::uint32_t e = 0; e < kComplex.edges().size(); ++e) {
      if (kComplex.edges()[e].is_on_boundary()) continue;
      const SheetWord word = cut.word_around(e);
      EXPECT_EQ(cut.is_singular(e), field.is_singular(e));
      if (field.is_singular(e)) {
        EXPECT_FALSE(word.empty());
      }
    }
  }
}

TEST(SheetWords, LoseAStepThatIsTakenBack) {
  SheetWord word;
  for (const SheetStep step : {1, 0, 2, -2, 3}) add_step(word, step);
  EXPECT_EQ(word, (SheetWord{1, 3}));
}

}  // namespace
}  // namespace crossgrain
