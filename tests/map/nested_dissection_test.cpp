// SPDX-License-Identifier: Apache-2.0
#include "map/nested_dissection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <thread>
#include <vector>

#include "grid_laplacian.hpp"

namespace crossgrain {
namespace {

TEST(NestedDissection, GivesEachRowAPlaceOfItsOwn) {
  const Eigen::SparseMatrix<double> matrix = laplacian_of_cubes(3, 5);
  std::vector<int> places = nested_dissection(matrix), all(places.size());
  std::iota(all.begin(), all.end(), 0);
  std::sort(places.begin(), places.end());
  EXPECT_EQ(places.size(), 375u);
  EXPECT_EQ(places, all);
}

TEST(NestedDissection, IsTheSameWithOthersAtTheSameTime) {
  const Eigen::SparseMatrix<double> one = laplacian_of_cubes(1, 14), other = laplacian_of_cubes(2, 11);
  const std::vector<int> expected = nested_dissection(one);
  for (int k = 0; k < 5; ++k) {
    std::thread beside([&] { nested_dissection(other); });
    EXPECT_EQ(nested_dissection(one), expected);
    beside.join();
  }
}

}  // namespace
}  // namespace crossgrain
