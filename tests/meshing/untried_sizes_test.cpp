// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_report.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "meshing/hexahedra_of_models.hpp"

namespace crossgrain {
namespace {

/// Attempts at tets of these sizes, with other attempts between.
std::vector<HexAttempt> attempts_at(const std::vector<double>& sizes) {
  std::vector<HexAttempt> attempts;
  for (const double size : sizes) {
    attempts.emplace_back().tet_size = size;
    attempts.emplace_back();
  }
  return attempts;
}

TEST(UntriedTetSize, LeadsToNoSizeThatWasTried) {
  for (const double first : {0.03, 1.0, 4.2, 13.3, 700.0}) {
    std::vector<double> tried;
    const std::vector<double> shares = MeshingTuning().tet_shares;
    for (const double share : shares) tried.push_back(share * first);
    const double next = untried_tet_size(attempts_at(tried));
    for (const double share : shares)
      for (const double size : tried)
        EXPECT_GT(std::abs(share * next / size - 1), 0.005) << next << ", " << size;
  }
}

TEST(UntriedTetSize, IsNoneOfTetsThatWereGiven) {
  EXPECT_EQ(untried_tet_size(attempts_at({0, 0})), 0);
}

}  // namespace
}  // namespace crossgrain
