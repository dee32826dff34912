// SPDX-License-Identifier: Apache-2.0
#include "map/descent.hpp"

#include <gtest/gtest.h>

#include "map/foldover.hpp"

namespace crossgrain {
namespace {

void keep(const Eigen::VectorXd& gradient, Eigen::VectorXd& result) {
  result = gradient;
}

TEST(Descent, FindsTheMinimumOfRosenbrocksValley) {
  const auto valley = [](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
    const double across = x[1] - x[0] * x[0], along = 1 - x[0];
    gradient.resize(2);
    gradient << -400 * x[0] * across - 2 * along, 200 * across;
    return 100 * across * across + along * along;
  };
  const Descent found =
      minimised(valley, keep, Eigen::Vector2d(-1.2, 1), {.steps = 200, .least_gain = 1e-14});
  EXPECT_NEAR(found.x[0], 1, 1e-4);
  EXPECT_NEAR(found.x[1], 1, 1e-4);
  EXPECT_NEAR(found.first_value, 24.2, 1e-12);
}

TEST(Descent, StaysWhereTheGradientVanishes) {
  const auto flat = [](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
    gradient = Eigen::VectorXd::Zero(x.size());
    return 3.0;
  };
  const Descent found = minimised(flat, keep, Eigen::Vector3d(1, 2, 3), {});
  EXPECT_EQ(found.value, 3);
  EXPECT_EQ(found.x, Eigen::Vector3d(1, 2, 3));
}

TEST(Foldover, MeasureIsPositiveAndTheDeterminantWithoutEpsilon) {
  EXPECT_NEAR(regularised(2, 1e-9).chi, 2, 1e-12);
  EXPECT_NEAR(regularised(-3, 4).chi, 1, 1e-12);
  EXPECT_GT(regularised(-1e6, 1e-3).chi, 0);
  const double step = 1e-6;
  for (const double d : {-2.0, -0.1, 0.0, 0.3, 5.0})
    EXPECT_NEAR(regularised(d, 0.5).slope,
                (regularised(d + step, 0.5).chi - regularised(d - step, 0.5).chi) / (2 * step), 1e-8);
}

}  // namespace
}  // namespace crossgrain
