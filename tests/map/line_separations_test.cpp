// SPDX-License-Identifier: Apache-2.0
#include "map/line_separations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "map/arced_cylinder.hpp"
#include "map/poisson_map.hpp"

namespace crossgrain {
namespace {

struct RelaxedMap {
  MapEnergy energy;
  PoissonMap poisson{energy};
  Eigen::VectorXd columns = poisson.columns_for(poisson.relaxed());
  MapCoordinates coordinates = energy.basis() * columns;

  RelaxedMap(const MapUnknowns& unknowns, double size) : energy(unknowns, size) {}

  std::vector<double> values(const Separations& forms) const {
    std::vector<double> values;
    for (const LinearForm& form : forms) {
      values.push_back(0);
      for (const auto& [column, factor] : form.terms)
        values.back() += static_cast<double>(factor) * columns[column];
    }
    return values;
  }
};

TEST(LineLengths, OfABoxAreTheLengthsOfItsEdges) {
  const testing::AskewBox box({3, 2, 4});
  const RelaxedMap map(box.unknowns, 0.5);
  std::multiset<long> lengths;
  for (const double value : map.values(line_lengths(box.unknowns, map.columns)))
    lengths.insert(std::lround(value));
  EXPECT_EQ(lengths, (std::multiset<long>{4, 4, 4, 4, 6, 6, 6, 6, 8, 8, 8, 8}));
}

TEST(LineLengths, OfArcsAreTheHeightOfTheCylinder) {
  const testing::ArcedCylinder cylinder;
  const RelaxedMap map(cylinder.unknowns, 0.1);
  int of_height = 0;
  for (const double value : map.values(line_lengths(cylinder.unknowns, map.columns))) {
    EXPECT_GT(value, 0);
    of_height += std::abs(value - 20) < 1;
  }
  EXPECT_GE(of_height, 4);
}

TEST(LineGaps, AreBetweenLinesThatAreNearEachOtherOnly) {
  const testing::AskewBox box({3, 2, 4});
  const RelaxedMap fine(box.unknowns, 0.1), coarse(box.unknowns, 2);
  EXPECT_TRUE(line_gaps(box.unknowns, fine.columns, fine.coordinates).empty());
  const Separations gaps = line_gaps(box.unknowns, coarse.columns, coarse.coordinates);
  EXPECT_FALSE(gaps.empty());
  // Edges that are side by side, 2 and 3 apart in hexahedra of 2.
  for (const double value : coarse.values(gaps))
    EXPECT_TRUE(std::abs(value - 1) < 1e-6 || std::abs(value - 1.5) < 1e-6) << value;
}

}  // namespace
}  // namespace crossgrain
