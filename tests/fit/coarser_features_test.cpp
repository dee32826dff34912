// SPDX-License-Identifier: Apache-2.0
#include "fit/coarser_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "fit/hex_lattice.hpp"
#include "fit/lattice_features.hpp"

namespace crossgrain {
namespace {

/// A block with a hole through it, whose quads have random numbers.
FeatureComplex chequered(unsigned seed) {
  const HexMesh mesh =
      testing::lattice_mesh({5, 5, 3}, [](int x, int y, int) { return x == 2 && y == 2 ? 0 : 1; });
  std::mt19937 random(seed);
  std::vector<int> numbers(1000);
  for (int& number : numbers) number = static_cast<int>(random() % 3);
  return testing::features_of(mesh, [&](std::uint32_t q) { return numbers[q]; });
}

TEST(CoarserFeatures, WithAllCurvesAreTheSame) {
  const FeatureComplex fine = chequered(1);
  const CoarserFeatures same = without_curves(fine, std::vector<bool>(fine.curves.size(), false));
  ASSERT_EQ(same.complex.curves.size(), fine.curves.size());
  ASSERT_EQ(same.complex.corners.size(), fine.corners.size());
  ASSERT_EQ(same.complex.faces.size(), fine.faces.size());
  for (std::size_t f = 0; f < fine.faces.size(); ++f) {
    EXPECT_EQ(same.complex.faces[f].euler, fine.faces[f].euler);
    EXPECT_EQ(same.complex.faces[f].loops, fine.faces[f].loops);
    EXPECT_EQ(same.complex.faces[f].triangles, fine.faces[f].triangles);
  }
}

TEST(CoarserFeatures, WithoutSoftCurvesAreThoseOfTheSurfaceWithoutFaces) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const FeatureComplex fine = chequered(seed);
    std::vector<bool> is_soft;
    for (const auto& curve : fine.curves) is_soft.push_back(curve.is_soft);
    const FeatureComplex coarse = without_curves(fine, is_soft).complex;
    const HexMesh mesh =
        testing::lattice_mesh({5, 5, 3}, [](int x, int y, int) { return x == 2 && y == 2 ? 0 : 1; });
    const FeatureComplex plain = testing::features_of(mesh, [](std::uint32_t) { return 0; });
    ASSERT_EQ(coarse.corners.size(), plain.corners.size());
    ASSERT_EQ(coarse.curves.size(), plain.curves.size());
    ASSERT_EQ(coarse.faces.size(), plain.faces.size());
    for (std::size_t f = 0; f < coarse.faces.size(); ++f) {
      const auto found =
          std::ranges::find(plain.faces, coarse.faces[f].triangles, &FeatureComplex::Face::triangles);
      ASSERT_NE(found, plain.faces.end());
      EXPECT_EQ(coarse.faces[f].euler, found->euler);
      EXPECT_EQ(coarse.faces[f].loops, found->loops);
    }
    for (std::size_t c = 0; c < coarse.corners.size(); ++c) {
      EXPECT_EQ(coarse.corners[c].vertex, plain.corners[c].vertex);
      EXPECT_EQ(coarse.corners[c].sectors.size(), plain.corners[c].sectors.size());
    }
  }
}

TEST(CoarserFeatures, HaveTheSameEulerNumberAltogether) {
  std::mt19937 random(2);
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const FeatureComplex fine = chequered(seed);
    std::vector<bool> is_left_out;
    for (std::size_t c = 0; c < fine.curves.size(); ++c) is_left_out.push_back(random() % 2 == 0);
    const FeatureComplex coarse = without_curves(fine, is_left_out).complex;
    int euler = 0;
    for (const auto& face : coarse.faces) euler += face.euler;
    for (const auto& curve : coarse.curves) euler -= curve.corners[0] != FeatureComplex::kNone;
    // Of a torus; faces are counted without their borders, which have the Euler number 0.
    EXPECT_EQ(euler + static_cast<int>(coarse.corners.size()), 0);
  }
}

}  // namespace
}  // namespace crossgrain
