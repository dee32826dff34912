// SPDX-License-Identifier: Apache-2.0
#include "map/untangling.hpp"

#include <gtest/gtest.h>

#include <random>

#include "crossgrain/thread_limit.hpp"
#include "map/poisson_map.hpp"
#include "matching/made_matchings.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

const TetSolid kBox = solid_of(TetBox{{4, 4, 4}}.mesh(0.1));
const TetComplex kComplex(kBox);
const std::vector<Quaternion> kFrames(kBox.mesh.tets.size(), Quaternion{1, 0, 0, 0});
const MatchedField kField(kComplex, kFrames);
const CutSolid kCut(kField);
const MapUnknowns kUnknowns(kCut);

Eigen::VectorXd shaken(const PoissonMap& poisson, double by) {
  Eigen::VectorXd columns = poisson.columns_for(poisson.relaxed());
  std::mt19937 random(9);
  std::uniform_real_distribution<double> uniform(-by, by);
  for (const std::uint32_t column : poisson.continuous()) columns[column] += uniform(random);
  return columns;
}

TEST(Untangling, TakesEveryFlipOutOfAShakenMapAndKeepsWhatIsFixed) {
  const MapEnergy energy(kUnknowns, 1);
  const PoissonMap poisson(energy);
  const Eigen::VectorXd columns = shaken(poisson, 1.5);
  EXPECT_GT(flips_of(energy, energy.basis() * columns).tets, 100u);
  const Untangled result = untangled(poisson, columns, IntegerColumns::kHeld);
  EXPECT_EQ(result.flips.tets, 0u);
  EXPECT_EQ(flips_of(energy, energy.basis() * result.columns).tets, 0u);
  for (const std::uint32_t column : poisson.integers()) EXPECT_EQ(result.columns[column], columns[column]);
}

TEST(Untangling, EndsSoonWhereNoMapIs) {
  // One side of the box falls onto the opposite one.
  const MapEnergy energy(kUnknowns, 1);
  const PoissonMap poisson(energy);
  const Untangled result =
      untangled(poisson, poisson.columns_for(Eigen::VectorXd::Zero(6)), IntegerColumns::kHeld);
  EXPECT_GT(result.flips.tets, 0u);
  EXPECT_LT(result.steps, 1000);
}

TEST(Untangling, NeverLeavesMoreFlipsThanItWasGiven) {
  const MapEnergy energy(kUnknowns, 1);
  const PoissonMap poisson(energy);
  UntanglingOptions options;
  options.rounds = 1;
  options.descent.steps = 1;
  for (const double shake : {0.2, 0.5, 1.0, 1.5, 3.0}) {
    const Eigen::VectorXd columns = shaken(poisson, shake);
    const std::size_t given = flips_of(energy, energy.basis() * columns).tets;
    for (const IntegerColumns integers : {IntegerColumns::kHeld, IntegerColumns::kFree}) {
      const Untangled result = untangled(poisson, columns, integers, options);
      EXPECT_LE(result.flips.tets, given) << shake;
      EXPECT_EQ(result.flips.tets, flips_of(energy, energy.basis() * result.columns).tets) << shake;
    }
  }
}

TEST(Untangling, IsTheSameToTheBitForAnyNumberOfThreads) {
  const MapEnergy energy(kUnknowns, 1);
  const PoissonMap poisson(energy);
  const auto on = [&](int threads) {
    const ThreadLimit limit(threads);
    return untangled(poisson, shaken(poisson, 1), IntegerColumns::kHeld).columns;
  };
  EXPECT_EQ(on(1), on(2));
}

}  // namespace
}  // namespace crossgrain
