// SPDX-License-Identifier: Apache-2.0
#include "harmonics/evaluation.hpp"

#include "harmonics/random_samples.hpp"
#include "harmonics/rotation.hpp"
#include "harmonics/sphere_quadrature.hpp"

namespace crossgrain {
namespace {

template <class Degree>
class Evaluation : public ::testing::Test {};
TYPED_TEST_SUITE(Evaluation, testing::BothDegrees);

TYPED_TEST(Evaluation, HarmonicsAreOrthonormalOnTheSphere) {
  constexpr int D = TypeParam::value;
  std::array<Coefficients<D>, kCoefficientCount<D>> gram{};
  for (const auto& [direction, weight] : sphere_quadrature<2 * D>()) {
    const auto y = evaluate_harmonics<D>(direction);
    for (int row = 0; row < kCoefficientCount<D>; ++row) {
      add_scaled(gram[row], 4 * std::numbers::pi * weight * y[row], y);
    }
  }
  for (int row = 0; row < kCoefficientCount<D>; ++row) {
    for (int column = 0; column < kCoefficientCount<D>; ++column) {
      EXPECT_NEAR(gram[row][column], row == column ? 1 : 0, 1e-14);
    }
  }
}

TYPED_TEST(Evaluation, ValuesAreHomogeneousOfTheirDegree) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(1);
  const Vector3 p = random.vector();
  const auto expected = scaled(evaluate_harmonics<D>(p), std::pow(-2.0, D));
  EXPECT_LT(testing::largest_difference(evaluate_harmonics<D>(-2.0 * p), expected), 1e-12);
}

TYPED_TEST(Evaluation, SquaresSumToTheAdditionTheorem) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(2);
  for (int i = 0; i < 100; ++i) {
    EXPECT_NEAR(squared_norm(evaluate_harmonics<D>(random.direction())), (2 * D + 1) / (4 * std::numbers::pi),
                1e-14);
  }
}

TYPED_TEST(Evaluation, PolynomialsAreHarmonic) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(3);
  const Vector3 p = random.vector();
  const double step =
      1e-3;  // second differences of quartics err by step^2 (about 1e-5), of rounding by 1e-10
  auto laplacian = scaled(evaluate_harmonics<D>(p), -6);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Vector3 q = p;
      q[axis] += sign * step;
      add_scaled(laplacian, 1, evaluate_harmonics<D>(q));
    }
  }
  for (const double entry : laplacian) EXPECT_NEAR(entry / (step * step), 0, 1e-4);
}

TEST(EvaluationByName, OrdersAreTheOnesOfThePolynomialsByName) {
  // At (1, 1, 1): x y z = 1; at x-hat, order 3 is sqrt(35 / (32 pi)) x^3 and order 1 is -sqrt(21 / (32 pi))
  // x^3.
  EXPECT_NEAR(evaluate_harmonics<3>({1, 1, 1})[index_of_order<3>(-2)],
              0.5 * std::sqrt(105 / std::numbers::pi), 1e-14);
  EXPECT_NEAR(evaluate_harmonics<3>({1, 0, 0})[index_of_order<3>(3)], std::sqrt(35 / (32 * std::numbers::pi)),
              1e-15);
  EXPECT_NEAR(evaluate_harmonics<3>({1, 0, 0})[index_of_order<3>(1)],
              -std::sqrt(21 / (32 * std::numbers::pi)), 1e-15);
  EXPECT_NEAR(evaluate_harmonics<4>({1, 0, 0})[index_of_order<4>(4)],
              3.0 / 16 * std::sqrt(35 / std::numbers::pi), 1e-15);
  EXPECT_NEAR(evaluate_harmonics<4>({0, 0, 1})[index_of_order<4>(0)], 1.5 / std::sqrt(std::numbers::pi),
              1e-15);
}

}  // namespace
}  // namespace crossgrain
