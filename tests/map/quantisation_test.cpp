// SPDX-License-Identifier: Apache-2.0
#include "map/quantisation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "map/arced_cylinder.hpp"

namespace crossgrain {
namespace {

using testing::AskewBox;

/// The lengths of separations for these columns, ascending.
std::multiset<long> lengths(const Separations& separations, const Eigen::VectorXd& columns) {
  std::multiset<long> result;
  for (const LinearForm& form : separations) {
    double sum = 0;
    for (const auto& [column, factor] : form.terms) sum += static_cast<double>(factor) * columns[column];
    result.insert(std::lround(sum));
  }
  return result;
}

Separations separations_in(const PoissonMap& poisson) {
  const Eigen::VectorXd columns = poisson.columns_for(poisson.relaxed());
  return separations_of(poisson.energy().unknowns(), columns, poisson.energy().basis() * columns);
}

TEST(Separations, OfABoxAreItsThreeSides) {
  const AskewBox box({3, 2, 4});
  const MapEnergy energy(box.unknowns, 0.5);
  const PoissonMap poisson(energy);
  EXPECT_EQ(lengths(separations_in(poisson), poisson.columns_for(poisson.relaxed())),
            (std::multiset<long>{4, 6, 8}));
}

TEST(Separations, KeepTheArcsOfACylinderFromItsSurfaceAndFromEachOther) {
  const testing::ArcedCylinder cylinder;
  const MapEnergy energy(cylinder.unknowns, 0.1);
  const PoissonMap poisson(energy);
  const Separations separations = separations_in(poisson);
  EXPECT_GE(separations.size(), 4u);
  for (const long length : lengths(separations, poisson.columns_for(poisson.relaxed()))) EXPECT_GT(length, 0);
}

TEST(Quantisation, RoundsTheSidesOfABoxAndKeepsThemApart) {
  const AskewBox box({3, 3, 3}, {2.6 / 3, 1.4 / 3, 0.3 / 3});
  const MapEnergy energy(box.unknowns, 1);
  const PoissonMap poisson(energy);
  const Separations separations = separations_in(poisson);
  const Quantised free = quantised(poisson, poisson.relaxed(), {});
  EXPECT_EQ(lengths(separations, poisson.columns_for(free.integers)), (std::multiset<long>{0, 1, 3}));
  const Quantised apart = quantised(poisson, poisson.relaxed(), separations);
  EXPECT_EQ(lengths(separations, poisson.columns_for(apart.integers)), (std::multiset<long>{1, 1, 3}));
  EXPECT_EQ(apart.missing, 0);
  EXPECT_GT(apart.cost, free.cost);
}

TEST(Quantisation, FindsTheLeastCostAmongAllIntegersNearby) {
  const AskewBox box({2, 2, 2}, {0.7, 0.9, 1.3});
  const MapEnergy energy(box.unknowns, 1);
  const PoissonMap poisson(energy);
  const Quantised found = quantised(poisson, poisson.relaxed(), {});
  double least = INFINITY;
  // Every choice of the integers that are not pinned, within 2 of the relaxed ones.
  std::vector<Eigen::Index> free;
  for (std::size_t k = 0; k < poisson.is_pinned().size(); ++k)
    if (!poisson.is_pinned()[k]) free.push_back(static_cast<Eigen::Index>(k));
  ASSERT_EQ(free.size(), 3u);
  for (int choice = 0; choice < 5 * 5 * 5; ++choice) {
    Eigen::VectorXd integers = poisson.relaxed().array().round();
    integers[free[0]] += choice % 5 - 2;
    integers[free[1]] += choice / 5 % 5 - 2;
    integers[free[2]] += choice / 25 - 2;
    const Eigen::VectorXd off = integers - poisson.relaxed();
    least = std::min(least, off.dot(poisson.schur() * off));
  }
  EXPECT_NEAR(found.cost, least, 1e-9);
}

}  // namespace
}  // namespace crossgrain
