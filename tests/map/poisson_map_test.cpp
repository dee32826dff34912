// SPDX-License-Identifier: Apache-2.0
#include "map/poisson_map.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "reduction/mapped_shapes.hpp"

namespace crossgrain {
namespace {

using testing::AskewBox;

TEST(PoissonMap, OfABoxIsTheBoxInHexahedra) {
  const AskewBox box({4, 3, 2});
  const MapEnergy energy(box.unknowns, 0.5);
  const PoissonMap poisson(energy);
  const Eigen::VectorXd columns = poisson.columns_for(poisson.relaxed());
  const MapCoordinates map = energy.basis() * columns;
  for (std::size_t t = 0; t < box.solid.mesh.tets.size(); ++t) {
    const Eigen::Matrix3d jacobian = energy.jacobian(map, t);
    EXPECT_NEAR((jacobian * jacobian.transpose() - Eigen::Matrix3d::Identity()).norm(), 0, 1e-7);
    EXPECT_NEAR(jacobian.determinant(), 1, 1e-7);
  }
  EXPECT_EQ(flips_of(energy, map).tets, 0u);
  EXPECT_EQ(poisson.integers().size(), 6u);
  EXPECT_EQ(std::count(poisson.is_pinned().begin(), poisson.is_pinned().end(), true), 3);
  for (const double integer : poisson.relaxed()) EXPECT_NEAR(integer, std::round(integer), 1e-6);
}

TEST(PoissonMap, HasTheLeastEnergyForItsIntegers) {
  const AskewBox box({3, 3, 3});
  const MapEnergy energy(box.unknowns, 1);
  const PoissonMap poisson(energy);
  const Eigen::VectorXd integers = Eigen::VectorXd::LinSpaced(6, -3, 7).array().round();
  const Eigen::VectorXd columns = poisson.columns_for(integers);
  const Eigen::VectorXd residual = energy.matrix() * columns - energy.right();
  for (const std::uint32_t column : poisson.continuous()) EXPECT_NEAR(residual[column], 0, 1e-8);
  // S is how the energy grows with the integers.
  const auto value = [&](const Eigen::VectorXd& x) {
    return x.dot(energy.matrix() * x) - 2 * x.dot(energy.right());
  };
  const Eigen::VectorXd off = integers - poisson.relaxed();
  const double grown = value(columns) - value(poisson.columns_for(poisson.relaxed()));
  EXPECT_NEAR(off.dot(poisson.schur() * off), grown, 1e-7 * std::abs(grown));
}

TEST(PoissonMap, MovesToOtherIntegersAsItWouldBeMadeForThem) {
  const AskewBox box({3, 2, 2});
  const MapEnergy energy(box.unknowns, 1);
  const PoissonMap poisson(energy);
  const Eigen::VectorXd one = Eigen::VectorXd::LinSpaced(6, 0, 5),
                        other = Eigen::VectorXd::LinSpaced(6, 4, -6);
  const Eigen::VectorXd moved = poisson.moved(poisson.columns_for(one), other);
  EXPECT_LT((moved - poisson.columns_for(other)).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(MapFlips, CountTetsThatAreInsideOut) {
  const AskewBox box({2, 2, 2});
  const MapEnergy energy(box.unknowns, 1);
  const PoissonMap poisson(energy);
  const MapCoordinates map = energy.basis() * poisson.columns_for(poisson.relaxed());
  const MapFlips flips = flips_of(energy, -map);
  EXPECT_EQ(flips.tets, box.solid.mesh.tets.size());
  EXPECT_NEAR(flips.share_of_volume, 1, 1e-12);
  EXPECT_NEAR(flips.least_determinant, -1, 1e-6);
}

}  // namespace
}  // namespace crossgrain
